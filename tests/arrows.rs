//! Checks which files of `src` use each other: the folders have one order, and no files use each other in a circle.
//!
//! A use is a path that begins with `crate::`, `super::` or `self::`, or with the name of a file in the same folder, in
//! a `use` line or in the code. The used file is the one that defines the name: a re-export (`pub use`) in the front
//! file of a folder is followed to its definition. A re-export itself is not a use, unless the front file uses the name
//! in its code. Tests inside of a file are ignored.

#![allow(clippy::unwrap_used)]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The folders (and single files) of `src`, the lowest first. Each may use itself and those on lines before it. Names
/// on one line do not use each other. Every folder has to be listed here.
const ORDER: &[&[&str]] = &[
    &["error", "math", "progress", "provenance"],
    &["units", "output"],
    &["material", "strength"],
    &["law", "integrate", "materials"],
    &["impact", "reference"],
    &["indentation", "compare", "repeat"],
    &["scene"],
    &["plan"],
    &["scenario", "sweep"],
    &["calibrate"],
    &["plot", "fit"],
    &["report", "validation"],
    &["run", "bench"],
    &["capi", "export", "python"],
    &["cli", "main"],
];

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
            if module == ["lib"] {
                module.clear();
            }
            // the command uses the library by the name of its crate
            let text = fs::read_to_string(path).unwrap().replace("plm_impact::", "crate::");
            Source { module, code: stripped(&text) }
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
fn stripped(text: &str) -> String {
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

/// All paths of a `use` tree such as `crate::law::{Law, curve::{Piece, Shape}}`.
fn leaves(tree: &str) -> Vec<String> {
    let tree = tree.trim();
    let Some((head, inner)) = tree.split_once('{') else {
        return vec![tree.split(" as ").next().unwrap().trim().to_owned()];
    };
    let inner = inner.trim_end().strip_suffix('}').unwrap_or(inner);
    let (mut depth, mut start, mut parts) = (0, 0, Vec::new());
    for (at, c) in inner.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                parts.push(&inner[start..at]);
                start = at + 1;
            }
            _ => {}
        }
    }
    parts.push(&inner[start..]);
    parts
        .into_iter()
        .filter(|part| !part.trim().is_empty())
        .flat_map(leaves)
        .map(|leaf| if leaf == "self" { head.trim_end_matches("::").to_owned() } else { format!("{head}{leaf}") })
        .collect()
}

/// The `use` statements of a file (whether public, and the tree), and the code without them and without `mod` lines.
fn uses(code: &str) -> (Vec<(bool, String)>, String) {
    let (mut found, mut rest) = (Vec::new(), String::new());
    let mut statement: Option<(bool, String)> = None;
    for line in code.lines() {
        let trimmed = line.trim_start();
        let public = trimmed.starts_with("pub use ")
            || trimmed.starts_with("pub(crate) use ")
            || trimmed.starts_with("pub(super) use ");
        if statement.is_none() && (public || trimmed.starts_with("use ")) {
            statement = Some((public, String::new()));
        }
        if let Some((_, text)) = &mut statement {
            text.push_str(trimmed);
            text.push(' ');
            if trimmed.ends_with(';') {
                let (public, text) = statement.take().unwrap();
                let tree = text.trim_end().trim_end_matches(';').split_once("use ").unwrap().1.to_owned();
                found.push((public, tree));
            }
        } else if !trimmed.contains("mod ") {
            rest.push_str(line);
            rest.push('\n');
        }
    }
    (found, rest)
}

/// Names and paths in the code itself: `Piece`, `crate::law::Law`.
fn inline(code: &str) -> BTreeSet<String> {
    let is_part = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    code.replace("pub(in ", "")
        .split(|c| !is_part(c))
        .map(|path| path.trim_end_matches(':'))
        .filter(|path| path.starts_with(char::is_alphabetic))
        .map(str::to_owned)
        .collect()
}

/// The crate as a graph: every file, and the files it uses.
fn graph() -> BTreeMap<Module, BTreeSet<Module>> {
    let sources = sources();
    let modules: BTreeSet<Module> = sources.iter().map(|source| source.module.clone()).collect();
    let parsed: Vec<_> = sources.iter().map(|source| (source.module.clone(), uses(&source.code))).collect();
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
    for (module, (statements, _)) in &parsed {
        for (_, tree) in statements.iter().filter(|(public, _)| *public) {
            for leaf in leaves(tree) {
                let name = leaf.rsplit("::").next().unwrap().to_owned();
                if let Some(target) = absolute(module, &leaf) {
                    exports.insert([module.as_slice(), &[name]].concat(), target);
                }
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
    for (module, (statements, code)) in &parsed {
        let named = statements.iter().filter(|(public, _)| !public).flat_map(|(_, tree)| leaves(tree));
        // a plain name may be a name that the file re-exports
        let own = |path: String| match exports.get(&[module.as_slice(), std::slice::from_ref(&path)].concat()) {
            Some(target) => Some(target.clone()),
            None if path.contains("::") => absolute(module, &path),
            None => None,
        };
        let used: BTreeSet<Module> = named
            .filter_map(|path| absolute(module, &path))
            .chain(inline(code).into_iter().filter_map(own))
            .map(|path| file_of(&path))
            .filter(|used| used != module && !used.is_empty())
            .collect();
        graph.insert(module.clone(), used);
    }
    graph
}

#[test]
fn folders_use_only_what_stands_below_them() {
    let place = |module: &Module| {
        ORDER.iter().position(|side_by_side| side_by_side.contains(&module.first().map_or("", String::as_str)))
    };
    let mut wrong = Vec::new();
    for (module, used) in graph() {
        if place(&module).is_none() && !module.is_empty() {
            wrong.push(format!("{} has no place in the order", module.join("/")));
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
fn no_files_form_a_circle() {
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

/// A test of the reader of `use` trees itself.
#[test]
fn a_use_tree_is_read_to_its_leaves() {
    assert_eq!(
        leaves("crate::law::{self, Law, curve::{Piece, Shape as S}}"),
        ["crate::law", "crate::law::Law", "crate::law::curve::Piece", "crate::law::curve::Shape"]
    );
    assert!(
        inline("let x = crate::power::power(super::y);")
            .is_superset(&["crate::power::power", "super::y"].map(str::to_owned).into())
    );
    let (statements, rest) = uses("pub use a::B;\nuse super::{\n    C,\n};\nfn f() {}\n");
    assert_eq!(statements, [(true, "a::B".to_owned()), (false, "super::{ C, }".to_owned())]);
    assert_eq!(rest.trim(), "fn f() {}");
}
