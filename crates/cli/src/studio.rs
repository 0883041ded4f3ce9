//! `solaris studio`: the interactive environment as one file.

use crate::args::StudioArgs;
use crate::error::CliError;
use crate::input;
use crate::output::{Formats, Outputs};
use crate::print::print;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde::Serialize;
use std::fs;
use std::path::{Path, PathBuf};

/// The page as `cargo xtask studio` built it.
#[cfg(studio)]
const PAGE: Option<&str> = Some(include_str!(env!("STUDIO_PAGE")));
#[cfg(not(studio))]
const PAGE: Option<&str> = None;

/// The page's first script: what it begins with stands before that.
const BOOT: &str = "<script id=\"boot\">";
/// The most bytes of files that are put into a page.
const MOST_BYTES: usize = 64 << 20;
/// How deep folders are looked through.
const DEEPEST: usize = 4;

const FORMATS: Formats<()> = &[("html", ())];

/// A file that the studio opens when it begins.
#[derive(Debug, Serialize)]
struct GivenFile {
    name: String,
    base64: String,
}

/// Writes the studio, with files in it.
pub(crate) fn run(args: &StudioArgs) -> Result<(), CliError> {
    let outputs = Outputs::new([("-o", &args.output, FORMATS)])?;
    let mut paths: Vec<(String, PathBuf)> = Vec::new();
    for path in &args.files {
        gather(path, "", 0, &mut paths)?;
    }
    outputs.keep_off(paths.iter().map(|(_, path)| path.as_path()))?;
    let (mut given, mut size) = (Vec::new(), 0);
    for (name, path) in paths {
        let bytes = input::bytes(&path)?;
        size += bytes.len();
        if size > MOST_BYTES {
            let why = format!(
                "with it the files have more than {MOST_BYTES} bytes, the most that a page holds; give fewer, and drop the others on the page"
            );
            return Err(CliError::Input { path, why });
        }
        given.push(GivenFile { name, base64: STANDARD.encode(bytes) });
    }
    let page = with_files(PAGE.ok_or(CliError::NoStudio)?, &given);
    outputs.write(|(), writer| writer.write_all(page.as_bytes()).map_err(CliError::other))?;
    print(|out| {
        for line in outputs.written() {
            writeln!(out, "{line}")?;
        }
        Ok(())
    })
}

/// A file, or all files of a folder by their ways in it.
fn gather(
    path: &Path,
    folder: &str,
    depth: usize,
    found: &mut Vec<(String, PathBuf)>,
) -> Result<(), CliError> {
    let last = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let name = if folder.is_empty() { last } else { format!("{folder}/{last}") };
    if !path.is_dir() || depth > DEEPEST {
        found.push((name, path.to_owned()));
        return Ok(());
    }
    let refuse = |error: std::io::Error| CliError::Input { path: path.to_owned(), why: error.to_string() };
    let entries = fs::read_dir(path).map_err(refuse)?;
    let mut inside = entries.map(|entry| Ok(entry?.path())).collect::<Result<Vec<_>, _>>().map_err(refuse)?;
    inside.sort();
    inside.iter().try_for_each(|inside| gather(inside, &name, depth + 1, found))
}

/// The page with files that it opens.
fn with_files(page: &str, files: &[GivenFile]) -> String {
    if files.is_empty() {
        return page.to_owned();
    }
    let json = serde_json::to_string(files).expect("plain data of text is always JSON");
    // `<` occurs in names only, and there `\u003c` is the same.
    let json = json.replace('<', "\\u003c");
    page.replacen(BOOT, &format!("<script type=\"application/json\" id=\"given\">{json}</script>\n{BOOT}"), 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_files_cannot_end_their_element() {
        let hostile =
            GivenFile { name: "</script><script>alert(1)".to_owned(), base64: STANDARD.encode("x") };
        let page = with_files("<p></p><script id=\"boot\">…</script>", &[hostile]);
        assert_eq!(page.matches("</script>").count(), 2, "{page}");
        assert!(page.find("id=\"given\"") < page.find("id=\"boot\""));
        assert!(page.contains("\\u003c/script>"));
    }

    #[test]
    fn a_folder_means_its_files_by_their_ways() {
        let folder = tempfile::tempdir().expect("a folder");
        fs::create_dir(folder.path().join("meshes")).expect("a folder");
        for file in ["robot.urdf", "meshes/leg.stl"] {
            fs::write(folder.path().join(file), "x").expect("a file");
        }
        let mut found = Vec::new();
        gather(folder.path(), "", 0, &mut found).expect("files");
        let names: Vec<&str> =
            found.iter().filter_map(|(name, _)| name.split_once('/')).map(|(_, name)| name).collect();
        assert_eq!(names, ["meshes/leg.stl", "robot.urdf"]);
    }

    #[cfg(studio)]
    #[test]
    fn the_page_asks_nothing_of_the_network() {
        let page = PAGE.expect("the page");
        let policy =
            page.split("Content-Security-Policy\" content=\"").nth(1).and_then(|rest| rest.split('"').next());
        let policy = policy.expect("a policy");
        assert!(policy.starts_with("default-src 'none'"), "{policy}");
        assert!(
            !policy.contains("connect-src") && !policy.contains("http") && !policy.contains("'unsafe-eval'")
        );
        assert_eq!(page.matches(BOOT).count(), 1);
    }
}
