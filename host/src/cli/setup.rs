//! What the verbs share: the scene, the camera, the executor, the truth, the output folder.

use super::args::{DeviceArgs, SceneArgs, TruthArgs};
use super::progress::TruthBar;
use crate::error::Error;
use crate::exec::{self, Executor};
use crate::reference::trace::KeptTree;
use crate::reference::{self, IrradianceTruth, Receiver, ReferenceSettings, Truth};
use crate::scene::{self, Camera, LoadOptions, Scene};
use std::path::Path;

/// The scene and the camera of a command; says on standard error what was simplified at import.
pub fn load(args: &SceneArgs) -> Result<(Scene, Camera), Error> {
    let options =
        LoadOptions { camera: args.camera.clone(), environment: args.env, sun: args.sun, ..LoadOptions::default() };
    let scene = scene::load(&args.scene, &options)?;
    for note in &scene.notes {
        eprintln!("note: {note}");
    }
    let camera = scene.camera(args.camera.as_deref())?;
    Ok((scene, camera))
}

/// The executor of a command; warnings go to standard error.
pub fn executor(args: &DeviceArgs) -> Result<Box<dyn Executor>, Error> {
    Ok(exec::open_adapter(args.backend, args.adapter.as_deref(), &mut |warning| eprintln!("warning: {warning}"))?)
}

/// Makes the output folder before anything is computed, so that a wrong one is noticed at once.
pub fn output_folder(path: &Path) -> Result<(), Error> {
    let fail = |source| Error::OutputFolder { path: path.to_path_buf(), source };
    std::fs::create_dir_all(path).map_err(fail)?;
    // A folder can exist and refuse files.
    tempfile::tempfile_in(path).map_err(fail).map(drop)
}

/// Settings of a truth, with this noise where the user names neither noise nor samples.
pub fn truth_settings(args: &TruthArgs, seed: u32, default_noise: f64) -> ReferenceSettings {
    let noise = if args.spp.is_none() { Some(args.noise.unwrap_or(default_noise)) } else { args.noise };
    ReferenceSettings { noise, spp: args.spp, seed, max_bounces: args.max_bounces }
}

/// The truth's picture, from the cache where it is there.
pub fn truth_picture(
    args: &SceneArgs,
    scene: &Scene,
    camera: &Camera,
    settings: &ReferenceSettings,
) -> Result<Truth, Error> {
    let bar = TruthBar::new("truth");
    let (width, height) = args.size;
    let folder = args.cache.clone().unwrap_or_else(reference::default_dir);
    Ok(reference::cached(&folder, scene, camera, width, height, settings, &mut |p| bar.update(p))?.truth)
}

/// The truth's irradiance at receivers, from the cache where it is there.
pub fn truth_irradiance(
    args: &SceneArgs,
    scene: &Scene,
    receivers: &[Receiver],
    settings: &ReferenceSettings,
) -> Result<IrradianceTruth, Error> {
    let bar = TruthBar::new("irradiance");
    let tree = KeptTree::default();
    let folder = args.cache.clone().unwrap_or_else(reference::default_dir);
    Ok(reference::cached_irradiance(&folder, &tree, scene, receivers, settings, &mut |p| bar.update(p))?.truth)
}

/// The path of this program, to start it again.
pub fn program() -> Result<std::path::PathBuf, Error> {
    std::env::current_exe().map_err(|e| Error::Usage(format!("cannot find this program's own file: {e}")))
}
