//! A real scene under sparse radiance probes: nearly every receiver sees one.

use interreflect::methods::srp::{BakeOptions, Plan};

/// Fifty probes leave a quarter of the receivers of Sponza, in its arcades and behind its curtains, without one. As many are added as
/// it takes to keep the bound, which is more than as many again and less than the default's limit.
#[test]
fn probes_are_added_until_sponza_is_seen() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/scenes/crytek_sponza.glb");
    if !std::path::Path::new(path).exists() {
        println!("skipped: no {path}");
        return;
    }
    let scene = interreflect::scene::load(path, &Default::default()).expect("the scene loads");
    let options =
        BakeOptions { receivers: 20_000, probes: 50, rays: 16, relight_rays: 64, ridge: 0.0, ..BakeOptions::default() };
    let coverage = Plan::new(&scene, &options).expect("the scene can be planned").coverage;
    println!("{coverage:?}");
    assert!(coverage.unseen_before > 0.1, "{coverage:?}");
    assert!(coverage.unseen <= options.unseen_bound && coverage.added < coverage.limit, "{coverage:?}");
    assert!(coverage.added > 50, "{coverage:?}");
    assert!(coverage.unseen_in_gaps < 0.05, "{coverage:?}");
}
