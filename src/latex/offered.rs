//! Comments that declare the names of a paper that nothing declares.
//!
//! Contract: every comment that is offered was read once as it stands, behind those before it, and declares the names that the
//! equations ask for. A name that no declaration takes as it is printed is offered with `name … as …`.

use super::clause::read;
use super::comment::rename;
use super::document::Clause;
use super::name::Names;
use super::outcome::Wanted;
use carom_checker::claim::parse::parse_placed;
use carom_checker::claim::preamble::Preamble;
use carom_diagnostic::Span;
use std::collections::BTreeMap;

/// What is declared so far.
#[derive(Clone)]
struct Declared {
    names: Names,
    preamble: Preamble,
}

impl Declared {
    /// With one more name, if its declaration is read and is that of the key.
    fn with(&self, key: &str, declaration: &str) -> Option<Declared> {
        let mut out = self.clone();
        let clause = Clause { text: format!("given {declaration}"), span: Span::default() };
        let text = read(&[clause], &mut out.names).ok()?;
        out.preamble = parse_placed(text.text(), &self.preamble, &|span| text.place(span)).ok()?.1;
        out.names.spelled(key).is_some_and(|name| out.preamble.names.contains(name)).then_some(out)
    }

    /// With a name of its own for a key.
    fn renamed(&self, key: &str, name: &str) -> Option<Declared> {
        let mut out = self.clone();
        let text = format!("name {key} as {name}");
        rename(&Clause { text, span: Span::default() }, &mut out.names).ok()?;
        out.names.spelled(key).is_some_and(|spelled| spelled == name).then_some(out)
    }
}

/// Comments to begin with for these names.
pub(crate) fn offered(undeclared: &BTreeMap<String, Wanted>, names: &Names, preamble: &Preamble) -> Vec<String> {
    let families: Vec<&String> = undeclared.iter().filter(|(_, w)| **w == Wanted::Family).map(|(key, _)| key).collect();
    // What is a member of a family is no number.
    let is_member =
        |key: &str| families.iter().any(|family| key.strip_prefix(*family).is_some_and(|rest| rest.starts_with('_')));
    // An index of a member is a natural number.
    let index_of = |key: &str| Some(key.split_once("_{")?.1.trim_end_matches('\'').strip_suffix('}')?.to_string());
    let counts: Vec<String> = undeclared.keys().filter(|key| is_member(key)).filter_map(|key| index_of(key)).collect();
    let is_free = |index: &&&str| !undeclared.contains_key(**index) && names.spelled(index).is_none();
    let index = ["k", "j", "i", "l", "m", "n", "q"].iter().find(is_free).unwrap_or(&"kk");
    let mut declared = Declared { names: names.clone(), preamble: preamble.clone() };
    let (mut renamed, mut lists): (Vec<String>, [Vec<String>; 3]) = (Vec::new(), Default::default());
    for (key, wanted) in undeclared.iter().filter(|(key, w)| **w != Wanted::Function && !is_member(key)) {
        let (place, argument) = match wanted {
            Wanted::Number if counts.contains(key) => (0, String::new()),
            Wanted::Natural => (0, String::new()),
            Wanted::Family => (1, format!("({index})")),
            Wanted::Number | Wanted::Function => (2, String::new()),
        };
        let domain = if place == 0 { "natural" } else { "real" };
        let plain = format!("{key}{argument}");
        if let Some(more) = declared.with(key, &format!("{plain} {domain}")) {
            declared = more;
            lists[place].push(plain);
            continue;
        }
        // A name that has a spelling already is declared by that.
        let known = names.spelled(key).map(str::to_string).map(|name| (name.clone(), declared.clone(), name));
        let new = || {
            let name = (0..100).map(|n| fresh(key, n)).find(|name| declared.renamed(key, name).is_some())?;
            Some((name.clone(), declared.renamed(key, &name)?, String::new()))
        };
        let Some((name, base, is_known)) = known.or_else(new) else { continue };
        let Some(more) = base.with(key, &format!("{name}{argument} {domain}")) else { continue };
        declared = more;
        if is_known.is_empty() {
            renamed.push(format!("name {key} as {name}"));
        }
        lists[place].push(format!("{name}{argument}"));
    }
    let domains = ["natural", "real", "real"];
    let list = lists.iter().zip(domains).filter(|(list, _)| !list.is_empty());
    let given: Vec<String> = list.map(|(list, domain)| format!("{} {domain}", list.join(", "))).collect();
    renamed.extend((!given.is_empty()).then(|| format!("given {}", given.join("; "))));
    renamed
}

/// A name in letters and digits for a key.
fn fresh(key: &str, attempt: usize) -> String {
    let parts: Vec<&str> = key.split(|c: char| !c.is_ascii_alphanumeric()).filter(|part| !part.is_empty()).collect();
    let name = parts.join("_");
    let name = if name.starts_with(|c: char| c.is_ascii_alphabetic()) { name } else { format!("x_{name}") };
    let name = name.trim_end_matches('_').to_string();
    if attempt == 0 { name } else { format!("{name}_{attempt}") }
}
