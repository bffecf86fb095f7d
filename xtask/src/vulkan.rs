//! Sees to a Vulkan driver: tests of the device's side need one, and software is enough.

use crate::workspace;
use anyhow::{Result, bail};
use std::path::Path;
use std::process::Command;

/// Packages of Debian and its kin: Mesa's software driver, and spirv-val.
const PACKAGES: &[&str] = &["mesa-vulkan-drivers", "spirv-tools"];

/// Makes sure that wgpu finds a Vulkan adapter: installs Mesa's software driver where there is none and it may.
pub fn ensure_driver() -> Result<()> {
    if let Some(name) = adapter() {
        println!("Vulkan adapter: {name}");
        if workspace::on_path("spirv-val").is_none() && may_install() {
            // The tests do without it; the check of the kernels is weaker.
            install(&["spirv-tools"]).unwrap_or_else(|error| eprintln!("warning: spirv-val: {error:#}"));
        }
        return Ok(());
    }
    if !may_install() {
        bail!(
            "no Vulkan adapter. Install a driver: Debian, Ubuntu: apt-get install mesa-vulkan-drivers; \
             Fedora: dnf install mesa-vulkan-drivers; macOS: brew install molten-vk; Windows: the graphics card's driver"
        );
    }
    println!("no Vulkan adapter: installing {}", PACKAGES.join(" "));
    install(PACKAGES)?;
    match adapter() {
        Some(name) => println!("Vulkan adapter: {name}"),
        None => bail!("{} did not bring a Vulkan adapter", PACKAGES[0]),
    }
    Ok(())
}

/// The first Vulkan adapter.
fn adapter() -> Option<String> {
    let descriptor = wgpu::InstanceDescriptor {
        backends: wgpu::Backends::VULKAN,
        ..wgpu::InstanceDescriptor::new_without_display_handle()
    };
    let adapters = pollster::block_on(wgpu::Instance::new(descriptor).enumerate_adapters(wgpu::Backends::VULKAN));
    adapters.first().map(|adapter| {
        let info = adapter.get_info();
        format!("{} ({} {})", info.name, info.driver, info.driver_info)
    })
}

/// Whether packages can be installed without asking anybody: apt-get there, and the superuser.
pub fn may_install() -> bool {
    let root = Command::new("id").arg("-u").output().is_ok_and(|out| out.stdout.trim_ascii() == b"0");
    root && Path::new("/etc/debian_version").exists() && workspace::on_path("apt-get").is_some()
}

/// Installs Debian packages.
pub fn install(packages: &[&str]) -> Result<()> {
    let run = |args: &[&str]| -> Result<()> {
        let status = Command::new("apt-get").args(args).env("DEBIAN_FRONTEND", "noninteractive").status()?;
        if !status.success() {
            bail!("apt-get {}: {status}", args.join(" "));
        }
        Ok(())
    };
    run(&["update", "-qq"])?;
    run(&[&["install", "-y", "-qq", "--no-install-recommends"], packages].concat())
}
