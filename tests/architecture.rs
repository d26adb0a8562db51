//! Checks which files of `src` use each other: the folders stand on the floors that src/README.md
//! draws, and no files use each other in a circle.
//!
//! A use is a path that begins with `crate::`, `super::` or `self::`, or with the name of a file in the same folder, in
//! a `use` line or in the code. The used file is the one that defines the name: a re-export (`pub use`) in the front
//! file of a folder is followed to its definition. A re-export itself is not a use, unless the front file uses the name
//! in its code. Modules with `#[cfg(test)]` are ignored.

#![allow(clippy::unwrap_used)]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use proc_macro2::{TokenStream, TokenTree};
use syn::visit::{self, Visit};
use syn::{Attribute, ItemMod, ItemUse, Macro, Meta, UseTree, VisRestricted, Visibility};

/// The floors of the drawing in src/README.md, the lowest first: the folders (and single files) of `src`. Each may use
/// itself and those on floors below it; those on one floor do not use each other.
fn layers() -> Vec<Vec<String>> {
    let page = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/src/README.md")).unwrap();
    let drawing = page.split("```text\n").nth(1).unwrap().split("```").next().unwrap();
    let names = |line: &str| line.split("  ").next().unwrap().split(' ').map(str::to_owned).collect();
    drawing.lines().rev().map(names).collect()
}

/// A module path such as `["impact", "course"]`; empty for the root of the crate.
type Module = Vec<String>;

/// Every file of `src`: its module, and the paths in its code.
fn sources() -> Vec<(Module, Paths)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    collect(&root, &mut files);
    files
        .into_iter()
        .map(|path| {
            let relative = path.strip_prefix(&root).unwrap().with_extension("");
            let mut module: Module =
                relative.components().map(|part| part.as_os_str().to_str().unwrap().to_owned()).collect();
            if module == ["lib"] || module.last().is_some_and(|part| part == "mod") {
                module.pop();
            }
            // the command uses the library by the name of its crate
            let text = fs::read_to_string(path).unwrap().replace("plm_impact::", "crate::");
            (module, Paths::of(&text))
        })
        .collect()
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
}

/// The paths in the code of a file.
#[derive(Default)]
struct Paths {
    /// The paths of `use` items with a visibility, from the stem to each leaf.
    exported: BTreeSet<String>,
    /// All others, such as `crate::law::Law` or `Law`.
    used: BTreeSet<String>,
}

impl Paths {
    fn of(code: &str) -> Self {
        let mut paths = Self::default();
        paths.visit_file(&syn::parse_file(code).unwrap());
        paths
    }

    fn add_use_tree(&mut self, is_exported: bool, stem: &str, tree: &UseTree) {
        let leaf = match tree {
            UseTree::Path(path) => {
                return self.add_use_tree(is_exported, &format!("{stem}{}::", path.ident), &path.tree);
            }
            UseTree::Group(group) => {
                return group.items.iter().for_each(|tree| self.add_use_tree(is_exported, stem, tree));
            }
            UseTree::Glob(_) => None,
            UseTree::Name(name) => Some(&name.ident),
            UseTree::Rename(rename) => Some(&rename.ident),
        };
        let path = match leaf.filter(|name| *name != "self") {
            Some(name) => format!("{stem}{name}"),
            None => stem.trim_end_matches(':').to_owned(),
        };
        if is_exported { &mut self.exported } else { &mut self.used }.insert(path);
    }

    /// The paths in code that is not parsed: the arguments of a macro or of an attribute.
    fn add_tokens(&mut self, tokens: TokenStream) {
        let mut path = String::new();
        for token in tokens {
            match &token {
                TokenTree::Ident(name) if path.is_empty() || path.ends_with("::") => path += &name.to_string(),
                TokenTree::Punct(mark) if mark.as_char() == ':' && !path.is_empty() && !path.ends_with("::") => {
                    path.push(':');
                }
                _ => {
                    self.used.insert(std::mem::take(&mut path));
                    if let TokenTree::Ident(name) = &token {
                        path = name.to_string();
                    }
                }
            }
            if let TokenTree::Group(group) = token {
                self.add_tokens(group.stream());
            }
        }
        self.used.insert(path);
        // between two marks there is no name
        self.used.remove("");
    }
}

impl<'code> Visit<'code> for Paths {
    fn visit_item_use(&mut self, item: &'code ItemUse) {
        self.add_use_tree(!matches!(item.vis, Visibility::Inherited), "", &item.tree);
    }

    fn visit_path(&mut self, path: &'code syn::Path) {
        let names: Vec<String> = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        self.used.insert(names.join("::"));
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, call: &'code Macro) {
        self.visit_path(&call.path);
        self.add_tokens(call.tokens.clone());
    }

    fn visit_attribute(&mut self, attribute: &'code Attribute) {
        if let Meta::List(list) = &attribute.meta {
            self.add_tokens(list.tokens.clone());
        }
    }

    /// A visibility does not use the module that it names.
    fn visit_vis_restricted(&mut self, _: &'code VisRestricted) {}

    fn visit_item_mod(&mut self, module: &'code ItemMod) {
        let is_test = |attribute: &Attribute| {
            attribute.path().is_ident("cfg") && attribute.parse_args::<syn::Ident>().is_ok_and(|name| name == "test")
        };
        if !module.attrs.iter().any(is_test) {
            visit::visit_item_mod(self, module);
        }
    }
}

/// The crate as a graph: every file, and the files it uses.
static GRAPH: LazyLock<BTreeMap<Module, BTreeSet<Module>>> = LazyLock::new(|| {
    let sources = sources();
    let modules: BTreeSet<Module> = sources.iter().map(|(module, _)| module.clone()).collect();
    let absolute = |module: &Module, path: &str| -> Option<Vec<String>> {
        let mut parts = path.split("::").map(str::to_owned).peekable();
        let mut at = match parts.next()?.as_str() {
            "crate" => Vec::new(),
            "self" => module.clone(),
            "super" => module[..module.len().saturating_sub(1)].to_vec(),
            first if modules.contains(&[module.as_slice(), &[first.to_owned()]].concat()) => {
                [module.as_slice(), &[first.to_owned()]].concat()
            }
            _ => return None,
        };
        while parts.peek().is_some_and(|part| part == "super") {
            parts.next();
            at.pop();
        }
        at.extend(parts);
        Some(at)
    };
    // what the front file of a folder re-exports, and from where
    let mut exports: BTreeMap<Vec<String>, Vec<String>> = BTreeMap::new();
    for (module, paths) in &sources {
        for path in &paths.exported {
            if let Some(target) = absolute(module, path) {
                exports.insert([module.as_slice(), &[target.last().unwrap().clone()]].concat(), target);
            }
        }
    }
    let file_of = |path: &[String]| -> Module {
        let mut path = path.to_vec();
        for _ in 0..8 {
            let hit = (1..=path.len()).rev().find_map(|n| Some((n, exports.get(&path[..n])?)));
            let Some((n, target)) = hit.filter(|(n, target)| **target != path[..*n]) else { break };
            path = [target.as_slice(), &path[n..]].concat();
        }
        (0..=path.len()).rev().map(|n| path[..n].to_vec()).find(|module| modules.contains(module)).unwrap()
    };
    let mut graph = BTreeMap::new();
    for (module, paths) in &sources {
        // a plain name may be a name that the file re-exports
        let own = |path: &String| match exports.get(&[module.as_slice(), std::slice::from_ref(path)].concat()) {
            Some(target) => Some(target.clone()),
            None if path.contains("::") => absolute(module, path),
            None => None,
        };
        let used = paths
            .used
            .iter()
            .filter_map(own)
            .map(|path| file_of(&path))
            .filter(|used| used != module && !used.is_empty())
            .collect();
        graph.insert(module.clone(), used);
    }
    graph
});

#[test]
fn folders_use_only_lower_layers() {
    let floors = layers();
    let place =
        |module: &Module| module.first().and_then(|folder| floors.iter().position(|floor| floor.contains(folder)));
    let mut wrong = Vec::new();
    for (module, used) in GRAPH.iter() {
        if place(module).is_none() && !module.is_empty() {
            wrong.push(format!("{} stands on no floor of src/README.md", module.join("/")));
        }
        for other in used {
            if module.first() == other.first() {
                continue;
            }
            if let (Some(here), Some(there)) = (place(module), place(other))
                && there >= here
            {
                wrong.push(format!("{} uses {}", module.join("/"), other.join("/")));
            }
        }
    }
    assert!(wrong.is_empty(), "arrows that run up or sideways:\n{}", wrong.join("\n"));
}

#[test]
fn file_dependencies_are_acyclic() {
    let graph = &*GRAPH;
    // files that reach each other are in one circle
    let reach: BTreeMap<&Module, BTreeSet<&Module>> = graph
        .keys()
        .map(|start| {
            let (mut seen, mut open) = (BTreeSet::new(), vec![start]);
            while let Some(next) = open.pop() {
                for used in &graph[next] {
                    if seen.insert(used) {
                        open.push(used);
                    }
                }
            }
            (start, seen)
        })
        .collect();
    let mut circles: BTreeSet<Vec<String>> = BTreeSet::new();
    for (module, seen) in &reach {
        if seen.contains(*module) {
            let circle = seen.iter().filter(|other| reach[**other].contains(*module)).map(|other| other.join("/"));
            circles.insert(circle.collect());
        }
    }
    let circles: Vec<String> = circles.into_iter().map(|circle| circle.join(", ")).collect();
    assert!(circles.is_empty(), "circles of files:\n{}", circles.join("\n"));
}

/// A test of the reader itself.
#[test]
fn use_trees_are_expanded() {
    let paths = Paths::of(
        r#"pub use a::B;
        pub(crate) use crate::law::{self, Law, curve::{Piece, Shape as S}};
        pub(in crate::report) fn f() { let x = m::f(super::y); x.n(); format!("{} {}", c::D::new(1), "e::f") }
        #[cfg(test)]
        mod tests { use super::g::h; }"#,
    );
    let exported = ["a::B", "crate::law", "crate::law::Law", "crate::law::curve::Piece", "crate::law::curve::Shape"];
    assert_eq!(Vec::from_iter(paths.exported), exported);
    let used: Vec<String> = paths.used.into_iter().filter(|path| path.contains("::")).collect();
    assert_eq!(used, ["c::D::new", "m::f", "super::y"]);
}
