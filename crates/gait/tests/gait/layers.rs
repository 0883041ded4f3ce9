//! The order of the crate's folders, held against the sources: none uses a later one, and siblings do not use each other.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// A module by its way from the crate's root: `["smooth", "walk", "plan"]`.
type Module = Vec<String>;

/// Reads all modules below a folder: the sources without comments and without their own tests.
fn read(folder: &Path, at: &Module, all: &mut BTreeMap<Module, String>) {
    for entry in fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("an entry").path();
        let mut module = at.clone();
        module.push(path.file_stem().expect("a name").to_string_lossy().into_owned());
        if path.is_dir() {
            read(&path, &module, all);
        } else if module != ["lib"] {
            let text = fs::read_to_string(&path).expect("a source");
            let code = text.split("#[cfg(test)]").next().unwrap_or_default();
            let lines = code.lines().map(|line| line.split("//").next().unwrap_or_default());
            all.insert(module, lines.collect::<Vec<_>>().join("\n"));
        }
    }
}

/// Every path that starts with `crate` or `super` in a source, with each name of a brace of its own, from the crate's root.
fn paths(module: &Module, code: &str) -> Vec<Module> {
    let mut found = Vec::new();
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    for start in ["crate::", "super::"] {
        for (at, _) in code.match_indices(start) {
            if code[..at].ends_with(|c: char| is_name(c) || c == ':') {
                continue;
            }
            let mut rest = &code[at..];
            let mut way = if start == "crate::" { Vec::new() } else { module.clone() };
            loop {
                let end = rest.find(|c: char| !is_name(c)).unwrap_or(rest.len());
                let (name, after) = rest.split_at(end);
                match name {
                    "crate" => {}
                    "super" => drop(way.pop()),
                    _ => way.push(name.to_owned()),
                }
                let Some(next) = after.strip_prefix("::") else { break };
                rest = next;
                if let Some(inside) = rest.strip_prefix('{') {
                    let inside = inside.split('}').next().unwrap_or_default();
                    let names =
                        inside.split(',').map(|name| name.trim().split("::").next().unwrap_or_default());
                    found.extend(names.map(|name| [&way[..], &[name.to_owned()]].concat()));
                    break;
                }
            }
            found.push(way);
        }
    }
    found
}

/// Which module uses which, among the children of each folder; the root's are of the folder `[]`.
fn uses() -> BTreeMap<Module, BTreeSet<(String, String)>> {
    let mut all = BTreeMap::new();
    read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &Vec::new(), &mut all);
    let mut uses: BTreeMap<Module, BTreeSet<(String, String)>> = BTreeMap::new();
    for (module, code) in &all {
        for mut target in paths(module, code) {
            while !target.is_empty() && !all.contains_key(&target) {
                target.pop();
            }
            let shared = module.iter().zip(&target).take_while(|(a, b)| a == b).count();
            // What belongs to a parent or a child is no pair of siblings.
            if let (Some(user), Some(used)) = (module.get(shared), target.get(shared)) {
                let pair = (user.clone(), used.clone());
                uses.entry(module[..shared].to_vec()).or_default().insert(pair);
            }
        }
    }
    uses
}

#[test]
fn folders_use_only_those_before_them() {
    let docs = include_str!("../../src/lib.rs");
    let line = docs.lines().find(|line| line.contains(" < ")).expect("the order is written down");
    let order: Vec<&str> = line.trim_start_matches("//!").split('<').map(str::trim).collect();
    let place = |name: &str| order.iter().position(|known| *known == name);
    let root = &uses()[&Vec::new()];
    assert!(root.len() > 20, "the sources are read: {root:?}");
    for (user, used) in root {
        let (Some(above), Some(below)) = (place(user), place(used)) else {
            panic!("'{user}' or '{used}' is not in the order of lib.rs");
        };
        assert!(above > below, "'{user}' uses '{used}', which comes after it");
    }
}

#[test]
fn siblings_do_not_use_each_other() {
    for (folder, pairs) in uses() {
        let mut left = pairs.clone();
        // Takes away what uses nothing that is left, until nothing is, or only rings.
        loop {
            let users: BTreeSet<String> = left.iter().map(|(user, _)| user.clone()).collect();
            let before = left.len();
            left.retain(|(_, used)| users.contains(used));
            if left.len() == before {
                break;
            }
        }
        assert!(left.is_empty(), "in '{}' a ring: {left:?}", folder.join("/"));
    }
}
