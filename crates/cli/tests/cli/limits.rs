//! The page of limits against the constants of the code.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// Crates that read what others wrote.
const READERS: [&str; 7] = ["cli", "files", "io", "model", "profiles", "scene", "text"];

/// Constants of such names that limit no input: what is shown of many things, what is looked at for hints, what a format holds or a formula
/// takes.
const OTHERS: [(&str, &str); 22] = [
    ("cli/src/profile/summary.rs", "MOST_KEYS"),
    ("cli/src/underline.rs", "MOST_SHOWN"),
    ("io/src/c3d/layout.rs", "MOST"),
    ("io/src/clip/bones.rs", "MOST_RENAMED"),
    ("io/src/error.rs", "MOST"),
    ("io/src/mjcf.rs", "DEEPEST"),
    ("io/src/record/columns.rs", "MOST_COMPARED"),
    ("io/src/record/columns.rs", "MOST_HINTS"),
    ("io/src/record/forces.rs", "MOST_HEADINGS"),
    ("io/src/table.rs", "MOST"),
    ("model/src/configuration.rs", "MOST"),
    ("model/src/human.rs", "MOST_LOAD"),
    ("model/src/lint/inertia.rs", "MOST_GYRATION"),
    ("model/src/lint/mirror.rs", "FARTHEST"),
    ("model/src/lint/sides.rs", "LONGEST"),
    ("profiles/src/displacement/exponential.rs", "MOST"),
    ("scene/src/read/apart.rs", "MOST_IN_VAIN"),
    ("scene/src/read/apart.rs", "MOST_OF_PAIR"),
    ("scene/src/read/drives.rs", "MOST_IN_REPEAT"),
    ("scene/src/read/places.rs", "MOST_TOLD"),
    ("text/src/layout.rs", "WIDEST"),
    ("text/src/nearest.rs", "LONGEST_NAME"),
];

fn crates() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("a folder").to_owned()
}

/// The number that an expression of the code or a cell of the page is.
fn number(text: &str) -> f64 {
    let plain = text.replace(['_', ' '], "");
    let one = |text: &str| text.parse::<f64>().unwrap_or_else(|_| panic!("'{text}' is no number"));
    match plain.split_once("<<") {
        Some((number, by)) => one(number) * 2_f64.powf(one(by)),
        None => one(&plain),
    }
}

/// The constants of a file, each with what it is said to be.
fn constants(code: &str) -> Vec<(String, String)> {
    let of = |line: &str| {
        let (_, rest) = line.trim().split_once("const ").filter(|(before, _)| !before.contains("//"))?;
        let (name, rest) = rest.split_once(':')?;
        let (_, value) = rest.split_once('=')?;
        Some((name.to_owned(), value.trim().trim_end_matches(';').to_owned()))
    };
    code.lines().filter_map(of).collect()
}

/// The limits of the page, by file and name.
fn page() -> BTreeMap<(String, String), f64> {
    let page = fs::read_to_string(crates().join("../docs/limits.md")).expect("the page");
    let rows = page.lines().filter(|line| line.starts_with("| ") && line.contains('`'));
    let limit = |row: &str| {
        let cells: Vec<&str> =
            row.trim_matches('|').split('|').map(|cell| cell.trim().trim_matches('`')).collect();
        let [.., value, name, file] = cells[..] else { return None };
        (name != "constant").then(|| ((file.to_owned(), name.to_owned()), number(value)))
    };
    rows.filter_map(limit)
        .filter(|((file, _), _)| Path::new(file).extension().is_some_and(|end| end == "rs"))
        .collect()
}

#[test]
fn the_page_says_what_the_code_does() {
    let page = page();
    assert!(page.len() > 50, "{}", page.len());
    for ((file, name), value) in &page {
        let code = fs::read_to_string(crates().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"));
        let found = constants(&code).into_iter().find(|(own, _)| own == name);
        let (_, text) =
            found.unwrap_or_else(|| panic!("docs/limits.md names {name} of {file}, which is not there"));
        assert!(
            (number(&text) - value).abs() <= 1e-12 * value,
            "docs/limits.md: {name} of {file} is {text}, not {value}"
        );
    }
}

#[test]
fn no_limit_of_what_is_read_is_missing_on_the_page() {
    let (page, mut missing) = (page(), Vec::new());
    let begins = [
        "MOST",
        "DEEPEST",
        "LARGEST",
        "LONGEST",
        "FARTHEST",
        "HEAVIEST",
        "HIGHEST",
        "WIDEST",
        "NODES",
        "ATTRIBUTES",
        "NAMESPACES",
    ];
    let mut open: Vec<PathBuf> = READERS.iter().map(|name| crates().join(name).join("src")).collect();
    while let Some(path) = open.pop() {
        if let Ok(inside) = fs::read_dir(&path) {
            open.extend(inside.map(|entry| entry.expect("an entry").path()));
            continue;
        }
        let file = path.strip_prefix(crates()).expect("within").to_string_lossy().replace('\\', "/");
        let Ok(code) = fs::read_to_string(&path) else { continue };
        for (name, _) in constants(&code) {
            let is_limit = begins.iter().any(|begin| name.starts_with(begin));
            let known =
                OTHERS.contains(&(&*file, &*name)) || page.contains_key(&(file.clone(), name.clone()));
            if is_limit && !known {
                missing.push(format!("{name} of {file}"));
            }
        }
    }
    assert!(missing.is_empty(), "docs/limits.md does not name {missing:?}");
}
