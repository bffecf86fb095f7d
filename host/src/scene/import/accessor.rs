//! Reading of glTF accessors (glTF 2.0 specification, §3.6): typed views of buffers, strided, normalized or sparse.

use super::super::FileError;
use super::{MAX_ELEMENTS, MAX_FILE_BYTES, MAX_UNBACKED_ELEMENTS, external};
use ::gltf::json::accessor::{ComponentType, Type};
use ::gltf::json::validation::Checked;
use ::gltf::json::{Accessor, Index, Root};
use std::borrow::Cow;
use std::path::Path;

/// The buffers of a document, with checked access.
pub struct Buffers<'a> {
    root: &'a Root,
    buffers: Vec<Cow<'a, [u8]>>,
    /// Accessor elements that may still be decoded.
    elements_left: u64,
}

/// Where an accessor's elements lie in a buffer view.
struct Layout {
    first: usize,
    stride: usize,
}

impl<'a> Buffers<'a> {
    /// Reads all buffers: the GLB's binary chunk, `data:` URIs and files beside the scene.
    pub fn read(root: &'a Root, binary: Option<&'a [u8]>, folder: &Path) -> Result<Self, FileError> {
        let mut buffers = Vec::with_capacity(root.buffers.len());
        let mut budget = MAX_FILE_BYTES;
        for (i, buffer) in root.buffers.iter().enumerate() {
            let mut bytes = match (&buffer.uri, binary) {
                (Some(uri), _) => Cow::Owned(external::read_uri(folder, uri, budget)?),
                (None, Some(binary)) if i == 0 => Cow::Borrowed(binary),
                _ => return Err(FileError::Malformed(format!("buffer {i} has neither a URI nor a binary chunk"))),
            };
            budget = budget.saturating_sub(bytes.len() as u64);
            let needed = buffer.byte_length.0;
            if needed > bytes.len() as u64 {
                let what = format!("buffer {i}");
                return Err(FileError::Truncated { what, needed, available: bytes.len() as u64 });
            }
            match &mut bytes {
                Cow::Borrowed(bytes) => *bytes = &bytes[..needed as usize],
                Cow::Owned(bytes) => bytes.truncate(needed as usize),
            }
            buffers.push(bytes);
        }
        Ok(Buffers { root, buffers, elements_left: MAX_ELEMENTS })
    }

    /// The bytes of a buffer view.
    pub fn view(&self, view_idx: usize) -> Result<&[u8], FileError> {
        let view = look_up(&self.root.buffer_views, view_idx, || "buffer view".into())?;
        let what = || format!("buffer view {view_idx}");
        let buffer = look_up(&self.buffers, view.buffer.value(), || format!("{}: buffer", what()))?;
        let first = view.byte_offset.map_or(0, |o| o.0);
        let end = first.saturating_add(view.byte_length.0);
        let truncated = || FileError::Truncated { what: what(), needed: end, available: buffer.len() as u64 };
        if end > buffer.len() as u64 {
            return Err(truncated());
        }
        buffer.get(first as usize..end as usize).ok_or_else(truncated)
    }

    /// The elements of an accessor of `N` components as floats: as they are, or normalized integers as 0…1 or −1…1.
    pub fn floats<const N: usize>(&mut self, accessor_idx: usize, what: &str) -> Result<Vec<[f32; N]>, FileError> {
        let accessor = self.accessor(accessor_idx, what)?;
        let components = match accessor.type_ {
            Checked::Valid(Type::Scalar) => 1,
            Checked::Valid(Type::Vec2) => 2,
            Checked::Valid(Type::Vec3) => 3,
            Checked::Valid(Type::Vec4) => 4,
            _ => 0,
        };
        let component = component_type(accessor, accessor_idx)?;
        // Colours may have three components where four are wanted: alpha is then 1.
        let is_rgb_for_rgba = N == 4 && components == 3;
        if components != N && !is_rgb_for_rgba {
            let reason = format!("{what}: accessor {accessor_idx} does not have {N} components");
            return Err(FileError::Malformed(reason));
        }
        let normalized = accessor.normalized;
        self.elements(accessor_idx, components * size_of_component(component), |bytes| {
            let mut element = [1.0; N];
            for (i, value) in element.iter_mut().enumerate().take(components) {
                *value = decode(component, normalized, &bytes[i * size_of_component(component)..]);
            }
            element
        })
    }

    /// The elements of a scalar accessor of unsigned integers.
    pub fn indices(&mut self, accessor_idx: usize, what: &str) -> Result<Vec<u32>, FileError> {
        let accessor = self.accessor(accessor_idx, what)?;
        let component = component_type(accessor, accessor_idx)?;
        let is_index = matches!(component, ComponentType::U8 | ComponentType::U16 | ComponentType::U32);
        if accessor.type_ != Checked::Valid(Type::Scalar) || !is_index {
            let reason = format!("{what}: accessor {accessor_idx} does not hold unsigned integers");
            return Err(FileError::Malformed(reason));
        }
        self.elements(accessor_idx, size_of_component(component), |bytes| decode_index(component, bytes))
    }

    fn accessor(&self, accessor_idx: usize, what: &str) -> Result<&'a Accessor, FileError> {
        look_up(&self.root.accessors, accessor_idx, || format!("{what}: accessor"))
    }

    /// Decodes each element of `size` bytes; without a buffer view all of them are zero bytes. Then the sparse ones.
    fn elements<T>(
        &mut self,
        accessor_idx: usize,
        size: usize,
        decode: impl Fn(&[u8]) -> T,
    ) -> Result<Vec<T>, FileError> {
        let accessor = self.accessor(accessor_idx, "")?;
        let count = accessor.count.0;
        let too_large = |limit| {
            let what = format!("the number of elements of accessor {accessor_idx}");
            FileError::TooLarge { what, claimed: count, limit }
        };
        self.elements_left = self.elements_left.checked_sub(count).ok_or_else(|| too_large(MAX_ELEMENTS))?;
        let mut elements = Vec::new();
        if let Some(view) = accessor.buffer_view {
            let what = format!("accessor {accessor_idx}");
            let offset = accessor.byte_offset.map_or(0, |o| o.0);
            let (bytes, layout) = self.strided(view.value(), offset, count, size, &what)?;
            elements.reserve_exact(count as usize);
            elements.extend((0..count as usize).map(|i| decode(&bytes[layout.first + i * layout.stride..])));
        } else {
            if count > MAX_UNBACKED_ELEMENTS {
                return Err(too_large(MAX_UNBACKED_ELEMENTS));
            }
            let zeros = [0_u8; 16];
            elements.extend((0..count).map(|_| decode(&zeros)));
        }
        self.apply_sparse(accessor, accessor_idx, size, decode, &mut elements)?;
        Ok(elements)
    }

    /// Overwrites the elements that a sparse accessor lists (§3.6.2.3).
    fn apply_sparse<T>(
        &self,
        accessor: &Accessor,
        accessor_idx: usize,
        size: usize,
        decode: impl Fn(&[u8]) -> T,
        elements: &mut [T],
    ) -> Result<(), FileError> {
        let Some(sparse) = &accessor.sparse else { return Ok(()) };
        let what = format!("accessor {accessor_idx}, sparse");
        let Checked::Valid(index_type) = sparse.indices.component_type else {
            return Err(FileError::Malformed(format!("{what} indices: unknown component type")));
        };
        let index_size = size_of_component(index_type.0);
        let indices = &sparse.indices;
        let (index_bytes, index_layout) = self.strided(
            indices.buffer_view.value(),
            indices.byte_offset.0,
            sparse.count.0,
            index_size,
            &format!("{what} indices"),
        )?;
        let values = &sparse.values;
        let (value_bytes, value_layout) = self.strided(
            values.buffer_view.value(),
            values.byte_offset.0,
            sparse.count.0,
            size,
            &format!("{what} values"),
        )?;
        for i in 0..sparse.count.0 as usize {
            let index = decode_index(index_type.0, &index_bytes[index_layout.first + i * index_layout.stride..]);
            let count = elements.len() as u64;
            let element = elements.get_mut(index as usize).ok_or_else(|| FileError::OutOfRange {
                what: format!("{what} index"),
                index: i64::from(index),
                count,
            })?;
            *element = decode(&value_bytes[value_layout.first + i * value_layout.stride..]);
        }
        Ok(())
    }

    /// A buffer view's bytes and the layout of `count` elements of `size` bytes in it, which lie inside.
    fn strided(
        &self,
        view_idx: usize,
        offset: u64,
        count: u64,
        size: usize,
        what: &str,
    ) -> Result<(&[u8], Layout), FileError> {
        let bytes = self.view(view_idx).map_err(|e| match e {
            FileError::OutOfRange { what: inner, index, count } => {
                FileError::OutOfRange { what: format!("{what}: {inner}"), index, count }
            }
            other => other,
        })?;
        let stride = self.root.buffer_views[view_idx].byte_stride.map_or(size, |s| s.0);
        if stride < size {
            let reason = format!("{what}: a stride of {stride} bytes is less than an element's {size}");
            return Err(FileError::Malformed(reason));
        }
        let span =
            count.checked_sub(1).map_or(Some(0), |gaps| gaps.checked_mul(stride as u64)?.checked_add(size as u64));
        let needed = span.and_then(|s| s.checked_add(offset)).unwrap_or(u64::MAX);
        if needed > bytes.len() as u64 {
            return Err(FileError::Truncated { what: what.to_owned(), needed, available: bytes.len() as u64 });
        }
        Ok((bytes, Layout { first: offset as usize, stride }))
    }
}

/// An element of a list of the document, or an error that says what refers to it.
pub fn look_up<T>(list: &[T], index: usize, what: impl FnOnce() -> String) -> Result<&T, FileError> {
    let count = list.len() as u64;
    list.get(index).ok_or_else(|| FileError::OutOfRange { what: what(), index: index as i64, count })
}

/// The value of an optional index.
pub fn index_of<T>(index: Option<Index<T>>) -> Option<usize> {
    index.map(|i| i.value())
}

fn component_type(accessor: &Accessor, accessor_idx: usize) -> Result<ComponentType, FileError> {
    match accessor.component_type {
        Checked::Valid(component) => Ok(component.0),
        Checked::Invalid => Err(FileError::Malformed(format!("accessor {accessor_idx}: unknown component type"))),
    }
}

fn size_of_component(component: ComponentType) -> usize {
    match component {
        ComponentType::I8 | ComponentType::U8 => 1,
        ComponentType::I16 | ComponentType::U16 => 2,
        ComponentType::U32 | ComponentType::F32 => 4,
    }
}

/// Conversion of §3.11 (normalized integers).
fn decode(component: ComponentType, normalized: bool, bytes: &[u8]) -> f32 {
    let (value, largest) = match component {
        ComponentType::I8 => (f32::from(bytes[0] as i8), 127.0),
        ComponentType::U8 => (f32::from(bytes[0]), 255.0),
        ComponentType::I16 => (f32::from(i16::from_le_bytes([bytes[0], bytes[1]])), 32_767.0),
        ComponentType::U16 => (f32::from(u16::from_le_bytes([bytes[0], bytes[1]])), 65_535.0),
        ComponentType::U32 => (u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]) as f32, u32::MAX as f32),
        ComponentType::F32 => return f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]),
    };
    if normalized { (value / largest).max(-1.0) } else { value }
}

fn decode_index(component: ComponentType, bytes: &[u8]) -> u32 {
    match size_of_component(component) {
        1 => u32::from(bytes[0]),
        2 => u32::from(u16::from_le_bytes([bytes[0], bytes[1]])),
        _ => u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]),
    }
}
