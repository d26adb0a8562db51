//! Checks which files of `src` use each other: the folders stand on the floors that src/README.md
//! draws, and no files use each other in a circle.
//!
//! A use is a path that begins with `crate::`, `super::` or `self::`, or with the name of a file in the same folder, in
//! a `use` line or in the code. The used file is the one that defines the name: a re-export (`pub use`) in the front
//! file of a folder is followed to its definition. A re-export itself is not a use, unless the front file uses the name
//! in its code. Tests inside of a file are ignored.

#![allow(clippy::unwrap_used)]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

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

/// One file of `src`: its module and its code.
struct Source {
    module: Module,
    /// The code without comments, strings and tests.
    code: String,
}

fn sources() -> Vec<Source> {
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
            Source { module, code: without_comments_and_strings(&text) }
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

/// The code without line comments, string literals and the tests at its end.
fn without_comments_and_strings(text: &str) -> String {
    let code = text.split("#[cfg(test)]\nmod ").next().unwrap();
    let mut out = String::new();
    for line in code.lines() {
        let mut rest = line.split("//").next().unwrap();
        while let Some((before, after)) = rest.split_once('"') {
            out.push_str(before);
            rest = after.split_once('"').map_or("", |(_, behind)| behind);
        }
        out.push_str(rest);
        out.push('\n');
    }
    out
}

/// The paths in the code, as `crate::law::Law` or `Law`, those of a `use` tree to its leaves, and whether a `pub use` has them.
fn paths(code: &str) -> BTreeSet<(bool, String)> {
    let is_part = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    // what stands before the open braces
    let (mut stems, mut found): (Vec<String>, _) = (Vec::new(), BTreeSet::new());
    let (mut public, mut before) = (false, "");
    // a visibility is no use of the module that it names
    let code = code
        .replace("pub(in crate::", "pub(")
        .replace("pub(crate) use", "pub use")
        .replace("pub(super) use", "pub use");
    for piece in code.split_inclusive(|c| !is_part(c)) {
        let word = piece.trim_end_matches(|c| !is_part(c));
        let stem = stems.last().cloned().unwrap_or_default();
        let path = if word == "self" { stem.clone() } else { format!("{stem}{word}") };
        public = public || (word, before) == ("use", "pub");
        let is_name = word.starts_with(char::is_alphabetic) && word != "as" && !["as", "mod"].contains(&before);
        if is_name && !piece.ends_with("::{") {
            found.insert((public, path.trim_end_matches(':').to_owned()));
        }
        match &piece[word.len()..] {
            "{" => stems.push(if word.ends_with("::") { path } else { String::new() }),
            "}" => drop(stems.pop()),
            ";" => public = false,
            _ => {}
        }
        before = if word.is_empty() { before } else { word };
    }
    found
}

/// The crate as a graph: every file, and the files it uses.
fn graph() -> BTreeMap<Module, BTreeSet<Module>> {
    let sources = sources();
    let modules: BTreeSet<Module> = sources.iter().map(|source| source.module.clone()).collect();
    let parsed: Vec<_> = sources.iter().map(|source| (source.module.clone(), paths(&source.code))).collect();
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
    for (module, paths) in &parsed {
        for (_, path) in paths.iter().filter(|(public, _)| *public) {
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
    for (module, paths) in &parsed {
        // a plain name may be a name that the file re-exports
        let own = |path: &String| match exports.get(&[module.as_slice(), std::slice::from_ref(path)].concat()) {
            Some(target) => Some(target.clone()),
            None if path.contains("::") => absolute(module, path),
            None => None,
        };
        let named = paths.iter().filter(|(public, _)| !public).filter_map(|(_, path)| own(path));
        let used = named.map(|path| file_of(&path)).filter(|used| used != module && !used.is_empty()).collect();
        graph.insert(module.clone(), used);
    }
    graph
}

#[test]
fn folders_use_only_lower_layers() {
    let floors = layers();
    let place =
        |module: &Module| module.first().and_then(|folder| floors.iter().position(|floor| floor.contains(folder)));
    let mut wrong = Vec::new();
    for (module, used) in graph() {
        if place(&module).is_none() && !module.is_empty() {
            wrong.push(format!("{} stands on no floor of src/README.md", module.join("/")));
        }
        for other in used {
            if module.first() == other.first() {
                continue;
            }
            if let (Some(here), Some(there)) = (place(&module), place(&other))
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
    let graph = graph();
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
    let code = "pub use a::B;\npub(crate) use crate::law::{\n    self, Law, curve::{Piece, Shape as S},\n};\nlet x = m::f(super::y);";
    let found = |public: bool| -> Vec<String> {
        let kept = paths(code).into_iter().filter(|(of, path)| *of == public && path.contains("::"));
        kept.map(|(_, path)| path).collect()
    };
    let exported = ["a::B", "crate::law", "crate::law::Law", "crate::law::curve::Piece", "crate::law::curve::Shape"];
    assert_eq!(found(true), exported);
    assert_eq!(found(false), ["m::f", "super::y"]);
}
