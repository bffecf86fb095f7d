//! The compiled modules are what the declarations say: naga's view of every `.spv` and `.wgsl` against its
//! `KernelDesc`, the set of files against the kernel table, and the manifest against both.

use interreflect::exec::manifest::{AccessKind, KernelEntry, Manifest, RecordLayout};
use interreflect_kernels::compiled::{self, MODULES};
use interreflect_kernels::kernel::{Access, Binding, KernelDesc};
use interreflect_shared::{Field, Word};
use naga::{AddressSpace, Handle, ScalarKind, ShaderStage, StorageAccess, Type, TypeInner};
use std::collections::{BTreeMap, BTreeSet};

/// One binding as the compiled module has it.
#[derive(PartialEq, Debug)]
struct Reflected {
    index: u32,
    name: Option<String>,
    access: Access,
    stride_bytes: usize,
    /// Kind of the word at every offset in bytes.
    words: BTreeMap<usize, Word>,
}

/// One entry point as the compiled module has it.
#[derive(PartialEq, Debug)]
struct Interface {
    name: String,
    workgroup: [u32; 3],
    bindings: Vec<Reflected>,
}

fn parse_spirv(spirv: &[u8]) -> naga::Module {
    let options = naga::front::spv::Options { adjust_coordinate_space: false, ..Default::default() };
    naga::front::spv::parse_u8_slice(spirv, &options).expect("naga parses the compiled SPIR-V")
}

/// What a module of one compute entry point binds.
fn reflect(module: &naga::Module) -> Result<Interface, String> {
    let [entry] = module.entry_points.as_slice() else {
        return Err(format!("{} entry points", module.entry_points.len()));
    };
    if entry.stage != ShaderStage::Compute {
        return Err(format!("stage {:?}", entry.stage));
    }
    let mut bindings = Vec::new();
    for (_, variable) in module.global_variables.iter() {
        let Some(binding) = &variable.binding else { continue };
        if binding.group != 0 {
            return Err(format!("binding {} is in group {}", binding.binding, binding.group));
        }
        let (element, stride) = element(module, variable.ty);
        let mut words = BTreeMap::new();
        let atomic = add_words(module, element, 0, &mut words)?;
        let access = match variable.space {
            AddressSpace::Uniform => Access::Uniform,
            AddressSpace::Storage { access } if !access.contains(StorageAccess::STORE) => Access::Read,
            AddressSpace::Storage { .. } if atomic => Access::Atomic,
            AddressSpace::Storage { .. } => Access::Write,
            other => return Err(format!("binding {} is in {other:?}", binding.binding)),
        };
        bindings.push(Reflected {
            index: binding.binding,
            name: variable.name.clone(),
            access,
            stride_bytes: stride,
            words,
        });
    }
    bindings.sort_by_key(|binding| binding.index);
    Ok(Interface { name: entry.name.clone(), workgroup: entry.workgroup_size, bindings })
}

/// Element and stride of a buffer: `struct { element }`, or `struct { element[] }`.
fn element(module: &naga::Module, buffer: Handle<Type>) -> (Handle<Type>, usize) {
    let content = match &module.types[buffer].inner {
        TypeInner::Struct { members, .. } if members.len() == 1 => members[0].ty,
        _ => buffer,
    };
    match module.types[content].inner {
        TypeInner::Array { base, stride, size: naga::ArraySize::Dynamic } => (base, stride as usize),
        ref inner => (content, inner.size(module.to_ctx()) as usize),
    }
}

/// Adds the words of a type that starts at an offset; tells whether there are atomics among them.
fn add_words(
    module: &naga::Module,
    ty: Handle<Type>,
    offset: usize,
    words: &mut BTreeMap<usize, Word>,
) -> Result<bool, String> {
    let mut scalars = |scalar: naga::Scalar, offsets: &mut dyn Iterator<Item = usize>| -> Result<(), String> {
        let word = match (scalar.kind, scalar.width) {
            (ScalarKind::Float, 4) => Word::F32,
            (ScalarKind::Uint, 4) => Word::U32,
            (ScalarKind::Sint, 4) => Word::I32,
            other => return Err(format!("scalar {other:?}")),
        };
        words.extend(offsets.map(|at| (offset + at, word)));
        Ok(())
    };
    match &module.types[ty].inner {
        TypeInner::Scalar(scalar) => scalars(*scalar, &mut std::iter::once(0)).map(|()| false),
        TypeInner::Atomic(scalar) => scalars(*scalar, &mut std::iter::once(0)).map(|()| true),
        TypeInner::Vector { size, scalar } => scalars(*scalar, &mut (0..*size as usize).map(|k| 4 * k)).map(|()| false),
        TypeInner::Matrix { columns, rows, scalar } => {
            // A column of three or four rows takes 16 bytes, one of two takes 8.
            let (rows, pitch) = (*rows as usize, if *rows as usize == 2 { 8 } else { 16 });
            let columns = 0..*columns as usize;
            scalars(*scalar, &mut columns.flat_map(|c| (0..rows).map(move |r| c * pitch + 4 * r))).map(|()| false)
        }
        TypeInner::Struct { members, .. } => {
            let mut atomic = false;
            for member in members {
                atomic |= add_words(module, member.ty, offset + member.offset as usize, words)?;
            }
            Ok(atomic)
        }
        TypeInner::Array { base, size: naga::ArraySize::Constant(count), stride } => {
            let mut atomic = false;
            for k in 0..count.get() {
                atomic |= add_words(module, *base, offset + (k * stride) as usize, words)?;
            }
            Ok(atomic)
        }
        other => Err(format!("type {other:?}")),
    }
}

/// The words that a declaration's fields cover.
fn declared_words(fields: &[Field]) -> BTreeMap<usize, Word> {
    fields.iter().flat_map(|f| (0..f.word_count).map(|k| (f.offset_bytes + 4 * k, f.word))).collect()
}

/// Every way in which a module is not what a declaration says. Names of bindings only where the module has them.
fn differences(desc: &KernelDesc, module: &Interface) -> Vec<String> {
    let mut found = Vec::new();
    let mut differ = |what: String, declared: String, compiled: String| {
        if declared != compiled {
            found.push(format!("{}: {what}: declared {declared}, compiled {compiled}", desc.name));
        }
    };
    differ("entry point".into(), desc.name.into(), module.name.clone());
    differ("workgroup".into(), format!("{:?}", [desc.workgroup_size, 1, 1]), format!("{:?}", module.workgroup));
    let mut declared: Vec<&Binding> = desc.bindings.iter().collect();
    declared.sort_by_key(|binding| binding.index);
    differ(
        "bindings".into(),
        format!("{:?}", declared.iter().map(|b| b.index).collect::<Vec<_>>()),
        format!("{:?}", module.bindings.iter().map(|b| b.index).collect::<Vec<_>>()),
    );
    for binding in declared {
        let Some(compiled) = module.bindings.iter().find(|b| b.index == binding.index) else { continue };
        let at = |what: &str| format!("binding {} `{}`: {what}", binding.index, binding.name);
        if let Some(name) = &compiled.name {
            differ(at("name"), binding.name.into(), name.clone());
        }
        differ(at("access"), format!("{:?}", binding.access), format!("{:?}", compiled.access));
        differ(at("stride"), binding.stride_bytes.to_string(), compiled.stride_bytes.to_string());
        differ(at("layout"), format!("{:?}", declared_words(binding.fields)), format!("{:?}", compiled.words));
    }
    found
}

#[test]
fn every_kernel_is_compiled_and_nothing_else() {
    let declared: BTreeSet<&str> = interreflect_kernels::all().map(|kernel| kernel.desc.name).collect();
    let compiled: BTreeSet<&str> = MODULES.iter().map(|module| module.name).collect();
    assert_eq!(declared.len(), interreflect_kernels::all().count(), "two kernels share a name");
    assert_eq!(declared, compiled, "run `cargo xtask kernels`");
}

#[test]
fn every_spirv_module_is_what_its_declaration_says() {
    let mut found = Vec::new();
    for kernel in interreflect_kernels::all() {
        let module = compiled::module(kernel.desc.name).expect("compiled");
        let interface = reflect(&parse_spirv(module.spirv)).unwrap_or_else(|e| panic!("{}: {e}", kernel.desc.name));
        assert!(interface.bindings.iter().all(|b| b.name.is_some()), "{}: unnamed bindings", kernel.desc.name);
        found.extend(differences(&kernel.desc, &interface));
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn every_wgsl_module_is_what_its_declaration_says() {
    let mut found = Vec::new();
    for kernel in interreflect_kernels::all() {
        let text = compiled::module(kernel.desc.name).expect("compiled").wgsl;
        let module = naga::front::wgsl::parse_str(text)
            .unwrap_or_else(|e| panic!("{}: {}", kernel.desc.name, e.emit_to_string(text)));
        let mut interface = reflect(&module).unwrap_or_else(|e| panic!("{}: {e}", kernel.desc.name));
        // naga changes names that WGSL reserves.
        interface.bindings.iter_mut().for_each(|binding| binding.name = None);
        found.extend(differences(&kernel.desc, &interface));
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn a_wrong_declaration_is_found() {
    use interreflect_kernels::smoke::{smoke_axpy, smoke_histogram};
    let interface = reflect(&parse_spirv(compiled::module("smoke_axpy").expect("compiled").spirv)).expect("reflects");
    let good = smoke_axpy::DESC;
    assert_eq!(differences(&good, &interface), Vec::<String>::new());

    let doctored = |change: &dyn Fn(&mut Vec<Binding>)| -> KernelDesc {
        let mut bindings = good.bindings.to_vec();
        change(&mut bindings);
        KernelDesc { bindings: bindings.leak(), ..good }
    };
    let mut moved = good.bindings[0].fields.to_vec();
    moved.swap(0, 2);
    let moved: &[Field] = moved
        .iter()
        .zip(good.bindings[0].fields)
        .map(|(f, at)| Field { offset_bytes: at.offset_bytes, ..*f })
        .collect::<Vec<_>>()
        .leak();
    let wrong = [
        ("entry point", KernelDesc { name: "smoke_axpz", ..good }),
        ("workgroup", KernelDesc { workgroup_size: 128, ..good }),
        ("bindings", doctored(&|b| b[1].index = 7)),
        ("bindings", doctored(&|b| b.truncate(3))),
        ("name", doctored(&|b| b[1].name = "z")),
        ("access", doctored(&|b| b[1].access = Access::Write)),
        ("access", doctored(&|b| b[3].access = Access::Atomic)),
        ("access", doctored(&|b| b[0].access = Access::Read)),
        ("stride", doctored(&|b| b[1].stride_bytes = 8)),
        ("layout", doctored(&|b| b[0].fields = moved)),
        ("layout", doctored(&|b| b[0].fields = &b[0].fields[1..])),
    ];
    for (what, desc) in wrong {
        let found = differences(&desc, &interface);
        assert!(found.iter().any(|line| line.contains(what)), "a wrong {what} goes unnoticed: {found:?}");
    }
    assert!(!differences(&smoke_histogram::DESC, &interface).is_empty(), "another kernel's declaration passes");
}

#[test]
fn the_manifest_is_what_the_declarations_say() {
    let manifest = Manifest::embedded().expect("the embedded manifest parses");
    assert_eq!(manifest.fold_width, interreflect_kernels::kernel::FOLD_WIDTH);
    assert_eq!(manifest.kernels.len(), interreflect_kernels::all().count());
    for kernel in interreflect_kernels::all() {
        let entry = manifest.kernel(kernel.desc.name).expect("every kernel is in the manifest");
        manifest_entry(&kernel.desc, entry, &manifest.records);
        let count = 70_000 * 64;
        let [x, y] = kernel.desc.workgroups(count);
        assert_eq!(manifest.workgroups(entry, count), [x, y, 1]);
        let words = manifest.spirv(kernel.desc.name).expect("embedded");
        assert_eq!(
            bytemuck::cast_slice::<u32, u8>(&words),
            compiled::module(kernel.desc.name).expect("compiled").spirv
        );
    }
}

fn manifest_entry(desc: &KernelDesc, entry: &KernelEntry, records: &BTreeMap<String, RecordLayout>) {
    assert_eq!(entry.workgroup, [desc.workgroup_size, 1, 1], "{}", desc.name);
    assert_eq!(entry.bindings.len(), desc.bindings.len(), "{}", desc.name);
    for (binding, declared) in entry.bindings.iter().zip(desc.bindings) {
        let access = match declared.access {
            Access::Uniform => AccessKind::Uniform,
            Access::Read => AccessKind::Read,
            Access::Write => AccessKind::Write,
            Access::Atomic => AccessKind::Atomic,
        };
        let at = format!("{}: binding {}", desc.name, declared.name);
        assert_eq!((binding.binding, binding.name.as_str()), (declared.index, declared.name), "{at}");
        assert_eq!((binding.access, binding.stride_bytes as usize), (access, declared.stride_bytes), "{at}");
        let record = &records[&binding.record];
        assert_eq!(record.size_bytes as usize, declared.stride_bytes, "{at}");
        let fields: Vec<_> =
            record.fields.iter().map(|f| (f.name.as_str(), f.offset_bytes as usize, f.words)).collect();
        let expected: Vec<_> = declared.fields.iter().map(|f| (f.name, f.offset_bytes, f.word_count as u32)).collect();
        assert_eq!(fields, expected, "{at}");
    }
}

#[test]
fn a_broken_manifest_is_refused() {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let path = dir.path().join("manifest.json");
    let error = |text: &str| {
        std::fs::write(&path, text).expect("written");
        Manifest::read(&path).expect_err("refused").to_string()
    };
    assert!(Manifest::read(dir.path().join("none.json")).expect_err("refused").to_string().contains("none.json"));
    assert!(error("{").contains("not a kernel manifest"));
    assert!(error(r#"{"format": 99}"#).contains("format 99"));
    assert!(error(r#"{"format": 1}"#).contains("missing field"));
    let manifest = Manifest::embedded().expect("the embedded manifest parses");
    assert!(manifest.kernel("no_such").expect_err("refused").to_string().contains("smoke_fill"));
}
