//! A paper's equations as claims.
//!
//! Contract: every displayed formula is an [`Equation`]: a claim, a hypothesis or definition of those that follow, passed over by
//! its author, or not read for a stated reason. Behind a hypothesis or a definition that is not read nothing is a claim: it
//! would be judged without it. All places are places in the document.

use super::clause::{self, Purpose, misplaced};
use super::comment::first_word;
use super::document::{Clause, Display, Lines, Part, document};
use super::domain::domains;
use super::expression::Read;
use super::index::{Indices, greek_indices};
use super::input::Manuscript;
use super::name::Names;
use super::offered::offered;
use super::outcome::{Equation, Outcome, Paper, Wanted};
use super::place::Placed;
use super::prepare::prepared;
use super::refusal::{ambiguous, expected, refused};
use super::row::{Joined, claim_name, equations};
use super::scope::{Decisions, Missing, Role, Scope, roles};
use super::statement::{Said, joined};
use super::structure::structured;
use super::token::{Token, tokens};
use super::typeset::typeset;
use super::vector::Vectors;
use super::whole::whole;
use carom_checker::claim::parse::{clauses_placed, parse_placed};
use carom_checker::claim::preamble::Preamble;
use carom_checker::claim::syntax::Claim;
use carom_diagnostic::{Diagnostic, Source, Span};
use std::collections::{BTreeMap, BTreeSet};

mod definition;

/// The most names of one equation that are looked for behind the first that is missing.
const MISSING_LIMIT: usize = 50;

/// The equations of a LaTeX document in one text.
///
/// # Errors
/// A limit of the whole text, or no displayed formula.
pub fn paper(text: &str) -> Result<Paper, Vec<Diagnostic>> {
    paper_of(&Manuscript::alone(text))
}

/// The equations of a LaTeX document; all places are places in its whole text.
///
/// # Errors
/// A limit of the whole text, or no displayed formula.
pub fn paper_of(whole: &Manuscript) -> Result<Paper, Vec<Diagnostic>> {
    let text = whole.latex();
    let tokens = structured(&tokens(text).map_err(|fault| vec![fault])?);
    let document = document(&tokens, &Lines::of(text), &whole.unread);
    let mut reader = Assembly::new(&whole.source);
    reader.indices = greek_indices(&document);
    reader.out.inline = document.inline;
    let mut waiting: Vec<Clause> = Vec::new();
    for part in document.parts {
        match part {
            Part::Shared(clause) => waiting.push(clause),
            Part::Fault(fault, declares) => {
                reader.shared(&std::mem::take(&mut waiting));
                let head = reader.head(None, None, fault.span);
                if declares {
                    reader.broken.get_or_insert(fault.span);
                }
                reader.push(head, Outcome::NotRead(vec![fault]));
            }
            Part::Display(display) => {
                reader.shared(&std::mem::take(&mut waiting));
                reader.display(&display);
            }
        }
    }
    reader.shared(&waiting);
    let found = reader.finished();
    if found.equations.is_empty() && found.faults.is_empty() {
        let help = "a displayed equation stands in \\begin{equation}, \\begin{align}, \\[ … \\] or $$ … $$";
        let place = Span { start: 0, end: text.len().min(1) };
        return Err(vec![refused("no displayed equation found in this file", help, place)]);
    }
    Ok(found)
}

struct Head {
    name: String,
    number: Option<String>,
    /// Where it stands, in words for a title.
    line: String,
    span: Span,
}

struct Assembly<'l> {
    source: &'l Source,
    names: Names,
    preamble: Preamble,
    outer: Vec<Preamble>,
    decisions: Decisions,
    /// The place of a declaration that could not be read.
    broken: Option<Span>,
    /// Names whose definition could not be read, and its place: an equation without them says the same.
    undefined: BTreeMap<String, Span>,
    /// The place of such a definition that the equation being read needs.
    needed: Option<Span>,
    /// Greek letters that stand below names, with the names.
    indices: Indices,
    /// Names that equations have got.
    taken: BTreeSet<String>,
    /// Where the equation that was read last has vectors.
    vectors: Vectors,
    /// Where hypotheses and definitions have vectors.
    supposed: Vectors,
    out: Paper,
}

impl<'l> Assembly<'l> {
    fn new(source: &'l Source) -> Assembly<'l> {
        Assembly {
            source,
            names: Names::default(),
            preamble: Preamble::default(),
            outer: Vec::new(),
            decisions: Decisions::default(),
            broken: None,
            undefined: BTreeMap::new(),
            needed: None,
            indices: Indices::new(),
            taken: BTreeSet::new(),
            vectors: Vectors::default(),
            supposed: Vectors::default(),
            out: Paper::default(),
        }
    }

    fn finished(mut self) -> Paper {
        let names = &self.names;
        let member = |key: &str| names.members.get(key).map(String::as_str);
        let spelled = |key: &str| names.spelled(key).or(names.meaning(key)).or(member(key)).unwrap_or(key).to_string();
        self.out.names = names.count.iter().map(|(key, count)| (key.clone(), spelled(key), *count)).collect();
        self.out.offered = offered(&self.out.undeclared, names, &self.preamble);
        self.out
    }

    fn push(&mut self, head: Head, outcome: Outcome) {
        let Head { name, number, span, .. } = head;
        self.out.equations.push(Equation { name, number, span, outcome });
    }

    /// What an equation is called. Of two with the same number the second is called by its line as well.
    fn head(&mut self, label: Option<&str>, number: Option<&String>, span: Span) -> Head {
        let (path, line, _) = self.source.place(span);
        let stem = std::path::Path::new(path).file_stem().and_then(|stem| stem.to_str());
        let stem = stem.filter(|_| path != self.source.path());
        let mut name = claim_name(label, number.map(String::as_str), stem, line);
        if !self.taken.insert(name.clone()) {
            if label.is_some() || number.is_some() {
                name = format!("{name}-line-{line}");
            }
            let numbered = std::iter::once(name.clone()).chain((2..).map(|count| format!("{name}-{count}")));
            name = numbered.into_iter().find(|name| self.taken.insert(name.clone())).unwrap_or_default();
        }
        let line = stem.map_or(format!("Line {line}"), |stem| format!("Line {line} of {stem}"));
        Head { name, number: number.cloned(), line, span }
    }

    /// A declaration was not read: what follows would be judged without it.
    fn breaks(&mut self, faults: Vec<Diagnostic>) {
        if let Some(fault) = faults.first() {
            self.broken.get_or_insert(fault.span);
        }
        self.out.faults.extend(faults);
    }

    /// Clauses outside of equations.
    fn shared(&mut self, clauses: &[Clause]) {
        for (word, lines) in clause::whole(clauses) {
            if let Err(faults) = self.shared_clause(&word, &lines) {
                self.breaks(faults);
            }
        }
    }

    fn shared_clause(&mut self, word: &str, lines: &[Clause]) -> Result<(), Vec<Diagnostic>> {
        let Some(first) = lines.first() else { return Ok(()) };
        let one = |fault: Diagnostic| vec![fault];
        if word == "digits" {
            return Err(one(misplaced(word, first.span)));
        }
        if clause::decides(lines, &mut self.decisions).map_err(one)? {
            return Ok(());
        }
        match word {
            "begin" if first.text == word => self.outer.push(self.preamble.clone()),
            "end" if first.text == word => match self.outer.pop() {
                Some(outer) => self.preamble = outer,
                None => {
                    return Err(one(refused("`end` without `begin`", "write `%carom begin` before it", first.span)));
                }
            },
            "name" => super::comment::rename(first, &mut self.names).map_err(one)?,
            "product" => super::comment::factors(first, &mut self.names).map_err(one)?,
            "paper" | "source" | "section" | "reading" | "given" | "let" | "define" | "assume" => {
                let text = clause::read(lines, &mut self.names).map_err(one)?;
                self.declare(&text)?;
            }
            _ => return Err(one(misplaced(word, first.span))),
        }
        Ok(())
    }

    /// Takes clauses for all equations that follow.
    fn declare(&mut self, text: &Placed) -> Result<(), Vec<Diagnostic>> {
        let (_, preamble) = parse_placed(text.text(), &self.preamble, &|span| text.place(span))?;
        self.preamble = preamble;
        Ok(())
    }

    fn display(&mut self, display: &Display) {
        let list = match equations(display, self.decisions.has_remarks) {
            Ok(list) => list,
            Err(fault) => {
                // It may be a hypothesis.
                let mut words = display.rows.iter().flat_map(|row| &row.clauses).map(|c| first_word(&c.text));
                if words.any(|word| ["assume", "let", "define", "given"].contains(&word)) {
                    self.broken.get_or_insert(display.span);
                }
                let number = display.rows.iter().find_map(|row| row.number.as_ref());
                let head = Head { number: number.cloned(), ..self.head(None, None, display.span) };
                return self.push(head, Outcome::NotRead(vec![fault]));
            }
        };
        // What the rows of this formula declare holds to its end.
        let mut local: Vec<Placed> = Vec::new();
        for equation in list {
            let mut head = self.head(equation.label.as_deref(), equation.number.as_ref(), equation.span);
            let said = clause::of(&equation.clauses, self.decisions, &mut self.names);
            let outcome = match said {
                Ok(said) => {
                    if let Some(name) = said.name.as_ref().and_then(|name| name.text().split_whitespace().nth(1)) {
                        head.name = name.to_string();
                    }
                    self.equation(&equation, said, &head, &mut local)
                }
                Err(fault) => {
                    // What the equation is remains unknown: it may be a hypothesis.
                    self.broken.get_or_insert(equation.span);
                    Err(vec![fault])
                }
            };
            self.push(head, outcome.unwrap_or_else(Outcome::NotRead));
        }
    }

    fn equation(
        &mut self,
        equation: &Joined,
        said: clause::Said,
        head: &Head,
        local: &mut Vec<Placed>,
    ) -> Result<Outcome, Vec<Diagnostic>> {
        if let Purpose::Skip(reason) = said.purpose {
            return Ok(Outcome::Skipped(reason));
        }
        if let Some(place) = self.broken {
            return Ok(Outcome::Waits(place));
        }
        if let Some(fault) = &equation.fault {
            if said.purpose != Purpose::Prove {
                self.broken.get_or_insert(head.span);
            }
            return Err(vec![fault.clone()]);
        }
        local.extend(said.items.iter().cloned());
        let is_defined = self.undefined.len();
        let outcome = self.read(equation, &said, head, local);
        // A definition that was not read is known by its name.
        let is_open = self.undefined.len() == is_defined;
        if outcome.is_err() && said.purpose != Purpose::Prove && is_open {
            self.broken.get_or_insert(head.span);
        }
        match self.needed.take() {
            Some(definition) if outcome.is_err() => Ok(Outcome::Waits(definition)),
            _ => outcome,
        }
    }

    fn read(
        &mut self,
        equation: &Joined,
        said: &clause::Said,
        head: &Head,
        local: &mut Vec<Placed>,
    ) -> Result<Outcome, Vec<Diagnostic>> {
        let one = |fault: Diagnostic| vec![fault];
        let tokens = prepared(&equation.tokens).map_err(one)?;
        if tokens.is_empty() {
            return Err(one(refused("this formula is empty", "write a formula, or remove it", equation.span)));
        }
        let tokens = self.names.with_phrases(&tokens);
        let sign = match said.purpose {
            Purpose::Let | Purpose::Prove => self.sign_of_definition(&tokens, said, local)?,
            Purpose::Assume(_) | Purpose::Skip(_) => None,
        };
        match (&said.purpose, sign) {
            (_, Some((sign, behind))) => match self.definition(&tokens, sign, behind, said, head, local)? {
                false => Ok(Outcome::Used("definition")),
                true => self.claim(&tokens[behind..], equation, said, head, local),
            },
            (Purpose::Let, None) => Err(one(expected("`=` behind the name", "no such sign", equation.span))),
            (Purpose::Assume(label), _) => {
                said.of_no_claim().map_err(one)?;
                let goal = self.goal(&tokens, said, local)?;
                self.vectors.supposed(&self.names).map_err(one)?;
                self.supposed = self.supposed.with(self.vectors);
                let mut text = lines_of(local);
                let label = label.as_ref().map_or(String::new(), |label| format!("{label}: "));
                text.push(&format!("assume {label}"), equation.span);
                text.append(&goal.text);
                self.declare(&text)?;
                local.clear();
                Ok(Outcome::Used("hypothesis"))
            }
            _ => self.claim(&tokens, equation, said, head, local),
        }
    }

    /// What the names of an equation are.
    fn with_scope<T>(
        &mut self,
        said: &clause::Said,
        local: &[Placed],
        read: impl Fn(&mut Scope<'_>) -> Read<T>,
    ) -> Result<T, Vec<Diagnostic>> {
        let mut text = Placed::new("claim x \"\"\n", Span::default());
        text.append(&lines_of(local));
        text.push("prove 0 = 0", Span::default());
        let (claims, preamble) = clauses_placed(text.text(), &self.preamble, &|span| text.place(span))?;
        let mut roles = claims.first().map(|claim| roles(claim, &preamble)).unwrap_or_default();
        let domains = claims.first().map(|claim| domains(claim, &preamble)).unwrap_or_default();
        let (names, mut first): (Names, Option<Diagnostic>) = (self.names.clone(), None);
        // Behind a name that is missing the others are looked for.
        for _ in 0..MISSING_LIMIT {
            let mut scope = Scope {
                names: &mut self.names,
                roles: roles.clone(),
                domains: domains.clone(),
                indices: &self.indices,
                bound: Vec::new(),
                decisions: said.decisions,
                upper: true,
                double_sign: None,
                signed: 0,
                splits: false,
                has_printed: false,
                value: None,
                has_logic: false,
                has_choice: false,
                counts: false,
                is_exponent: false,
                within_bars: false,
                vectors: Vectors::default(),
                missing: None,
            };
            let read = read(&mut scope)
                .and_then(|value| scope.vectors.allowed(self.supposed, scope.has_choice).map(|()| value));
            self.vectors = scope.vectors;
            let missing = scope.missing.take();
            let fault = match (read, &first) {
                (Ok(value), None) => {
                    // What a comment declares behind a definition that was not read is not what the paper means.
                    let is_more = |key: &String| self.names.count.get(key) > names.count.get(key);
                    let Some((_, definition)) = self.undefined.iter().find(|(key, _)| is_more(key)) else {
                        return Ok(value);
                    };
                    self.needed = Some(*definition);
                    return Err(vec![refused("its definition is not read", "correct the definition", *definition)]);
                }
                (Ok(_), Some(_)) => break,
                (Err(fault), _) => fault,
            };
            let is_first = first.is_none();
            first.get_or_insert(fault);
            let Some(Missing { symbol, wanted }) = missing else { break };
            let key = symbol.key();
            if let Some(definition) = self.undefined.get(&key) {
                self.needed = is_first.then_some(*definition);
                break;
            }
            let printed = if wanted == Wanted::Function { format!("{key}(…)") } else { key };
            let known = self.out.undeclared.entry(printed).or_insert(wanted);
            *known = wanted.max(*known);
            self.names.count.clone_from(&names.count);
            let Ok(name) = self.names.of(&symbol).or_else(|_| {
                let own = format!("unspelled_{}", roles.len());
                self.names.set(&symbol.key(), &own, symbol.span).map(|()| own)
            }) else {
                break;
            };
            let is_applied = [Wanted::Function, Wanted::Family].contains(&wanted);
            roles.insert(name, if is_applied { Role::Applied(1) } else { Role::Variable });
        }
        self.names = names;
        Err(first.into_iter().collect())
    }

    /// The statement of an equation.
    fn goal(&mut self, tokens: &[Token], said: &clause::Said, local: &[Placed]) -> Result<Said, Vec<Diagnostic>> {
        if let Some(statement) = &said.statement {
            return Ok(Said { text: statement.clone(), level: 1 });
        }
        self.with_scope(said, local, |scope| {
            let upper = whole(tokens, scope, |reader| reader.statement())?;
            if said.decisions.digits.is_some() && !scope.has_printed {
                let help = "write the number alone behind = or \\approx, or leave `digits` out";
                return Err(refused("`digits` is said of no printed number", help, tokens[0].span));
            }
            let Some(span) = scope.double_sign else { return Ok(upper) };
            let Some(both) = scope.decisions.both_signs else {
                let readings = ["both statements, with the upper and with the lower signs", "one of the two"];
                return Err(ambiguous("±", readings, ["write `%carom pm and`", "write `%carom pm or`"], span));
            };
            scope.has_choice |= !both;
            if !both && scope.signed == 1 {
                // One of two values is said where the sign stands, not of all that the formula says.
                scope.splits = true;
                return whole(tokens, scope, |reader| reader.statement());
            }
            if !both && scope.has_logic {
                let help = "write the two statements as two formulas";
                return Err(refused("± in several relations of an implication or a quantifier", help, span));
            }
            scope.upper = false;
            let lower = whole(tokens, scope, |reader| reader.statement())?;
            let (word, level, least) = if both { (" and ", 4, 5) } else { (" or ", 3, 4) };
            Ok(joined(vec![upper, lower], word, level, least))
        })
    }

    fn claim(
        &mut self,
        tokens: &[Token],
        equation: &Joined,
        said: &clause::Said,
        head: &Head,
        local: &[Placed],
    ) -> Result<Outcome, Vec<Diagnostic>> {
        let goal = self.goal(tokens, said, local)?;
        let title = match &head.number {
            Some(number) => format!("Equation ({number})"),
            None => head.line.clone(),
        };
        let mut text = Placed::default();
        match &said.name {
            Some(name) => {
                text.append(name);
                let has_title = name.text().contains('"');
                text.push(&if has_title { "\n".to_string() } else { format!(" \"{title}\"\n") }, equation.span);
            }
            None => text.push(&format!("claim {} \"{title}\"\n", head.name), equation.span),
        }
        let is_plain = |text: &&String| text.chars().all(|c| c.is_ascii_alphanumeric() || c == '.' || c == '-');
        if let Some(number) = head.number.as_ref().filter(is_plain).filter(|_| !said.has_number) {
            text.push(&format!("number {number}\n"), equation.span);
        }
        text.append(&lines_of(&said.about));
        text.append(&lines_of(local));
        text.push("prove ", equation.span);
        text.append(&goal.text);
        if let Some(proof) = &said.proof {
            text.push(" ", equation.span);
            text.append(proof);
        }
        if let Some(expect) = &said.expect {
            text.push("\n", equation.span);
            text.append(expect);
        }
        let (mut claims, _) = parse_placed(text.text(), &self.preamble, &|span| text.place(span))?;
        match claims.pop() {
            Some(claim) => Ok(Outcome::Read(Box::new(Claim { typeset: typeset(&equation.rows), ..claim }))),
            None => Err(vec![refused("this formula is no claim", "pass it over by `%carom skip`", equation.span)]),
        }
    }
}

/// Clauses, each on a line of its own.
fn lines_of(list: &[Placed]) -> Placed {
    let mut out = Placed::default();
    for clause in list {
        out.append(clause);
        out.push("\n", clause.span());
    }
    out
}
