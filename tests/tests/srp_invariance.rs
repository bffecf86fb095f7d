//! Precomputation of sparse radiance probes does not depend on a scene's unit or place.

use glam::Vec3;
use interreflect::methods::srp::{BakeOptions, Plan};
use interreflect::scene::{Scene, built_in};

fn moved(scene: &Scene, scale: f32, offset: Vec3) -> Scene {
    let mut out = scene.clone();
    out.positions.iter_mut().for_each(|p| *p = *p * scale + offset);
    out.cameras.iter_mut().for_each(|c| c.position = c.position * scale + offset);
    out.recentre();
    out
}

/// What is decided about a scene is decided alike about the same scene in other units and elsewhere: charts, texels, open air,
/// probes, clusters, what rays meet.
#[test]
fn scale_and_place_change_no_decision() {
    let options = BakeOptions { receivers: 1024, rays: 64, relight_rays: 512, ..BakeOptions::default() };
    let box_10 = moved(&built_in::cornell_box(), 10.0, Vec3::ZERO);
    let a = Plan::new(&box_10, &options).unwrap();
    let before = a.bake().0;
    for (scale, distance) in [(1e-4, 0.0), (0.1, 0.0), (1e3, 0.0), (1.0, 10.0), (1.0, 1e3)] {
        let offset = Vec3::new(0.6, 0.0, 0.8) * distance;
        let scene = moved(&box_10, scale, offset);
        let b = Plan::new(&scene, &options).unwrap();
        let at = format!("scale {scale}, {distance} m away");
        assert_eq!(a.atlas.charts.chart, b.atlas.charts.chart, "{at}");
        assert_eq!(a.reach.exposed, b.reach.exposed, "{at}");
        let texels =
            |p: &Plan<'_>| -> Vec<[u32; 2]> { p.receivers.iter().map(|r| p.atlas.texels[r.1 as usize].at).collect() };
        assert_eq!(texels(&a), texels(&b), "{at}");
        let open = |p: &Plan<'_>| p.reach.space.open.iter().filter(|o| **o).count();
        let opened = a.reach.space.open.iter().zip(&b.reach.space.open).filter(|(x, y)| x != y).count();
        assert!(opened * 10_000 <= open(&a), "{opened} of {} voxels, {at}", open(&a));
        assert_eq!(a.clusters, b.clusters, "{at}");
        assert_eq!(a.probes.len(), b.probes.len(), "{at}");
        let back = |p: Vec3| ((scene.world(p) - offset.as_dvec3()) / f64::from(scale)).as_vec3();
        let moved = a.probes.iter().zip(&b.probes).map(|(p, q)| (*p - back(*q)).length()).fold(0.0, f32::max);
        assert!(moved < 1e-3, "{moved} m of 5.5 m, {at}");
        assert!((b.radius / scale / a.radius - 1.0).abs() < 1e-3, "{at}");
        let after = b.bake().0;
        let other = before.ray_hits.iter().zip(&after.ray_hits).filter(|(x, y)| x != y).count();
        assert!(other * 1000 <= before.ray_hits.len(), "{other} of {} rays, {at}", before.ray_hits.len());
    }
}

/// A box that stands on the floor is not opened by the one walk in a million that slips under its edge, wherever it stands.
#[test]
fn cracks_open_no_boxes() {
    let base = moved(&built_in::cornell_box(), 10.0, Vec3::ZERO);
    let options =
        BakeOptions { receivers: 256, rays: 16, relight_rays: 16, added_probes: 0.0, ..BakeOptions::default() };
    for k in 0..12 {
        let scene = moved(&base, 1.0, Vec3::new(10.0 + k as f32, 0.0, 3.0 * k as f32));
        let plan = Plan::new(&scene, &BakeOptions { seed: 1 + k, ..options.clone() }).unwrap();
        // The lamp's, half a millimetre below the ceiling, is open.
        let backs = plan.reach.exposed.iter().filter(|e| e[1]).count();
        assert!(backs <= 1, "{backs} backs at place {k}");
    }
}
