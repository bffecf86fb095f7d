//! Reading of files: the scene's own, and those that it refers to.

use super::super::FileError;
use base64::Engine;
use base64::engine::DecodePaddingMode;
use base64::engine::general_purpose::{GeneralPurpose, GeneralPurposeConfig};
use std::io::Read;
use std::path::{Path, PathBuf};

/// An error unless `path` is an ordinary file: a folder has no bytes, and a device may have endless ones.
pub fn check_is_file(path: &Path) -> Result<u64, FileError> {
    let metadata = std::fs::metadata(path).map_err(|e| io_error(&e))?;
    match metadata {
        m if m.is_file() => Ok(m.len()),
        m if m.is_dir() => Err(FileError::NotAFile("a folder")),
        _ => Err(FileError::NotAFile("a device or a pipe")),
    }
}

/// The bytes of a file of at most `limit` bytes.
pub fn read(path: &Path, limit: u64) -> Result<Vec<u8>, FileError> {
    let length = check_is_file(path)?;
    if length > limit {
        return Err(FileError::TooLarge { what: "the file's length in bytes".into(), claimed: length, limit });
    }
    let file = std::fs::File::open(path).map_err(|e| io_error(&e))?;
    let mut bytes = Vec::with_capacity(length as usize);
    // The file may grow meanwhile: what was checked is what is read.
    file.take(length).read_to_end(&mut bytes).map_err(|e| io_error(&e))?;
    Ok(bytes)
}

/// The file that a relative URI of a scene in `folder` names.
pub fn resolve(folder: &Path, uri: &str) -> Result<PathBuf, FileError> {
    let refuse = |reason: &str| FileError::ExternalFile { uri: shorten(uri), reason: reason.to_owned() };
    let has_scheme = uri.split_once(':').is_some_and(|(scheme, _)| {
        scheme.len() > 1 && scheme.chars().all(|c| c.is_ascii_alphanumeric() || "+-.".contains(c))
    });
    if has_scheme {
        return Err(refuse("is not a relative path"));
    }
    let decoded = percent_decode(uri).ok_or_else(|| refuse("is not a valid URI"))?;
    if decoded.is_empty() || decoded.contains('\0') || Path::new(&decoded).is_absolute() {
        return Err(refuse("is not a relative path"));
    }
    Ok(folder.join(decoded))
}

/// The bytes behind a URI: of a `data:` URI itself, or of a file beside the scene.
pub fn read_uri(folder: &Path, uri: &str, limit: u64) -> Result<Vec<u8>, FileError> {
    if let Some(data) = uri.strip_prefix("data:") {
        return decode_data_uri(data).map_err(|reason| FileError::ExternalFile { uri: shorten(uri), reason });
    }
    read(&resolve(folder, uri)?, limit)
        .map_err(|reason| FileError::ExternalFile { uri: shorten(uri), reason: in_a_sentence(&reason) })
}

/// An error about a file as what follows "which".
pub fn in_a_sentence(reason: &FileError) -> String {
    match reason {
        FileError::NotFound => "does not exist".to_owned(),
        other => other.to_string(),
    }
}

/// `data:[<type>][;base64],<data>`, given what follows `data:`.
fn decode_data_uri(rest: &str) -> Result<Vec<u8>, String> {
    /// Padding is optional: some exporters leave it out.
    const BASE64: GeneralPurpose = GeneralPurpose::new(
        &base64::alphabet::STANDARD,
        GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent),
    );
    let (head, data) = rest.split_once(',').ok_or("is a data URI without data")?;
    if head.ends_with(";base64") {
        BASE64.decode(data.trim()).map_err(|e| format!("is not valid base64: {e}"))
    } else {
        percent_decode_bytes(data).ok_or_else(|| "is not a valid URI".to_owned())
    }
}

fn percent_decode(text: &str) -> Option<String> {
    String::from_utf8(percent_decode_bytes(text)?).ok()
}

/// Replaces each `%XX`; `None` where two hexadecimal digits do not follow.
fn percent_decode_bytes(text: &str) -> Option<Vec<u8>> {
    let bytes = text.as_bytes();
    let mut decoded = Vec::with_capacity(bytes.len());
    let mut at = 0;
    while at < bytes.len() {
        if bytes[at] == b'%' {
            let digit = |i: usize| bytes.get(i).and_then(|b| (*b as char).to_digit(16));
            decoded.push((digit(at + 1)? * 16 + digit(at + 2)?) as u8);
            at += 3;
        } else {
            decoded.push(bytes[at]);
            at += 1;
        }
    }
    Some(decoded)
}

fn io_error(error: &std::io::Error) -> FileError {
    match error.kind() {
        std::io::ErrorKind::NotFound | std::io::ErrorKind::NotADirectory => FileError::NotFound,
        _ => FileError::Unreadable(error.to_string()),
    }
}

/// A URI as it is shown in an error: data URIs may have megabytes.
fn shorten(uri: &str) -> String {
    /// Longest URI that is shown whole.
    const SHOWN: usize = 80;
    match uri.char_indices().nth(SHOWN) {
        Some((end, _)) => format!("{}…", &uri[..end]),
        None => uri.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percent_codes_are_decoded_and_broken_ones_refused() {
        assert_eq!(percent_decode("a%20b%2Fc.bin").as_deref(), Some("a b/c.bin"));
        assert_eq!(percent_decode("plain"), Some("plain".to_owned()));
        for broken in ["%", "%2", "%zz", "a%f"] {
            assert_eq!(percent_decode_bytes(broken), None, "{broken}");
        }
    }

    #[test]
    fn uris_that_leave_the_file_system_are_refused() {
        for uri in ["http://example.org/a.bin", "file:///etc/passwd", "/etc/passwd", ""] {
            assert!(resolve(Path::new("folder"), uri).is_err(), "{uri}");
        }
        assert_eq!(resolve(Path::new("folder"), "sub/a%20b.bin"), Ok(PathBuf::from("folder/sub/a b.bin")));
    }

    #[test]
    fn data_uris_are_decoded_with_and_without_padding() {
        assert_eq!(decode_data_uri("application/octet-stream;base64,AQID"), Ok(vec![1, 2, 3]));
        assert_eq!(decode_data_uri(";base64,AQ=="), Ok(vec![1]));
        assert_eq!(decode_data_uri(";base64,AQ"), Ok(vec![1]));
        assert_eq!(decode_data_uri(",a%01"), Ok(vec![b'a', 1]));
        assert!(decode_data_uri(";base64,%%%").is_err());
        assert!(decode_data_uri("no comma").is_err());
    }
}
