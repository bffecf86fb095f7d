//! The scene that figures of whole scenes are taken on: Crytek Sponza beside the checkout, or the built-in colonnade.

use crate::workspace;
use anyhow::Result;
use interreflect::scene::{Camera, LoadOptions, Scene, load};
use std::path::PathBuf;

/// Camera of Sponza's atrium view.
const SPONZA_VIEW: &str = "-11.5,1.7,-0.4,0,2.6,0,46.7";

/// File of the larger scene, where it is there.
pub fn sponza() -> Option<PathBuf> {
    let path = workspace::root().join("../shared/scenes/crytek_sponza.glb");
    path.is_file().then_some(path)
}

/// Name, scene and camera.
pub fn measured() -> Result<(String, Scene, Camera)> {
    let (spec, view) = match sponza() {
        Some(path) => (path.display().to_string(), Some(SPONZA_VIEW)),
        None => ("colonnade".to_string(), None),
    };
    let scene = load(&spec, &LoadOptions { camera: view.map(str::to_owned), ..LoadOptions::default() })?;
    let camera = scene.camera(view)?;
    Ok((scene.name.clone(), scene, camera))
}

/// The same as arguments of the program.
pub fn arguments() -> Vec<String> {
    match sponza() {
        Some(path) => {
            let sun = "--sun=0.12,-1,0.3,30,28.5,26".to_string();
            let camera = format!("--camera={SPONZA_VIEW}");
            vec![path.display().to_string(), camera, sun, "--env=1.2,1.5,2.0".into()]
        }
        None => vec!["colonnade".into()],
    }
}
