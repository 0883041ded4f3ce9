//! Trust in simulations: the tables and the pictures of docs/trust.md.
//!
//! The methods that choose their steps come with a feature that costs two minutes of building; their tables are written
//! by a build of its own, so that all others are those of the ordinary one.

mod between;
mod chosen;
mod extremes;
mod figures;
mod ground;
#[cfg(feature = "stiff")]
mod pictures;
mod solutions;
#[cfg(feature = "stiff")]
mod stepping;
#[cfg(feature = "stiff")]
mod systems;
mod tables;
mod widths;

use super::page;
use crate::table::{self, Table};
use crate::workspace::{cargo, read, write};

const PAGE: &str = "docs/trust.md";

/// Measures and writes all.
pub(super) fn run() -> Result<(), String> {
    eprintln!("report: simulations");
    let mut text = read(PAGE)?;
    text = table::replace(&text, "when", &page::circumstances())?;
    write(PAGE, &filled(text, all()?)?)?;
    eprintln!("report: building and running with the methods that choose their steps");
    let build = ["run", "--quiet", "--release", "--package", "solaris-lab", "--features", "stiff", "--"];
    cargo(&[&build[..], &["report", "simulation", "adaptive"]].concat())
}

/// The part that needs the feature.
#[cfg(feature = "stiff")]
pub(super) fn adaptive() -> Result<(), String> {
    write(PAGE, &filled(read(PAGE)?, all_adaptive()?)?)?;
    pictures::draw()
}

/// The part that needs the feature.
#[cfg(not(feature = "stiff"))]
pub(super) fn adaptive() -> Result<(), String> {
    Err("this needs the feature 'stiff'; `cargo lab report simulation` builds it".to_owned())
}

/// Measures what a tolerance of the run costs beside the cheapest setting.
pub(super) fn chosen() -> Result<(), String> {
    chosen::run()
}

/// Measures beside MuJoCo, and writes that part of the page.
#[cfg(feature = "stiff")]
pub(super) fn stepping() -> Result<(), String> {
    stepping::run()
}

/// The same by a build with the methods that choose their steps.
#[cfg(not(feature = "stiff"))]
pub(super) fn stepping() -> Result<(), String> {
    let build = ["run", "--quiet", "--release", "--package", "solaris-lab", "--features", "stiff", "--"];
    cargo(&[&build[..], &["report", "stepping"]].concat())
}

/// Tables that need no more than the fixed rules.
fn all() -> Result<Vec<(&'static str, Table)>, String> {
    Ok(tables::all()?.into_iter().chain(ground::tables::all()?).collect())
}

/// Tables of the methods that choose their steps.
#[cfg(feature = "stiff")]
fn all_adaptive() -> Result<Vec<(&'static str, Table)>, String> {
    Ok(tables::adaptive::all()?.into_iter().chain(ground::tables::adaptive()?).collect())
}

/// The page with these tables.
fn filled(mut text: String, tables: Vec<(&'static str, Table)>) -> Result<String, String> {
    for (name, table) in tables {
        text = table::replace(&text, name, &table.markdown()).map_err(|error| format!("{PAGE}: {error}"))?;
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn assert_current(tables: Vec<(&'static str, Table)>) {
        let page = read(PAGE).expect("the page");
        for (name, table) in tables {
            let differences = table.differences(table::block(&page, name).expect("a table"));
            assert!(
                differences.is_empty(),
                "{PAGE}, {name}: `cargo lab report simulation` is due:\n{}",
                differences.join("\n")
            );
        }
    }

    #[cfg(not(feature = "stiff"))]
    #[test]
    #[ignore = "all simulations of the page, ten seconds and more: cargo xtask nightly"]
    fn the_page_says_what_is_measured() {
        assert_current(all().expect("every case runs"));
    }

    #[cfg(feature = "stiff")]
    #[test]
    #[ignore = "all simulations of the page, some seconds: cargo xtask nightly"]
    fn the_page_says_what_methods_that_choose_their_steps_come_to() {
        assert_current(all_adaptive().expect("every case runs"));
    }
}
