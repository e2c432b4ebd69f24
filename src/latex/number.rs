//! The numbers of equations, as LaTeX counts them.

use super::macros::group;
use super::token::{Token, words};

/// The counters of a document.
#[derive(Default)]
pub(crate) struct Numbers {
    equation: u32,
    section: u32,
    /// `\appendix` was seen.
    is_appendix: bool,
    /// `\numberwithin{equation}{section}` was seen.
    is_within: bool,
    /// Within `subequations`: the rows so far.
    sub: Option<u32>,
}

impl Numbers {
    /// Takes note of a command outside of formulas.
    pub(crate) fn command(&mut self, name: &str, rest: &[Token]) {
        let argument = |place: usize| {
            let first = group(rest, 0).ok()?;
            let chosen = if place == 0 { first.0 } else { group(rest, first.1).ok()?.0 };
            Some(words(chosen))
        };
        let number = || argument(1).and_then(|text| text.parse::<u32>().ok());
        match name {
            "section" if !rest.first().is_some_and(|t| t.is_char('*')) => {
                self.section = self.section.saturating_add(1);
                if self.is_within {
                    self.equation = 0;
                }
            }
            "appendix" => (self.section, self.is_appendix) = (0, true),
            "numberwithin" => self.is_within = argument(0).as_deref() == Some("equation"),
            "setcounter" if argument(0).as_deref() == Some("equation") => {
                self.equation = number().unwrap_or(self.equation);
            }
            "addtocounter" if argument(0).as_deref() == Some("equation") => {
                self.equation = self.equation.saturating_add(number().unwrap_or(0));
            }
            _ => {}
        }
    }

    /// `\begin{subequations}`
    pub(crate) fn begin_sub(&mut self) {
        self.equation = self.equation.saturating_add(1);
        self.sub = Some(0);
    }

    /// `\end{subequations}`
    pub(crate) fn end_sub(&mut self) {
        self.sub = None;
    }

    /// The number of a row; `said` is what it says itself, nothing where it says to have none.
    pub(crate) fn row(&mut self, environment: &str, said: Option<String>, is_read: bool) -> Option<String> {
        match said {
            Some(said) => return Some(said).filter(|said| !said.is_empty()),
            None if environment.ends_with('*') || ["[", "$", "$$", "displaymath"].contains(&environment) => {
                return None;
            }
            None => {}
        }
        let letter = match &mut self.sub {
            Some(rows) => {
                *rows = rows.saturating_add(1);
                char::from_u32(u32::from('a') + (*rows - 1).min(25)).map(String::from).unwrap_or_default()
            }
            None => {
                self.equation = self.equation.saturating_add(1);
                String::new()
            }
        };
        let section = match (self.is_within, self.is_appendix) {
            (false, _) => String::new(),
            (true, false) => format!("{}.", self.section),
            (true, true) => {
                format!("{}.", char::from_u32(u32::from('A') + self.section.saturating_sub(1).min(25)).unwrap_or('A'))
            }
        };
        is_read.then(|| format!("{section}{}{letter}", self.equation))
    }
}
