//! The pages are a book: each stands in its contents once, and no link leads nowhere.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().expect("the project")
}

/// The Markdown files below a folder.
fn pages(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            found.extend(pages(&path));
        } else if path.extension().is_some_and(|extension| extension == "md") {
            found.push(path);
        }
    }
    found
}

/// The text without its blocks of code, and without what stands in backquotes.
fn prose(text: &str) -> String {
    let mut inside = false;
    let mut kept = String::new();
    for line in text.lines() {
        if line.trim_start().starts_with("```") {
            inside = !inside;
        } else if !inside {
            kept.extend(line.split('`').step_by(2).flat_map(|part| [part, " "]));
            kept.push('\n');
        }
    }
    kept
}

/// Where links of a text lead within the project.
fn links(text: &str) -> Vec<String> {
    let ends = prose(text);
    let targets = ends.split("](").skip(1).filter_map(|rest| rest.split_once(')').map(|(target, _)| target));
    targets
        .filter(|target| !target.contains("://") && !target.starts_with("mailto:"))
        .map(str::to_owned)
        .collect()
}

/// What a heading is called in a link.
fn anchor(heading: &str) -> String {
    let kept = heading.trim().chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
    kept.collect::<String>().to_lowercase().replace(' ', "-")
}

fn anchors(text: &str) -> BTreeSet<String> {
    let mut inside = false;
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    let mut found = BTreeSet::new();
    for line in text.lines() {
        if line.starts_with("```") {
            inside = !inside;
        }
        let Some(heading) = line.strip_prefix('#').filter(|_| !inside) else { continue };
        // Of a link its words count.
        let heading = heading.trim_start_matches('#').replace("](", "\0");
        let words = heading.split('\0').enumerate();
        let plain: String = words
            .map(|(i, part)| if i == 0 { part } else { part.split_once(')').map_or("", |(_, rest)| rest) })
            .collect();
        let name = anchor(&plain);
        let count = seen.entry(name.clone()).or_default();
        found.insert(if *count == 0 { name } else { format!("{name}-{count}") });
        *count += 1;
    }
    found
}

#[test]
fn every_page_stands_in_the_contents_once() {
    let docs = root().join("docs");
    let summary = fs::read_to_string(docs.join("SUMMARY.md")).expect("the contents");
    let mut named: Vec<PathBuf> = links(&summary).iter().map(|target| docs.join(target)).collect();
    named.push(docs.join("SUMMARY.md"));
    named.sort();
    let mut all = pages(&docs);
    all.sort();
    assert_eq!(named, all);
}

#[test]
fn no_link_leads_nowhere() {
    let root = root();
    let mut all = pages(&root.join("docs"));
    all.extend(
        ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md"].map(|name| root.join(name)),
    );
    let (mut dead, mut count) = (Vec::new(), 0);
    for page in all {
        let text = fs::read_to_string(&page).expect("a page");
        for link in links(&text) {
            count += 1;
            let (path, name) = link.split_once('#').unwrap_or((&link, ""));
            let target =
                if path.is_empty() { page.clone() } else { page.parent().expect("a folder").join(path) };
            let is_there = target.exists()
                && (name.is_empty()
                    || target.extension().is_none_or(|extension| extension != "md")
                    || anchors(&fs::read_to_string(&target).expect("a page")).contains(name));
            if !is_there {
                dead.push(format!("{}: {link}", page.strip_prefix(&root).unwrap_or(&page).display()));
            }
        }
    }
    assert!(count > 400, "only {count} links were found");
    assert!(dead.is_empty(), "{}", dead.join("\n"));
}
