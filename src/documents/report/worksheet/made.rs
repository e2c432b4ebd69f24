//! The sheets of a scene: blank ones and keys, of the scene itself or of versions with other masses.

use super::questions::drawn;
use super::{Sheet, Style, Subject, sheet};
use crate::chain::ChainError;
use crate::scene::drop::Drop;
use crate::scene::read::Subject as Scene;
use crate::scene::{About, versions};
use crate::table::worksheet::Worksheet;

/// The standard that a sheet names by default.
pub const STANDARD: &str =
    "NGSS HS-PS2-2, the total momentum of a system of objects is conserved when there is no net force on the system";
/// The most versions: a letter each.
pub const MAX_VERSIONS: u8 = 26;

/// What is asked for.
#[derive(Clone, Copy, Debug)]
pub struct Wanted<'a> {
    /// The title.
    pub title: &'a str,
    /// The standard that the sheets serve.
    pub standard: Option<&'a str>,
    /// Sheets to be filled in.
    pub blank: bool,
    /// Answer keys.
    pub key: bool,
    /// So many versions, [`MAX_VERSIONS`] at most; 0 for the scene itself.
    pub versions: u8,
    /// The seed of the versions.
    pub seed: u64,
    /// How entries are written.
    pub style: Style,
}

/// The scene of one version.
struct Version {
    worksheet: Worksheet,
    drop: Option<Drop>,
    letter: Option<(char, u64)>,
}

/// The sheets of a scene. All that pupils get comes first.
///
/// # Errors
/// Those of [`Worksheet`] and of `versions`; a limit on digits.
pub fn sheets(about: &About, scene: &Scene, wanted: &Wanted<'_>) -> Result<Vec<Sheet>, ChainError> {
    let versions = made(scene, wanted)?;
    let subjects: Vec<Subject<'_>> = versions
        .iter()
        .map(|Version { worksheet, drop, letter }| {
            let (title, standard) = (wanted.title, wanted.standard);
            Subject { worksheet, about, drop: drop.as_ref(), title, version: *letter, standard, asked: None }
        })
        .collect();
    let drawn = drawn(&subjects, wanted.seed);
    let mut sheets = Vec::new();
    for filled in
        [(wanted.blank, false), (wanted.key, true)].into_iter().filter_map(|(is, filled)| is.then_some(filled))
    {
        for (subject, asked) in subjects.iter().zip(&drawn) {
            let asked = subject.version.map(|_| asked.as_slice());
            sheets.push(sheet(&Subject { asked, ..*subject }, wanted.style, filled)?);
        }
    }
    Ok(sheets)
}

/// The scene itself, or the versions of it that are asked for.
fn made(scene: &Scene, wanted: &Wanted<'_>) -> Result<Vec<Version>, ChainError> {
    let letters = ('A'..='Z').map(|letter| Some((letter, wanted.seed)));
    let count = usize::from(wanted.versions.min(MAX_VERSIONS));
    let of_drop = |drop: &Drop, letter| {
        Ok::<_, ChainError>(Version { worksheet: Worksheet::of_drop(drop)?, drop: Some(drop.clone()), letter })
    };
    match scene {
        Scene::Drop(drop, _) if count == 0 => Ok(vec![of_drop(drop, None)?]),
        Scene::Drop(drop, _) => {
            let made = versions::of_drop(drop, wanted.seed, count)?;
            made.iter().zip(letters).map(|(drop, letter)| of_drop(drop, letter)).collect()
        }
        Scene::Chain(scene) => {
            let chain = scene.inputs.whole("a worksheet")?;
            let made = if count == 0 { vec![chain.clone()] } else { versions::of_chain(chain, wanted.seed, count)? };
            let letters = letters.map(|letter| letter.filter(|_| count > 0));
            let one = |(chain, letter)| Ok(Version { worksheet: Worksheet::of(chain)?, drop: None, letter });
            made.iter().zip(letters).map(one).collect()
        }
    }
}
