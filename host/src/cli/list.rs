//! `methods`, `scenes`, `devices`.

use super::print_json;
use crate::error::Error;
use crate::exec::{CpuExecutor, Executor, list_devices};
use crate::methods::METHODS;
use crate::scene::BUILT_IN;
use serde_json::json;

/// Lists the methods with their settings.
pub fn methods(as_json: bool) -> Result<(), Error> {
    if as_json {
        let rows: Vec<_> = METHODS
            .iter()
            .map(|m| {
                let ladder: Vec<_> =
                    m.ladder.iter().map(|(name, changes)| json!({ "name": name, "set": changes })).collect();
                json!({ "name": m.name, "summary": m.summary, "good_when": m.good_when, "fails_when": m.fails_when,
                        "settings": m.settings, "ladder": ladder })
            })
            .collect();
        print_json(&rows);
        return Ok(());
    }
    for m in METHODS {
        say!("{}\n  {}\n  good when:  {}\n  fails when: {}", m.name, m.summary, m.good_when, m.fails_when);
        for s in m.settings {
            say!("  --set {}={}  ({})\n      {}", s.key, s.default, s.allowed, s.help);
        }
        say!("");
    }
    Ok(())
}

/// Lists the built-in scenes.
pub fn scenes(as_json: bool) -> Result<(), Error> {
    let rows: Vec<_> = BUILT_IN.iter().map(|b| (b, (b.make)().stats())).collect();
    if as_json {
        let rows: Vec<_> =
            rows.iter().map(|(b, stats)| json!({ "name": b.name, "summary": b.summary, "stats": stats })).collect();
        print_json(&rows);
        return Ok(());
    }
    for (b, stats) in rows {
        say!("{:<16} {:>7} triangles, {:>3} lights  {}", b.name, stats.triangle_count, stats.light_count, b.summary);
    }
    Ok(())
}

/// Lists what kernels can run on.
pub fn devices(as_json: bool) -> Result<(), Error> {
    let (cpu, adapters) = (CpuExecutor::new().device(), list_devices());
    if as_json {
        print_json(&json!({ "cpu": cpu, "adapters": adapters }));
        return Ok(());
    }
    say!("cpu  {} ({})", cpu.cpu, cpu.driver);
    if adapters.is_empty() {
        say!("gpu  none: no Vulkan, Metal or DirectX 12 adapter was found");
    }
    for a in adapters {
        say!(
            "gpu  {} ({:?}, {}, {}): SPIR-V {}, {} timestamps, bindings up to {} MiB",
            a.name,
            a.kind,
            a.interface,
            a.driver,
            if a.spirv_passthrough { "as it is or through naga" } else { "through naga" },
            if a.timestamps { "with" } else { "no" },
            a.max_binding_bytes >> 20
        );
    }
    Ok(())
}
