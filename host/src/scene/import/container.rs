//! The GLB container (glTF 2.0 specification, §4.4): a header, a JSON chunk and at most one binary chunk.

use super::super::FileError;

/// Bytes of the header, and of the head of each chunk.
const HEADER_BYTES: usize = 12;
const CHUNK_HEAD_BYTES: usize = 8;

/// The two chunks of a GLB file.
#[derive(Debug, PartialEq)]
pub struct Glb<'a> {
    /// The glTF document.
    pub json: &'a [u8],
    /// Buffer 0.
    pub binary: Option<&'a [u8]>,
}

/// Splits a GLB file into its chunks. Chunks of an unknown type are skipped, as the specification demands.
pub fn split(bytes: &[u8]) -> Result<Glb<'_>, FileError> {
    if !bytes.starts_with(b"glTF") {
        let found = String::from_utf8_lossy(&bytes[..bytes.len().min(4)]).into_owned();
        return Err(FileError::WrongMagic { found });
    }
    let word = |at: usize| bytes.get(at..at + 4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]));
    let (Some(version), Some(length)) = (word(4), word(8)) else {
        return Err(truncated("the header", HEADER_BYTES, bytes.len()));
    };
    if version != 2 {
        return Err(FileError::Malformed(format!("binary glTF of version {version}: only version 2 is supported")));
    }
    if length as usize > bytes.len() {
        return Err(truncated("the file", length as usize, bytes.len()));
    }
    let mut rest = bytes.get(HEADER_BYTES..length as usize).unwrap_or_default();
    let json = match next_chunk(&mut rest)? {
        Some((b"JSON", json)) => json,
        _ => return Err(FileError::Malformed("the first chunk is not the JSON document".into())),
    };
    let mut binary = None;
    while let Some((kind, data)) = next_chunk(&mut rest)? {
        if kind == b"BIN\0" && binary.is_none() {
            binary = Some(data);
        }
    }
    Ok(Glb { json, binary })
}

/// Type and data of a chunk.
type Chunk<'a> = (&'a [u8; 4], &'a [u8]);

/// Takes the next chunk off `rest`; `None` at the end. Fewer bytes than a chunk's head are padding.
fn next_chunk<'a>(rest: &mut &'a [u8]) -> Result<Option<Chunk<'a>>, FileError> {
    let Some((head, after)) = rest.split_first_chunk::<CHUNK_HEAD_BYTES>() else { return Ok(None) };
    let length = u32::from_le_bytes([head[0], head[1], head[2], head[3]]) as usize;
    let kind: &[u8; 4] = rest[4..8].try_into().expect("four bytes");
    let Some((data, after)) = after.split_at_checked(length) else {
        let name = String::from_utf8_lossy(kind).into_owned();
        return Err(truncated(&format!("the chunk {name:?}"), length, after.len()));
    };
    *rest = after;
    Ok(Some((kind, data)))
}

fn truncated(what: &str, needed: usize, available: usize) -> FileError {
    FileError::Truncated { what: what.to_owned(), needed: needed as u64, available: available as u64 }
}
