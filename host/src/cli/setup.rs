//! What the verbs share: the scene, the camera, the executor, the truth, the output folder.

use super::args::{DeviceArgs, SceneArgs, TruthArgs};
use super::progress::TruthBar;
use crate::error::Error;
use crate::exec::{self, Executor};
use crate::reference::trace::KeptTree;
use crate::reference::{self, IrradianceTruth, Receiver, ReferenceSettings, Truth};
use crate::scene::{self, Camera, LoadOptions, Scene};
use std::path::{Path, PathBuf};

/// The scene and the camera of a command; says on standard error what was simplified at import.
pub fn load(args: &SceneArgs) -> Result<(Scene, Camera), Error> {
    let options =
        LoadOptions { camera: args.camera.clone(), environment: args.env, sun: args.sun, ..LoadOptions::default() };
    let scene = scene::load(&args.scene, &options)?;
    for note in &scene.notes {
        tell!("note: {note}");
    }
    let camera = scene.camera(args.camera.as_deref())?;
    Ok((scene, camera))
}

/// The executor of a command; warnings go to standard error.
pub fn executor(args: &DeviceArgs) -> Result<Box<dyn Executor>, Error> {
    Ok(exec::open_adapter(args.backend, args.adapter.as_deref(), &mut |warning| tell!("warning: {warning}"))?)
}

/// Folders that a command made: a command that fails before it writes anything leaves none of them behind.
pub struct OutputFolder(Vec<PathBuf>);

impl Drop for OutputFolder {
    fn drop(&mut self) {
        for made in &self.0 {
            // Refused where something is in it, which is then to stay.
            let _ = std::fs::remove_dir(made);
        }
    }
}

/// Makes the output folder before anything is computed, so that a wrong one is noticed at once.
pub fn output_folder(path: &Path) -> Result<OutputFolder, Error> {
    let fail = |source| Error::OutputFolder { path: path.to_path_buf(), source };
    let missing = path.ancestors().take_while(|p| !p.as_os_str().is_empty() && !p.exists()).map(Path::to_owned);
    let made = OutputFolder(missing.collect());
    std::fs::create_dir_all(path).map_err(fail)?;
    // A folder can exist and refuse files.
    tempfile::tempfile_in(path).map_err(fail)?;
    Ok(made)
}

/// Settings of a truth, with this noise where the user names neither noise nor samples.
pub fn truth_settings(args: &TruthArgs, seed: u32, default_noise: f64) -> ReferenceSettings {
    let noise = if args.spp.is_none() { Some(args.noise.unwrap_or(default_noise)) } else { args.noise };
    ReferenceSettings { noise, spp: args.spp, seed, max_bounces: args.max_bounces }
}

/// The truth of a command's scene, from the cache where it is there. Its tree is built once.
pub struct Truths<'a> {
    args: &'a SceneArgs,
    scene: &'a Scene,
    settings: ReferenceSettings,
    tree: KeptTree,
}

impl<'a> Truths<'a> {
    /// Of a scene, by these settings; nothing is traced yet.
    pub fn new(args: &'a SceneArgs, scene: &'a Scene, settings: ReferenceSettings) -> Self {
        Self { args, scene, settings, tree: KeptTree::default() }
    }

    /// The picture of a camera.
    pub fn picture(&self, camera: &Camera) -> Result<Truth, Error> {
        let (bar, args) = (TruthBar::new("truth"), self.args);
        let progress = &mut |p| bar.update(p);
        let folder = cache_folder(self.args);
        Ok(reference::cached(&folder, &self.tree, self.scene, camera, args.size, &self.settings, progress)?.truth)
    }

    /// Irradiance at receivers.
    pub fn irradiance(&self, receivers: &[Receiver]) -> Result<IrradianceTruth, Error> {
        let bar = TruthBar::new("irradiance");
        let progress = &mut |p| bar.update(p);
        let folder = cache_folder(self.args);
        Ok(reference::cached_irradiance(&folder, &self.tree, self.scene, receivers, &self.settings, progress)?.truth)
    }
}

/// Where truths are kept.
pub fn cache_folder(args: &SceneArgs) -> PathBuf {
    args.cache.clone().unwrap_or_else(reference::default_dir)
}

/// The path of this program, to start it again.
pub fn program() -> Result<PathBuf, Error> {
    std::env::current_exe().map_err(|e| Error::Usage(format!("cannot find this program's own file: {e}")))
}
