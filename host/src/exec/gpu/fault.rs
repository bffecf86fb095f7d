//! What a device reports: creation errors caught in scopes, everything else and the loss of the device by callback.

use crate::exec::ExecError;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

#[derive(Default)]
struct Reported {
    lost: Option<String>,
    error: Option<wgpu::Error>,
}

/// Errors that no call returned. Without it wgpu panics on the first one.
#[derive(Clone, Default)]
pub(super) struct Faults(Arc<Mutex<Reported>>);

impl Faults {
    /// Takes over a device's reports.
    pub(super) fn watch(device: &wgpu::Device) -> Self {
        let faults = Self::default();
        let on_loss = faults.clone();
        device.set_device_lost_callback(move |reason, message| {
            let message = if message.is_empty() { format!("{reason:?}") } else { message };
            on_loss.lock().lost = Some(message);
        });
        let on_error = faults.clone();
        device.on_uncaptured_error(Arc::new(move |error| {
            // The first error is the cause; those after it are its consequences.
            on_error.lock().error.get_or_insert(error);
        }));
        faults
    }

    fn lock(&self) -> MutexGuard<'_, Reported> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What was reported since the last check. A lost device stays lost; another error is told once.
    pub(super) fn check(&self, during: &str) -> Result<(), ExecError> {
        let mut reported = self.lock();
        if let Some(reason) = &reported.lost {
            return Err(ExecError::DeviceLost { during: during.into(), reason: reason.clone() });
        }
        match reported.error.take() {
            None => Ok(()),
            Some(wgpu::Error::OutOfMemory { .. }) => {
                Err(ExecError::OutOfMemory { label: during.into(), bytes: 0, reason: NO_MEMORY.into() })
            }
            Some(error) => Err(ExecError::Device { during: during.into(), reason: one_line(&error.to_string()) }),
        }
    }

    /// Records a loss that wgpu told in another way than by its callback.
    pub(super) fn lose(&self, reason: String) {
        self.lock().lost.get_or_insert(reason);
    }
}

pub(super) const NO_MEMORY: &str = "the device has no such block of memory left";

/// Runs `work` and gives the first error that it caused on this thread.
pub(super) fn scoped<T>(device: &wgpu::Device, work: impl FnOnce() -> T) -> Result<T, wgpu::Error> {
    let internal = device.push_error_scope(wgpu::ErrorFilter::Internal);
    let memory = device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
    let validation = device.push_error_scope(wgpu::ErrorFilter::Validation);
    let result = work();
    let errors = [validation.pop().block(), memory.pop().block(), internal.pop().block()];
    errors.into_iter().flatten().next().map_or(Ok(result), Err)
}

trait Block: Future + Sized {
    fn block(self) -> Self::Output {
        pollster::block_on(self)
    }
}
impl<F: Future> Block for F {}

/// wgpu's error chains on one line.
pub(super) fn one_line(text: &str) -> String {
    let parts: Vec<&str> = text
        .lines()
        .map(str::trim)
        .filter(|line| !line.is_empty() && *line != "Validation Error" && *line != "Caused by:")
        .collect();
    parts.join(": ")
}
