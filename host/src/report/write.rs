//! Writing a report's folder: everything is made in a hidden folder inside it, then moved into place.

use super::page::{self, Picture};
use super::{Chart, Comparison, RenderReport, ReportError, to_json};
use crate::image_io::{
    Image, ImageError, Rgb8, ToneMap, error_map, flip_map, png_bytes, write_exr, write_png, write_whole,
};
use crate::metrics::{self, RELATIVE_GUARD};
use rayon::prelude::*;
use std::path::Path;

/// Relative error at the ends of the colour scale of irradiance error maps.
pub const ERROR_RANGE: f32 = 0.5;

/// Widest picture that is put into the page; larger ones are reduced there (the files beside it are not).
const PAGE_WIDTH_PX: u32 = 1280;

/// What one method, or the truth, made of a view.
#[derive(Clone, PartialEq, Debug)]
pub struct Frame {
    /// Emitters seen and light that bounced once: radiance towards the camera, W/(sr m²).
    pub direct: Image,
    /// All other radiance towards the camera.
    pub indirect: Image,
    /// Sum of both.
    pub full: Image,
    /// Indirect irradiance at the visible points, W/m²; zero where there is none.
    pub irradiance: Image,
}

/// The pictures of a comparison. All have one size.
#[derive(Clone, PartialEq, Debug)]
pub struct Pictures {
    /// The truth.
    pub truth: Frame,
    /// One per result, in the order of [`Comparison::results`].
    pub results: Vec<Frame>,
    /// Whether a pixel shows a surface, row by row.
    pub visible: Vec<bool>,
}

/// Tone maps of a comparison: one for full pictures, one for irradiance, both from the truth.
struct Tones {
    full: ToneMap,
    irradiance: ToneMap,
}

/// Tone map of all full pictures of a comparison.
pub fn tone_map(truth: &Frame, visible: &[bool]) -> ToneMap {
    ToneMap::from_truth(&truth.full, visible)
}

/// Mean FLIP of a method's full picture against the truth's, both under the truth's [`tone_map`].
///
/// # Errors
/// [`metrics::MetricsError`] for pictures of different size.
pub fn flip_error(truth: &Image, full: &Image, tone: &ToneMap) -> Result<f64, metrics::MetricsError> {
    metrics::flip(&tone.apply(truth), &tone.apply(full)).map(|f| f.mean)
}

/// Writes a comparison into `folder` (made if it is not there): `compare.json`, `chart.svg`, `index.html`, and for the
/// truth and each result a folder with `full.exr`, `irradiance.exr`, their PNG pictures and error maps. Files of that
/// name are replaced, others stay; on an error, none of them has changed unless the last step, the renaming, failed.
///
/// # Errors
/// [`ReportError`], with the path or the method.
pub fn write_comparison(folder: &Path, comparison: &Comparison, pictures: &Pictures) -> Result<(), ReportError> {
    check_shapes(comparison, pictures)?;
    let json = to_json(comparison)?;
    in_place(folder, |work| {
        let on_page = write_pictures(work, comparison, pictures)?;
        write_whole(&work.join("compare.json"), json.as_bytes())?;
        let chart = Chart::from_comparison(comparison).svg(960.0, 500.0, "");
        write_whole(&work.join("chart.svg"), chart.as_bytes())?;
        write_whole(&work.join("index.html"), page::page(comparison, &on_page).as_bytes())?;
        Ok(())
    })
}

/// Writes one render into `folder` (made if it is not there): `direct.exr`, `indirect.exr`, `full.exr`,
/// `irradiance.exr`, `full.png`, `report.json`. As careful as [`write_comparison`].
///
/// # Errors
/// [`ReportError`], with the path.
pub fn write_render(folder: &Path, report: &RenderReport, frame: &Frame, tone: &ToneMap) -> Result<(), ReportError> {
    let json = to_json(report)?;
    in_place(folder, |work| {
        write_exr(&work.join("direct.exr"), &frame.direct)?;
        write_exr(&work.join("indirect.exr"), &frame.indirect)?;
        write_exr(&work.join("full.exr"), &frame.full)?;
        write_exr(&work.join("irradiance.exr"), &frame.irradiance)?;
        write_png(&work.join("full.png"), &tone.apply(&frame.full))?;
        write_whole(&work.join("report.json"), json.as_bytes())?;
        Ok(())
    })
}

/// Names of the folders of the results: method and label in letters, digits, `-`, `_` and `.`, made different by a
/// number where needed.
pub fn folder_names(comparison: &Comparison) -> Vec<String> {
    let mut names: Vec<String> = vec!["truth".into()];
    for result in &comparison.results {
        let plain = |c: char| if c.is_ascii_alphanumeric() || "-_.".contains(c) { c } else { '-' };
        let base: String = result.title().chars().map(plain).collect();
        let base = base.trim_start_matches('.').to_string();
        let mut name = base.clone();
        let mut k = 2;
        while name.is_empty() || names.contains(&name) {
            name = format!("{base}-{k}");
            k += 1;
        }
        names.push(name);
    }
    names.split_off(1)
}

fn check_shapes(comparison: &Comparison, pictures: &Pictures) -> Result<(), ReportError> {
    let size = comparison.size;
    let fail = |what: String| Err(ReportError::Mismatch { what });
    if pictures.results.len() != comparison.results.len() {
        return fail(format!("{} results with pictures of {}", comparison.results.len(), pictures.results.len()));
    }
    if pictures.visible.len() as u64 != u64::from(size[0]) * u64::from(size[1]) {
        return fail(format!("a mask of {} values for {} x {} pixels", pictures.visible.len(), size[0], size[1]));
    }
    let titles = comparison.results.iter().map(super::MethodResult::title);
    let named = std::iter::once("truth".to_string()).chain(titles);
    for (name, frame) in named.zip(std::iter::once(&pictures.truth).chain(&pictures.results)) {
        for picture in [&frame.full, &frame.irradiance] {
            if picture.size() != size {
                let [w, h] = picture.size();
                return fail(format!(
                    "a picture of {name} of {w} x {h} pixels in a report of {} x {}",
                    size[0], size[1]
                ));
            }
            picture.check_finite(&name)?;
        }
    }
    Ok(())
}

/// Writes the folders of the truth and of each result, and gives the page's pictures.
fn write_pictures(work: &Path, comparison: &Comparison, pictures: &Pictures) -> Result<Vec<Picture>, ReportError> {
    let truth = &pictures.truth;
    let tones = Tones {
        full: tone_map(truth, &pictures.visible),
        irradiance: ToneMap::from_truth(&truth.irradiance, &pictures.visible),
    };
    let mut on_page = write_frame(&work.join("truth"), truth, &tones, ("truth", "truth"))?;
    let truth_full = tones.full.apply(&truth.full);
    // A black truth has no mean: the error map then has no guard, and shows everything as too bright.
    let guard = metrics::truth_mean(&truth.irradiance, &pictures.visible).unwrap_or(0.0) * RELATIVE_GUARD;
    let names = folder_names(comparison);
    let of_results = (0..comparison.results.len()).into_par_iter().map(|k| {
        let (frame, folder, title) = (&pictures.results[k], work.join(&names[k]), comparison.results[k].title());
        let mut on_page = write_frame(&folder, frame, &tones, (&format!("m{k}"), &title))?;
        let flip = metrics::flip(&truth_full, &tones.full.apply(&frame.full))
            .map_err(|source| ReportError::Metrics { method: title.clone(), source })?;
        let flip = flip_map(comparison.size[0], comparison.size[1], &flip.map);
        let signed = error_map(&truth.irradiance, &frame.irradiance, &pictures.visible, guard as f32, ERROR_RANGE);
        for (layer, file, map) in [("full", "full_error.png", flip), ("irradiance", "irradiance_error.png", signed)] {
            write_png(&folder.join(file), &map)?;
            on_page.push(page_picture(layer, format!("e{k}"), format!("error of {title}"), &map)?);
        }
        Ok(on_page)
    });
    on_page.extend(of_results.collect::<Result<Vec<_>, ReportError>>()?.into_iter().flatten());
    Ok(on_page)
}

fn write_frame(
    folder: &Path,
    frame: &Frame,
    tones: &Tones,
    (choice, name): (&str, &str),
) -> Result<Vec<Picture>, ReportError> {
    create_folder(folder)?;
    let layers = [("full", &frame.full, &tones.full), ("irradiance", &frame.irradiance, &tones.irradiance)];
    let write = |(layer, picture, tone): (&'static str, &Image, &ToneMap)| {
        write_exr(&folder.join(format!("{layer}.exr")), picture)?;
        let shown = tone.apply(picture);
        write_png(&folder.join(format!("{layer}.png")), &shown)?;
        page_picture(layer, choice.into(), name.into(), &shown)
    };
    layers.into_iter().map(write).collect()
}

fn page_picture(layer: &'static str, choice: String, name: String, picture: &Rgb8) -> Result<Picture, ReportError> {
    let (width, height) = picture.dimensions();
    let encode = |p: &Rgb8| {
        png_bytes(p).map_err(|reason| ReportError::Image(ImageError::Encode { path: "index.html".into(), reason }))
    };
    let png = if width > PAGE_WIDTH_PX {
        let rows = (u64::from(height) * u64::from(PAGE_WIDTH_PX) / u64::from(width)).max(1) as u32;
        encode(&image::imageops::resize(picture, PAGE_WIDTH_PX, rows, image::imageops::FilterType::Triangle))?
    } else {
        encode(picture)?
    };
    Ok(Picture { layer, choice, name, png })
}

fn create_folder(folder: &Path) -> Result<(), ImageError> {
    std::fs::create_dir_all(folder).map_err(|e| ImageError::io("create", folder, e))
}

/// Runs `make` on a hidden folder inside `folder`, then moves what it made into `folder`, sub-folders first and
/// `index.html` last. On an error the hidden folder goes, and so does `folder` if it was made here.
fn in_place(folder: &Path, make: impl FnOnce(&Path) -> Result<(), ReportError>) -> Result<(), ReportError> {
    let first_new = folder.ancestors().take_while(|a| !a.as_os_str().is_empty() && !a.exists()).last();
    let result = (|| {
        create_folder(folder)?;
        let mut builder = tempfile::Builder::new();
        builder.prefix(".interreflect-").suffix(".partial");
        let work = builder.tempdir_in(folder).map_err(|e| ImageError::io("write into", folder, e))?;
        make(work.path())?;
        move_into(work.path(), folder)?;
        Ok(())
    })();
    if let (Err(_), Some(made)) = (&result, first_new) {
        // Best effort: the error that is reported is the one that led here.
        let _ = std::fs::remove_dir_all(made);
    }
    result
}

fn move_into(from: &Path, to: &Path) -> Result<(), ImageError> {
    let read = |e| ImageError::io("read", from, e);
    let mut entries = std::fs::read_dir(from).map_err(read)?.collect::<Result<Vec<_>, _>>().map_err(read)?;
    entries.sort_by_key(|e| (!e.path().is_dir(), e.file_name() == "index.html", e.file_name()));
    for entry in entries {
        let (source, target) = (entry.path(), to.join(entry.file_name()));
        if source.is_dir() {
            create_folder(&target)?;
            move_into(&source, &target)?;
        } else {
            std::fs::rename(&source, &target).map_err(|e| ImageError::io("write", &target, e))?;
        }
    }
    Ok(())
}
