//! The numbers of walks on pages: written, and checked, by one command after every change of a walk.
//!
//! Each page has them between marks. What takes seconds a walk is here, times and long simulations are in `report`.

mod people;
mod style;
mod walks;

use crate::table::{block, replace};
use crate::workspace::{read, write};

/// The pages, and what writes the tables of each: their names and texts.
const PAGES: [Page; 2] = [("docs/people.md", people::tables), ("docs/walking.md", walking)];

/// A page by its path, and the tables that belong on it as it stands.
type Page = (&'static str, fn(&str) -> Result<Tables, String>);

/// Tables in Markdown by their names on the page.
type Tables = Vec<(&'static str, String)>;

/// What is asked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Options {
    check_only: bool,
}

impl Options {
    pub(crate) fn parse(options: &[&str]) -> Result<Self, String> {
        match options {
            [] => Ok(Self::default()),
            ["--check"] => Ok(Self { check_only: true }),
            other => Err(format!("docs: unknown options '{}'; there is --check", other.join(" "))),
        }
    }
}

/// Writes all tables anew, or says which are out of date.
pub(crate) fn run(options: Options) -> Result<(), String> {
    pages(&PAGES, options)
}

/// Writes those of the walks beside people.
pub(crate) fn people() -> Result<(), String> {
    pages(&PAGES[..1], Options::default())
}

fn pages(pages: &[Page], options: Options) -> Result<(), String> {
    let mut stale = Vec::new();
    for &(path, tables) in pages {
        let mut page = read(path)?;
        for (name, text) in tables(&page).map_err(|error| format!("{path}: {error}"))? {
            let differences =
                differences(block(&page, name).map_err(|error| format!("{path}: {error}"))?, &text);
            if !differences.is_empty() {
                stale.push(format!("{path}, {name}:\n{}", differences.join("\n")));
                page = replace(&page, name, &text)?;
            }
        }
        if !options.check_only {
            write(path, &page)?;
        }
    }
    match (stale.is_empty(), options.check_only) {
        (true, _) => println!("docs: every table of a walk is current"),
        (false, false) => println!("docs: written anew\n{}", stale.join("\n")),
        (false, true) => return Err(format!("`cargo lab docs` is due:\n{}", stale.join("\n"))),
    }
    Ok(())
}

fn walking(page: &str) -> Result<Tables, String> {
    Ok(vec![
        ("fit", style::fit()?),
        ("style", style::numbers(block(page, "style")?)?),
        ("changes", walks::changes()?),
        ("forces", walks::forces()?),
    ])
}

/// The lines of a page that are not as they should be.
fn differences(found: &str, wanted: &str) -> Vec<String> {
    let (mut found, mut wanted) = (found.lines(), wanted.lines());
    let mut differences = Vec::new();
    loop {
        match (found.next(), wanted.next()) {
            (None, None) => return differences,
            (found, wanted) if found == wanted => {}
            (found, wanted) => differences.push(format!(
                "  {}\n  should be\n  {}",
                found.unwrap_or("(nothing)"),
                wanted.unwrap_or("(nothing)")
            )),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_style_on_the_page_is_what_ships() {
        let page = read("docs/walking.md").expect("the page");
        let found = block(&page, "style").expect("a table");
        let differences = differences(found, &style::numbers(found).expect("a row for each number"));
        assert!(differences.is_empty(), "`cargo lab docs` is due:\n{}", differences.join("\n"));
    }

    #[test]
    #[ignore = "all walks of the pages, half a minute: cargo xtask nightly"]
    fn the_pages_say_what_walks_come_to() {
        run(Options { check_only: true }).expect("every table is current");
    }

    #[test]
    fn what_differs_is_named() {
        assert!(differences("a\nb", "a\nb").is_empty());
        insta::assert_snapshot!(differences("a\nb", "a\nc\nd").join("\n"), @r"
          b
          should be
          c
          (nothing)
          should be
          d
        ");
    }
}
