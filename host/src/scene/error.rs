//! What can be wrong with a scene.

use std::path::PathBuf;

/// A scene, or a camera in it, cannot be had.
#[derive(Debug, thiserror::Error)]
pub enum SceneError {
    /// Neither a built-in scene nor a file.
    #[error("no scene `{name}`: it is neither a file nor one of {}{}", known.join(", "), did_you_mean(nearest))]
    Unknown {
        /// What was asked for.
        name: String,
        /// The built-in scene with the most similar name, when one is similar.
        nearest: Option<String>,
        /// All built-in scenes.
        known: Vec<String>,
    },
    /// A file that cannot be read as a scene.
    #[error("{}: {reason}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        #[source]
        reason: FileError,
    },
    /// Neither the name of a camera of the scene nor seven numbers that describe one.
    #[error("no camera `{spec}`: {reason}{}", did_you_mean(nearest))]
    Camera {
        /// What was asked for.
        spec: String,
        /// Why it is not a camera.
        reason: String,
        /// The camera with the most similar name, when one is similar.
        nearest: Option<String>,
    },
}

/// What is wrong with a scene file.
#[derive(Debug, PartialEq, thiserror::Error)]
pub enum FileError {
    /// There is no such file.
    #[error("no such file")]
    NotFound,
    /// A folder, a device or something else that is no file.
    #[error("is {0}, not a file")]
    NotAFile(&'static str),
    /// The operating system refused.
    #[error("cannot be read: {0}")]
    Unreadable(String),
    /// The name does not end in a known way.
    #[error("unknown kind of scene file: the name must end in .glb, .gltf or .obj")]
    UnknownKind,
    /// A binary glTF file must start with `glTF`.
    #[error("not a binary glTF file: it starts with {found:?} where \"glTF\" must stand")]
    WrongMagic {
        /// The file's first bytes.
        found: String,
    },
    /// Something ends before its stated length.
    #[error("{what} is truncated: {needed} bytes are needed, {available} are there")]
    Truncated {
        /// File, chunk, buffer, buffer view or accessor.
        what: String,
        /// Bytes that it must have.
        needed: u64,
        /// Bytes that it has.
        available: u64,
    },
    /// Something claims more than can be loaded.
    #[error("{what} is too large: {claimed}, at most {limit} are accepted")]
    TooLarge {
        /// What is counted.
        what: String,
        /// How many there would be.
        claimed: u64,
        /// How many may be.
        limit: u64,
    },
    /// A reference to something that is not there.
    #[error("{what} {index} is out of range: there are {count}")]
    OutOfRange {
        /// Where the reference is, and to what.
        what: String,
        /// The index, counted from 0 in glTF and from 1 in OBJ.
        index: i64,
        /// How many there are.
        count: u64,
    },
    /// A vertex position is NaN, infinite or absurdly far away.
    #[error("mesh `{mesh}`, vertex {vertex}: position ({}, {}, {}) {reason}", position[0], position[1], position[2])]
    BadVertex {
        /// Name of the mesh.
        mesh: String,
        /// Index of the vertex in the mesh, from 0.
        vertex: usize,
        /// Its position.
        position: [f32; 3],
        /// What is wrong with it.
        reason: String,
    },
    /// A file that the scene refers to cannot be read.
    #[error("refers to `{uri}`, which {reason}")]
    ExternalFile {
        /// As written in the scene.
        uri: String,
        /// What is wrong with it.
        reason: String,
    },
    /// The file says that it cannot be understood without this glTF extension.
    #[error("requires the glTF extension {name}, which is not supported")]
    RequiredExtension {
        /// Name of the extension.
        name: String,
    },
    /// A picture that cannot be decoded.
    #[error("image `{image}`: {reason}")]
    Image {
        /// Name, URI or index of the image.
        image: String,
        /// The decoder's words.
        reason: String,
    },
    /// Not a valid file of its kind.
    #[error("{0}")]
    Malformed(String),
    /// Nothing that light could fall on.
    #[error("no triangles{0}")]
    NoTriangles(String),
}

fn did_you_mean(nearest: &Option<String>) -> String {
    nearest.as_ref().map_or_else(String::new, |name| format!("; did you mean `{name}`?"))
}

/// The most similar of some names, when it is similar enough to be a typing mistake.
pub(super) fn nearest<'a>(wanted: &str, names: impl Iterator<Item = &'a str>) -> Option<String> {
    /// Jaro-Winkler similarity from which on two names are taken for the same word mistyped.
    const SIMILAR: f64 = 0.75;
    let wanted = wanted.to_lowercase();
    names
        .map(|name| (strsim::jaro_winkler(&wanted, &name.to_lowercase()), name))
        .filter(|(similarity, _)| *similarity >= SIMILAR)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, name)| name.to_owned())
}
