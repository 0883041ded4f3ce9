//! The bill of materials of the program: every crate that it is made of, as `CycloneDX` 1.5.
//!
//! Of what `cargo metadata` resolves and of the hashes in `Cargo.lock`, in a hundred lines: cargo-cyclonedx writes a file a crate
//! beside each manifest and cannot leave out what only tests use, and would have to be installed.

use super::Done;
use super::state::{State, text};
use crate::workspace::cargo;
use serde::Deserialize;
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;

/// What `cargo metadata` says with all dependencies.
#[derive(Debug, Deserialize)]
pub(super) struct Resolved {
    pub(super) packages: Vec<Crate>,
    resolve: Graph,
}

#[derive(Debug, Deserialize)]
struct Graph {
    nodes: Vec<Node>,
}

/// A crate of the graph, with those that it uses.
#[derive(Debug, Deserialize)]
struct Node {
    id: String,
    deps: Vec<Edge>,
}

#[derive(Debug, Deserialize)]
struct Edge {
    pkg: String,
    dep_kinds: Vec<Kind>,
}

#[derive(Debug, Deserialize)]
struct Kind {
    /// `None` for what is used at run time.
    kind: Option<String>,
}

/// A crate, whoever's.
#[derive(Debug, Deserialize)]
pub(super) struct Crate {
    id: String,
    pub(super) name: String,
    pub(super) version: String,
    pub(super) rust_version: Option<String>,
    license: Option<String>,
    description: Option<String>,
    source: Option<String>,
}

/// The workspace with all that it stands on.
pub(super) fn resolved() -> Result<Resolved, String> {
    let output = cargo().args(["metadata", "--format-version", "1", "--locked"]).output();
    let output = output.map_err(|error| format!("cargo metadata does not start: {error}"))?;
    if !output.status.success() {
        return Err(format!("cargo metadata failed:\n{}", String::from_utf8_lossy(&output.stderr)));
    }
    serde_json::from_slice(&output.stdout)
        .map_err(|error| format!("cargo metadata is not understood: {error}"))
}

/// Writes it beside the packages.
pub(super) fn write(state: &State) -> Result<Done, String> {
    let resolved = resolved()?;
    let bill = bill(&resolved, &hashes(&text("Cargo.lock")?), "solaris-cli")?;
    let count = bill["components"].as_array().map_or(0, Vec::len);
    let path = state.folder().join(format!("solaris-{}.cdx.json", state.version()));
    let text = serde_json::to_string_pretty(&bill).map_err(|error| error.to_string())?;
    fs::create_dir_all(state.folder())
        .and_then(|()| fs::write(&path, text + "\n"))
        .map_err(|error| error.to_string())?;
    Ok(Done::Holds(format!("{count} crates, in {}", path.display())))
}

/// The hash of each crate of the registry, by name and version.
fn hashes(lock: &str) -> BTreeMap<(String, String), String> {
    let field = |block: &str, name: &str| {
        let (_, rest) = block.split_once(&format!("\n{name} = \""))?;
        Some(rest.split_once('"')?.0.to_owned())
    };
    let blocks = lock.split("[[package]]");
    blocks
        .filter_map(|block| {
            Some(((field(block, "name")?, field(block, "version")?), field(block, "checksum")?))
        })
        .collect()
}

/// The bill of a crate: all that it uses at run time or to be built, not what tests use.
fn bill(resolved: &Resolved, hashes: &BTreeMap<(String, String), String>, of: &str) -> Result<Value, String> {
    let by_id: BTreeMap<&str, &Crate> =
        resolved.packages.iter().map(|found| (found.id.as_str(), found)).collect();
    let uses: BTreeMap<&str, Vec<&str>> =
        resolved.resolve.nodes.iter().map(|node| (node.id.as_str(), used(node))).collect();
    let root = resolved.packages.iter().find(|found| found.name == of);
    let root = root.ok_or_else(|| format!("there is no crate {of}"))?;
    let (mut reached, mut next) = (BTreeSet::new(), vec![root.id.as_str()]);
    while let Some(id) = next.pop() {
        if reached.insert(id) {
            next.extend(uses.get(id).into_iter().flatten());
        }
    }
    let address = |id: &str| by_id.get(id).map(|found| format!("pkg:cargo/{}@{}", found.name, found.version));
    let mut components = Vec::new();
    let mut dependencies = Vec::new();
    for id in &reached {
        let found = by_id.get(id).ok_or_else(|| format!("cargo metadata does not describe {id}"))?;
        let on: Vec<String> = uses.get(id).into_iter().flatten().filter_map(|id| address(id)).collect();
        dependencies.push(json!({"ref": address(id), "dependsOn": on}));
        if found.id != root.id {
            components.push(component(found, hashes, "library")?);
        }
    }
    Ok(json!({
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": {"component": component(root, hashes, "application")?},
        "components": components,
        "dependencies": dependencies,
    }))
}

/// What a crate uses outside of its tests.
fn used(node: &Node) -> Vec<&str> {
    let counts = |edge: &&Edge| edge.dep_kinds.iter().any(|kind| kind.kind.as_deref() != Some("dev"));
    node.deps.iter().filter(counts).map(|edge| edge.pkg.as_str()).collect()
}

fn component(
    found: &Crate,
    hashes: &BTreeMap<(String, String), String>,
    what: &str,
) -> Result<Value, String> {
    let address = format!("pkg:cargo/{}@{}", found.name, found.version);
    let licence = found.license.as_deref().ok_or_else(|| format!("{address} names no licence"))?;
    let mut component = json!({
        "type": what,
        "bom-ref": address,
        "name": found.name,
        "version": found.version,
        // Old manifests write `MIT/Apache-2.0` for the same.
        "licenses": [{"expression": licence.replace('/', " OR ")}],
        "purl": address,
    });
    if let Some(description) = &found.description {
        component["description"] = json!(description.trim());
    }
    if let Some(hash) = hashes.get(&(found.name.clone(), found.version.clone())) {
        component["hashes"] = json!([{"alg": "SHA-256", "content": hash}]);
    } else if found.source.is_some() {
        return Err(format!("{address} has no hash in Cargo.lock"));
    }
    Ok(component)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn small() -> Resolved {
        let text = r#"{
            "packages": [
                {"id": "a", "name": "a", "version": "1.0.0", "rust_version": null, "license": "MIT", "description": null, "source": null},
                {"id": "b", "name": "b", "version": "2.0.0", "rust_version": null, "license": "MIT/Apache-2.0", "description": " B. ", "source": "registry"},
                {"id": "t", "name": "t", "version": "3.0.0", "rust_version": null, "license": null, "description": null, "source": "registry"}
            ],
            "resolve": {"nodes": [
                {"id": "a", "deps": [{"pkg": "b", "dep_kinds": [{"kind": null}]}, {"pkg": "t", "dep_kinds": [{"kind": "dev"}]}]},
                {"id": "b", "deps": []}, {"id": "t", "deps": []}
            ]}
        }"#;
        serde_json::from_str(text).expect("as cargo writes it")
    }

    #[test]
    fn the_bill_lists_what_is_built_in_with_hashes_and_licences_and_nothing_of_tests() {
        let hashes =
            hashes("[[package]]\nname = \"b\"\nversion = \"2.0.0\"\nsource = \"x\"\nchecksum = \"ab12\"\n");
        let bill = bill(&small(), &hashes, "a").expect("a bill");
        assert_eq!(bill["components"].as_array().map(Vec::len), Some(1));
        let b = &bill["components"][0];
        assert_eq!(b["purl"], "pkg:cargo/b@2.0.0");
        assert_eq!(b["licenses"][0]["expression"], "MIT OR Apache-2.0");
        assert_eq!(b["hashes"][0]["content"], "ab12");
        assert_eq!(bill["dependencies"][0]["dependsOn"], json!(["pkg:cargo/b@2.0.0"]));
    }

    #[test]
    fn what_has_no_hash_or_no_licence_is_named() {
        let error = bill(&small(), &BTreeMap::new(), "a").expect_err("b has no hash");
        assert!(error.contains("pkg:cargo/b@2.0.0 has no hash"), "{error}");
        let error = bill(&small(), &BTreeMap::new(), "t").expect_err("t has no licence");
        assert!(error.contains("pkg:cargo/t@3.0.0 names no licence"), "{error}");
    }
}
