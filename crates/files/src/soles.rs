//! Whose soles stand on the ground: those of a file, the figure's own, or a guess.

use crate::error::FileError;
use crate::files::Source;
use solaris_analysis::ground::{self, Sole};
use solaris_model::Figure;
use solaris_scene::read_soles;
use std::path::{Path, PathBuf};

/// Who says where soles are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SolesFrom {
    /// A text of soles.
    File(PathBuf),
    /// The figure has some.
    Figure,
    /// Its bodies' names let them be guessed.
    Guess,
}

impl SolesFrom {
    /// In words.
    pub fn describe(&self) -> String {
        match self {
            Self::File(path) => format!("of {}", path.display()),
            Self::Figure => "the figure's own".to_owned(),
            Self::Guess => "guessed by the bodies' names".to_owned(),
        }
    }
}

impl Source<'_> {
    /// The soles of a figure: those of a file, or else its own, or else a guess by names; none of a figure without feet.
    ///
    /// # Errors
    ///
    /// A file that cannot be read or used.
    pub fn soles(
        self,
        path: Option<&Path>,
        figure: &Figure,
    ) -> Result<Option<(Vec<Sole>, SolesFrom)>, FileError> {
        if let Some(path) = path {
            let text = self.text(path)?;
            let soles = read_soles(&text, figure).map_err(|faults| FileError::faulty(path, &text, faults))?;
            return Ok(Some((soles, SolesFrom::File(path.to_owned()))));
        }
        let own = ground::soles(figure);
        if !own.is_empty() {
            return Ok(Some((own, SolesFrom::Figure)));
        }
        let guessed = ground::guessed_soles(figure);
        Ok((!guessed.is_empty()).then_some((guessed, SolesFrom::Guess)))
    }
}
