//! What fuzzing begins with: the files of the fixtures and tests, the texts in the code of readers and tests, and as
//! dictionaries all words that readers know.

use super::literals::literals;
use crate::workspace::root;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The longest seed (bytes), and the most lines of a table.
const LONGEST: usize = 65_536;
const MOST_LINES: usize = 30;

/// Lengths of the seeds of targets that take bytes as numbers.
const LENGTHS: [usize; 6] = [16, 48, 96, 192, 384, 1536];

/// Of each target, the files and folders of `crates` whose words it knows.
const WORDS: [(&str, &[&str]); 20] = [
    ("bvh", &["io/src/bvh", "model/src/rig.rs"]),
    ("c3d", &["io/src/c3d", "io/src/markers"]),
    ("csv", &["io/src/csv", "io/src/record", "io/src/table.rs", "io/src/headings.rs"]),
    // Their inputs are numbers, and no text.
    ("drives", &[]),
    ("encoding", &["io/src/encoding.rs"]),
    ("external_loads", &["io/src/opensim/loads.rs", "io/tests/io/opensim_loads.rs"]),
    ("figure", &["model/src/text", "model/src/human.rs"]),
    ("glb", &["io/src/glb", "io/src/rig", "io/tests/io/retarget"]),
    ("mjcf", &["io/src/mjcf.rs", "io/src/mjcf", "io/tests/io/mjcf"]),
    ("opensim", &["io/src/opensim.rs", "io/src/opensim", "io/tests/io/opensim_faults.rs"]),
    ("page", &[]),
    ("profile", &["profiles/src/text", "profiles/src/profile"]),
    ("scene", &["scene/src", "model/src/text", "profiles/src/text"]),
    ("sdf", &["io/src/sdf.rs", "io/src/sdf", "io/tests/io/sdf"]),
    ("setups", &["io/src/opensim/setup.rs", "io/src/opensim/setup"]),
    ("soles", &["scene/src/soles.rs", "model/src/text"]),
    ("sto", &["io/src/sto.rs", "io/src/sto", "io/src/record", "io/src/table.rs"]),
    ("trc", &["io/src/trc", "io/src/markers"]),
    ("urdf", &["io/src/urdf.rs", "io/src/urdf", "io/tests/io/urdf"]),
    ("walker", &[]),
];

/// Writes `corpus/seeds/TARGET/*` and `dictionaries/TARGET`, and makes `corpus/TARGET`.
pub(super) fn write(folder: &Path) -> Result<(), String> {
    let failed = |error: std::io::Error| format!("the seeds of fuzzing: {error}");
    let crates = root().join("crates");
    let mut seeds: BTreeMap<&str, BTreeSet<Vec<u8>>> = BTreeMap::new();
    let mut add = |target, bytes: Vec<u8>| {
        if bytes.len() <= LONGEST {
            seeds.entry(target).or_default().insert(bytes);
        }
    };
    for path in files(&[crates.clone(), root().join("fixtures"), folder.join("seeds")]) {
        let bytes = fs::read(&path).map_err(failed)?;
        let binary = ["c3d", "glb"]
            .into_iter()
            .find(|own| path.extension().is_some_and(|extension| extension == *own));
        if let Some(target) = binary {
            add(target, bytes);
            continue;
        }
        let Ok(text) = String::from_utf8(bytes) else { continue };
        if path.extension().is_some_and(|extension| extension == "rs") {
            for text in literals(&text) {
                if let Some(target) = target_of(&path, &text) {
                    add(target, text.into());
                }
            }
        } else if let Some(target) = target_of(&path, &text) {
            add(target, head(&path, &text));
        }
    }
    for (target, places) in WORDS {
        let own = folder.join("corpus/seeds").join(target);
        // Those of an earlier state of the code go.
        if own.exists() {
            fs::remove_dir_all(&own).map_err(failed)?;
        }
        fs::create_dir_all(&own).map_err(failed)?;
        fs::create_dir_all(folder.join("corpus").join(target)).map_err(failed)?;
        let mut seeds = seeds.remove(target).unwrap_or_default();
        if places.is_empty() {
            seeds.extend(LENGTHS.map(any_bytes));
        }
        for (i, bytes) in seeds.iter().enumerate() {
            fs::write(own.join(format!("{i}")), bytes).map_err(failed)?;
        }
        let places: Vec<PathBuf> = places.iter().map(|place| crates.join(place)).collect();
        fs::create_dir_all(folder.join("dictionaries")).map_err(failed)?;
        fs::write(folder.join("dictionaries").join(target), dictionary(&places)).map_err(failed)?;
    }
    Ok(())
}

/// The target that reads a text of the file at `path`.
fn target_of(path: &Path, text: &str) -> Option<&'static str> {
    let begins = |words: &[&str]| words.iter().any(|word| text.trim_start().starts_with(word));
    let within = |folder: &str| path.to_string_lossy().contains(folder);
    Some(match path.extension()?.to_str()? {
        "mot" | "sto" => "sto",
        "csv" => "csv",
        "trc" => "trc",
        "rs" | "ron" | "urdf" | "osim" | "xml" | "sdf" | "bvh" | "mjcf" | "snap" => match text {
            _ if text.len() < 12 => return None,
            _ if text.contains("HIERARCHY") => "bvh",
            _ if within(".snap") => return None,
            _ if text.contains("<robot") => "urdf",
            _ if text.contains("<sdf") => "sdf",
            _ if text.contains("<mujoco") => "mjcf",
            _ if text.contains("<ExternalLoads") => "external_loads",
            _ if text.contains("<ScaleTool") || text.contains("<InverseKinematicsTool") => "setups",
            _ if text.contains("<OpenSimDocument") => "opensim",
            _ if text.contains("endheader") => "sto",
            _ if text.contains("Scene(") => "scene",
            _ if begins(&["Soles("]) => "soles",
            _ if text.contains("Figure(") || begins(&["Human("]) => "figure",
            _ if within("crates/profiles") && begins_a_group(text) => "profile",
            _ if within("io/csv") && text.contains(',') => "csv",
            _ => return None,
        },
        _ => return None,
    })
}

/// Whether a text is a word of a capital letter and a bracket.
fn begins_a_group(text: &str) -> bool {
    let name = text.split('(').next().unwrap_or_default();
    name.len() < text.len() && name.starts_with(char::is_uppercase) && name.chars().all(char::is_alphanumeric)
}

/// A seed of a file: of a table its beginning, of a snapshot what comes after its head, of a model in several files all.
fn head(path: &Path, text: &str) -> Vec<u8> {
    match path.extension().and_then(|extension| extension.to_str()) {
        Some("mot" | "sto" | "csv") => text.split_inclusive('\n').take(MOST_LINES).collect::<String>().into(),
        Some("snap") => text.splitn(3, "---\n").last().unwrap_or_default().into(),
        _ => {
            let folder = path.parent().unwrap_or(path);
            let mut whole = text.as_bytes().to_vec();
            for other in files(&[folder.join("parts")]) {
                if let (Ok(part), Ok(name)) = (fs::read(&other), other.strip_prefix(folder)) {
                    whole.extend(format!("\n==== {}\n", name.display()).bytes());
                    whole.extend(part);
                }
            }
            whole
        }
    }
}

/// All files of these folders and those in them, in the order of their names.
fn files(folders: &[PathBuf]) -> BTreeSet<PathBuf> {
    let (mut found, mut open) = (BTreeSet::new(), folders.to_vec());
    while let Some(path) = open.pop() {
        if path.is_file() {
            found.insert(path);
        } else if let Ok(inside) = fs::read_dir(&path) {
            open.extend(inside.filter_map(|entry| Some(entry.ok()?.path())));
        }
    }
    found
}

/// So many bytes of all kinds, the same each time.
fn any_bytes(length: usize) -> Vec<u8> {
    let mut state = length as u64;
    let mut next = || {
        // Splitmix64.
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let x = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        ((x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb) >> 56) as u8
    };
    (0..length).map(|_| next()).collect()
}

/// The words and short pieces of markup in the code of these files, as libFuzzer reads them.
fn dictionary(places: &[PathBuf]) -> String {
    const MOST: usize = 60;
    let mut words = BTreeSet::new();
    for path in
        files(places).iter().filter(|path| path.extension().is_some_and(|extension| extension == "rs"))
    {
        for text in fs::read_to_string(path).iter().flat_map(|code| literals(code)) {
            let plain = |c: char| c.is_ascii_alphanumeric() || "_-:/.".contains(c);
            let is_word = text.len() > 1 && text.chars().all(plain);
            if text.len() <= MOST
                && text.is_ascii()
                && (is_word || text.starts_with('<'))
                && !text.contains('{')
            {
                words.insert(text);
            }
        }
    }
    let quoted = |word: &String| {
        let escape = |c: char| match c {
            '"' | '\\' => format!("\\{c}"),
            ' '..='~' => c.to_string(),
            _ => format!("\\x{:02x}", u32::from(c)),
        };
        format!("\"{}\"\n", word.chars().map(escape).collect::<String>())
    };
    // Without anything in it, libFuzzer would not start.
    std::iter::once("# The words of its reader.\n".to_owned()).chain(words.iter().map(quoted)).collect()
}
