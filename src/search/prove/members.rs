//! Comparisons of sums over an index, by their members.
//!
//! Two parts. Divisors that hold no index, as in the sum of (x(i) − S/n)^2, get names: the kernel takes a factor out of a sum, but
//! no divisor, since a sum without members has a value where the divisor is 0. And a difference of the sides that is a
//! combination c_1·Σ f_1 + … + c_m·Σ f_m + r of sums over one range a..b is compared with 0 member by member: with r = 0 that is
//! c_1·f_1(k) + … + c_m·f_m(k), and else N·(c_1·f_1(k) + … + c_m·f_m(k)) + r for the number N = b + 1 − a of members.
//! Where that does not help, exponentials, logarithms, roots and quotients in the members are replaced by their tangents at 0 or 1, which
//! adds bounds of the sums; and squares of what the members are beside their mean are added up, which bounds sums of squares.
//!
//! Limits: [`SUMS`].

use super::coefficients::rational;
use super::facts::{minus, negated, scaled};
use super::letters::{product, total, whole_power};
use super::limits::{holds, over, plus};
use super::slopes::put_in;
use super::sums::replace;
use super::{Fail, Prover};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::claim::walk::{parts, parts_mut};
use crate::kernel::key;
use crate::kernel::statement::{apply, compare, expr, name, numeral, prop, sum};

/// The most sums in a comparison.
const SUMS: usize = 6;

/// A sum over an index, which is a name that nothing else has.
#[derive(Clone)]
struct Members {
    index: Index,
    body: Expr,
}

impl Members {
    fn sum_of(&self, body: &Expr) -> Expr {
        expr(ExprKind::SumOver(self.index.clone(), Box::new(body.clone())))
    }

    fn k(&self) -> &str {
        &self.index.name.text
    }

    /// How many there are.
    fn count(&self) -> Expr {
        let (from, to) = (&self.index.from, &self.index.to);
        sum(vec![(Sign::Plus, (**to).clone()), (Sign::Plus, numeral(1)), (Sign::Minus, (**from).clone())])
    }
}

/// Names for inverses, and their equations.
#[derive(Default)]
struct Inverses {
    /// Each divisor with the name.
    names: Vec<(Expr, Expr)>,
    labels: Vec<Label>,
}

/// A name for a sum, and the equations of this name.
struct Letter {
    name: Expr,
    /// It is the sum as written.
    own: Label,
    /// It is the sum with names of inverses.
    new: Label,
    /// It is that in its normal form.
    simple: Label,
}

/// A way to bound a sum.
type Way<'a> = Box<dyn Fn(&mut Prover, &mut Inverses) -> Result<Label, Fail> + 'a>;

/// A fact as it is.
fn fact(label: &Label) -> Term {
    scaled(label, numeral(1))
}

/// An equation with its sides changed.
fn turned(label: &Label) -> Term {
    scaled(label, negated(numeral(1)))
}

impl Prover {
    /// A comparison of sums over an index, by what is known of their members.
    pub(super) fn by_members(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("sums over an index");
        let mut sums = Vec::new();
        let mut sides = Vec::new();
        super::goals::sides_in(goal, &mut sides);
        sides.iter().for_each(|e| outermost(e, &mut sums));
        let has_members = sums.iter().any(|s| matches!(&s.kind, ExprKind::SumOver(i, _) if rational(&i.to).is_none()));
        if self.in_members || self.inductions > 0 || self.splits > 3 || !has_members || sums.len() > SUMS {
            return Err(no());
        }
        if !self.compared.insert(key::prop(goal)) {
            return Err(no());
        }
        let mut goal = goal.clone();
        if let PropKind::Compare(sides, _) = &mut goal.kind {
            sides.iter_mut().for_each(|e| self.own_indices(e, &mut Vec::new()));
        }
        sums.iter_mut().for_each(|e| self.own_indices(e, &mut Vec::new()));
        self.in_members = true;
        let shown = self.on_its_own(|c| c.with_named_divisors(&goal, &sums));
        self.in_members = false;
        shown
    }

    /// Gives the index of a sum another name where a sum around it has the same.
    fn own_indices(&mut self, e: &mut Expr, around: &mut Vec<String>) {
        let outside = around.len();
        if let ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) = &mut e.kind {
            if around.contains(&index.name.text) {
                let new = self.fresh("k");
                if let Ok(other) = put_in(body, &index.name.text, &name(&new)) {
                    (index.name, **body) = (Name::new(&new), other);
                }
            }
            around.push(index.name.text.clone());
        }
        parts_mut(e, &mut |part| self.own_indices(part, around));
        around.truncate(outside);
    }

    /// A goal with names for its sums in which divisors hold no index.
    fn with_named_divisors(&mut self, goal: &Prop, sums: &[Expr]) -> Result<Label, Fail> {
        let (mut named, mut written, mut own) = (goal.clone(), goal.clone(), Vec::new());
        let (mut inverses, mut letters) = (Inverses::default(), Vec::new());
        for s in sums {
            let Some(members) = self.members(s)? else { continue };
            let body = self.inverses_named(&members, &members.body, &mut inverses)?;
            if body == members.body {
                own.push(members);
                continue;
            }
            let letter = self.sum_named(&members, &body, &inverses)?;
            let members = Members { body, ..members };
            in_prop(&mut named, s, &letter.name);
            in_prop(&mut written, s, &members.sum_of(&members.body));
            letters.push(letter);
            own.push(members);
        }
        if letters.is_empty() {
            return self.member_by_member(goal, &own, &mut inverses);
        }
        letters.iter().for_each(|letter| self.put_in(&letter.simple));
        inverses.labels.iter().for_each(|label| self.put_in(label));
        let by_letters = self.combination(named.clone(), Vec::new());
        let shown = match by_letters.or_else(|_| self.attempt(|c| c.without_cases(&named))) {
            Ok(label) => label,
            Err(_) => {
                let shown = self.member_by_member(&written, &own, &mut inverses)?;
                self.combination_by(letters.iter().map(|letter| &letter.new), named, vec![fact(&shown)])?
            }
        };
        self.combination_by(letters.iter().map(|letter| &letter.own), goal.clone(), vec![fact(&shown)])
    }

    /// A combination with these equations put in and no others.
    fn combination_by<'a>(
        &mut self,
        equations: impl IntoIterator<Item = &'a Label>,
        goal: Prop,
        terms: Vec<Term>,
    ) -> Result<Label, Fail> {
        let before = std::mem::replace(&mut self.equations, equations.into_iter().cloned().collect());
        let label = self.combination(goal, terms);
        self.equations = before;
        label
    }

    /// A body with names of inverses in the place of the divisors that hold no index.
    fn inverses_named(&mut self, members: &Members, body: &Expr, inverses: &mut Inverses) -> Result<Expr, Fail> {
        let mut divisors = Vec::new();
        constant_divisors(body, &mut vec![members.k().to_string()], &mut divisors);
        for d in divisors {
            if !inverses.names.iter().any(|(of, _)| key::expr(of) == key::expr(&d)) {
                let (q, inverse) = (name(&self.fresh("q")), over(numeral(1), d.clone()));
                let label = self.emit(Rule::Name, compare(inverse.clone(), Relation::Equal, q.clone()))?;
                let label = self.combination(compare(q.clone(), Relation::Equal, inverse), vec![turned(&label)])?;
                for relation in [Relation::Greater, Relation::Less] {
                    let signed = compare(q.clone(), relation, numeral(0));
                    if self.attempt(|c| c.combination_by([&label], signed.clone(), Vec::new())).is_ok() {
                        break;
                    }
                }
                inverses.names.push((d, q));
                inverses.labels.push(label);
            }
        }
        let mut body = body.clone();
        times_names(&mut body, &inverses.names);
        Ok(body)
    }

    /// A sum whose index is a new name.
    fn members(&mut self, s: &Expr) -> Result<Option<Members>, Fail> {
        let ExprKind::SumOver(index, body) = &s.kind else { return Ok(None) };
        let k = self.fresh("k");
        let body = put_in(body, &index.name.text, &name(&k))?;
        Ok(Some(Members { index: Index { name: Name::new(&k), ..index.clone() }, body }))
    }

    /// A name for a sum, which is the sum of another body as well.
    fn sum_named(&mut self, members: &Members, body: &Expr, inverses: &Inverses) -> Result<Letter, Fail> {
        let same = compare(members.body.clone(), Relation::Equal, body.clone());
        let same = self.for_each_member(members, &same, inverses)?;
        let (whole, new) = (members.sum_of(&members.body), members.sum_of(body));
        let same = self.emit(Rule::Termwise { from: same }, compare(whole.clone(), Relation::Equal, new.clone()))?;
        let s = name(&self.fresh("s"));
        let label = self.emit(Rule::Name, compare(whole.clone(), Relation::Equal, s.clone()))?;
        let own = self.combination(compare(s.clone(), Relation::Equal, whole), vec![turned(&label)])?;
        let terms = vec![fact(&own), fact(&same)];
        let simple = self.simplified_alone(&new);
        let new = self.combination(compare(s.clone(), Relation::Equal, new), terms)?;
        let simple = self.combination(compare(s.clone(), Relation::Equal, simple), vec![fact(&new)])?;
        Ok(Letter { name: s, own, new, simple })
    }

    /// An expression in its normal form, no equation put in: the names of inverses are taken out of its sums.
    fn simplified_alone(&mut self, e: &Expr) -> Expr {
        let before = std::mem::take(&mut self.equations);
        let simple = self.simplified(e);
        self.equations = before;
        simple.unwrap_or_else(|| e.clone())
    }

    /// Shows something for all indices of a sum.
    fn for_each_member(&mut self, members: &Members, body: &Prop, inverses: &Inverses) -> Result<Label, Fail> {
        let before = self.equations.clone();
        inverses.labels.iter().for_each(|label| self.put_in(label));
        let range = Constraint::Range((*members.index.from).clone(), (*members.index.to).clone());
        let binding = Binding::of(members.index.name.clone(), true, vec![range]);
        let shown = self.without_cases(&prop(PropKind::ForAll(vec![binding], Box::new(body.clone()))));
        self.equations = before;
        shown
    }

    /// A comparison by the members of its sums, or by bounds of sums that their members give.
    fn member_by_member(&mut self, goal: &Prop, sums: &[Members], inverses: &mut Inverses) -> Result<Label, Fail> {
        if let Ok(label) = self.combination(goal.clone(), Vec::new()) {
            return Ok(label);
        }
        if let Ok(label) = self.with_half(|c| c.of_one_range(goal, inverses)) {
            return Ok(label);
        }
        let is_order = |p: &Prop| matches!(&p.kind, PropKind::Compare(_, r) if !r.contains(&Relation::Equal));
        let mut sides = Vec::new();
        super::goals::sides_in(goal, &mut sides);
        let is_product = sides.iter().any(|e| !Linear::default().add(e, &numeral(1), false));
        let mut any = false;
        for members in sums.iter().filter(|_| is_order(goal)) {
            let mut ways: Vec<Way<'_>> = Vec::new();
            for (mut bound, relation) in tangents(members) {
                self.own_indices(&mut bound, &mut vec![members.k().to_string()]);
                ways.push(Box::new(move |c, inverses| c.bounds_sum(members, &bound, relation, inverses)));
            }
            for (weight, x) in weighted(&members.body).into_iter().filter(|_| is_product) {
                ways.push(Box::new(move |c, inverses| c.beside_the_mean(members, &weight, &x, inverses)));
            }
            for way in ways {
                let named = (inverses.names.len(), inverses.labels.len());
                match self.on_its_own(|c| way(c, inverses)) {
                    Ok(label) => {
                        any = true;
                        if let Ok(label) = self.combination(goal.clone(), vec![fact(&label)]) {
                            return Ok(label);
                        }
                    }
                    Err(_) => {
                        inverses.names.truncate(named.0);
                        inverses.labels.truncate(named.1);
                    }
                }
            }
        }
        if any { self.attempt(|c| c.without_cases(goal)) } else { Err(Fail::No("bounds of the members of sums")) }
    }

    /// A comparison of combinations of sums over one range.
    fn of_one_range(&mut self, goal: &Prop, inverses: &Inverses) -> Result<Label, Fail> {
        let no = || Fail::No("combinations of sums over one range");
        let Some((a, relation, b)) = goal.single() else { return Err(no()) };
        let (mut left, mut right) = (Linear::default(), Linear::default());
        if relation == Relation::NotEqual || !left.add(a, &numeral(1), false) || !right.add(b, &numeral(1), false) {
            return Err(no());
        }
        left.moved_to(&mut right);
        let (_, first, _) = left.sums.first().or(right.sums.first()).cloned().ok_or_else(no)?;
        let ends = |index: &Index| (key::expr(&index.from), key::expr(&index.to));
        if left.sums.iter().chain(&right.sums).any(|(_, index, _)| ends(index) != ends(&first)) {
            return Err(no());
        }
        let has_rest = !left.rest.is_empty() || !right.rest.is_empty();
        // Members that are all equal to a number are none that hold the index.
        if has_rest && relation == Relation::Equal {
            return Err(no());
        }
        let members = Members { index: Index { name: Name::new(self.fresh("k")), ..first }, body: numeral(0) };
        let count = has_rest.then(|| members.count());
        let (left, right) = (left.member(&members, count.as_ref())?, right.member(&members, count.as_ref())?);
        // A sum without members is 0, so strict orders of members show strict orders of sums only where the kernel sees a member.
        let weak = match relation {
            Relation::Less => Relation::LessEqual,
            Relation::Greater => Relation::GreaterEqual,
            other => other,
        };
        let mut ways = vec![relation, weak];
        ways.dedup();
        for way in ways {
            let shown = self.attempt(|c| {
                let every = c.for_each_member(&members, &compare(left.clone(), way, right.clone()), inverses)?;
                let label = if way == weak {
                    let sides = compare(members.sum_of(&left), weak, members.sum_of(&right));
                    c.emit(Rule::Termwise { from: every }, sides)?
                } else {
                    let difference = members.sum_of(&minus(&left, &right));
                    c.combination(compare(difference, way, numeral(0)), Vec::new())?
                };
                c.emit(Rule::Combination { times: count.clone(), terms: vec![fact(&label)] }, goal.clone())
            });
            if shown.is_ok() {
                return shown;
            }
        }
        Err(no())
    }

    /// A bound of a sum from a bound of its members, as a fact.
    fn bounds_sum(
        &mut self,
        members: &Members,
        bound: &Expr,
        relation: Relation,
        inverses: &mut Inverses,
    ) -> Result<Label, Fail> {
        let bound = self.inverses_named(members, bound, inverses)?;
        let every = compare(members.body.clone(), relation, bound.clone());
        let every = self.for_each_member(members, &every, inverses)?;
        let (whole, new) = (members.sum_of(&members.body), members.sum_of(&bound));
        let simple = self.simplified_alone(&new);
        let label = self.emit(Rule::Termwise { from: every }, compare(whole.clone(), relation, new))?;
        let bounded = compare(whole, relation, simple);
        let label = self.combination_by([], bounded.clone(), vec![fact(&label)])?;
        inverses.labels.iter().for_each(|label| self.put_in(label));
        self.take_in(&label, &bounded).map(|()| label)
    }

    /// Σ w(k)·(W·x(k) − Σ w·x)^2 >= 0 with W = Σ w, as a fact: of members w(k)·x(k) that are not alike to their mean.
    fn beside_the_mean(
        &mut self,
        members: &Members,
        weight: &Expr,
        x: &Expr,
        inverses: &mut Inverses,
    ) -> Result<Label, Fail> {
        let all = product(vec![members.sum_of(weight), x.clone()]);
        let mut beside = minus(&all, &members.sum_of(&members.body));
        self.own_indices(&mut beside, &mut vec![members.k().to_string()]);
        let body = product(vec![weight.clone(), whole_power(beside, 2)]);
        let squares = Members { body, ..members.clone() };
        self.bounds_sum(&squares, &numeral(0), Relation::GreaterEqual, inverses)
    }
}

/// A body as a weight and what it is the weight of: 1 and the body, and each factor and the others.
fn weighted(body: &Expr) -> Vec<(Expr, Expr)> {
    let mut out = vec![(numeral(1), body.clone())];
    if let ExprKind::Product(list) = &body.kind
        && list.iter().all(|(how, _)| *how == Factor::Times)
    {
        let factors: Vec<Expr> = list.iter().map(|(_, e)| e.clone()).collect();
        for (place, weight) in factors.iter().enumerate() {
            let others = factors.iter().enumerate().filter(|(k, _)| *k != place).map(|(_, e)| e.clone());
            out.push((weight.clone(), product(others.collect())));
        }
    }
    out
}

/// The sums that stand in no other, each once.
fn outermost(e: &Expr, out: &mut Vec<Expr>) {
    match &e.kind {
        ExprKind::SumOver(..) => {
            if !out.iter().any(|s| key::expr(s) == key::expr(e)) {
                out.push(e.clone());
            }
        }
        ExprKind::ProductOver(..) | ExprKind::IntegralOver(..) | ExprKind::Derivative(..) => {}
        _ => parts(e, &mut |part| outermost(part, out)),
    }
}

/// Whether an expression is a divisor that holds none of these names.
fn is_constant(how: Factor, e: &Expr, bound: &[String]) -> bool {
    how == Factor::Over && !matches!(e.kind, ExprKind::Number(_)) && !bound.iter().any(|k| holds(e, k))
}

/// The divisors without a bound name, each once.
fn constant_divisors(e: &Expr, bound: &mut Vec<String>, out: &mut Vec<Expr>) {
    if let ExprKind::Product(list) = &e.kind {
        for (_, d) in list.iter().filter(|(how, d)| is_constant(*how, d, bound)) {
            if !out.iter().any(|known| key::expr(known) == key::expr(d)) {
                out.push(d.clone());
            }
        }
    }
    let outside = bound.len();
    if let ExprKind::SumOver(index, _) | ExprKind::ProductOver(index, _) | ExprKind::IntegralOver(index, _) = &e.kind {
        bound.push(index.name.text.clone());
    }
    parts(e, &mut |part| constant_divisors(part, bound, out));
    bound.truncate(outside);
}

/// Factors that are the names of their inverses in the place of divisors.
fn times_names(e: &mut Expr, names: &[(Expr, Expr)]) {
    if let ExprKind::Product(list) = &mut e.kind {
        for (how, d) in list.iter_mut().filter(|(how, _)| *how == Factor::Over) {
            if let Some((_, q)) = names.iter().find(|(of, _)| key::expr(of) == key::expr(d)) {
                (*how, *d) = (Factor::Times, q.clone());
            }
        }
    }
    parts_mut(e, &mut |part| times_names(part, names));
}

/// Puts a value in the place of an expression in the sides of a comparison.
fn in_prop(p: &mut Prop, old: &Expr, value: &Expr) {
    if let PropKind::Compare(sides, _) = &mut p.kind {
        sides.iter_mut().for_each(|e| replace(e, old, value));
    }
}

/// Factors times sums, and a rest without sums.
#[derive(Default)]
struct Linear {
    sums: Vec<(Expr, Index, Expr)>,
    rest: Vec<(Sign, Expr)>,
}

impl Linear {
    /// Adds a factor times an expression, or takes it away. Whether it is such a combination.
    fn add(&mut self, e: &Expr, factor: &Expr, minus: bool) -> bool {
        let signed = |minus: bool| if minus { negated(factor.clone()) } else { factor.clone() };
        match &e.kind {
            ExprKind::SumOver(index, body) => {
                self.sums.push((signed(minus), index.clone(), (**body).clone()));
                true
            }
            ExprKind::Negate(inner) => self.add(inner, factor, !minus),
            ExprKind::Sum(list) => list.iter().all(|(sign, e)| self.add(e, factor, minus != (*sign == Sign::Minus))),
            ExprKind::Product(list) if has_sum(e) => {
                let holding: Vec<usize> =
                    (0..list.len()).filter(|k| list.get(*k).is_some_and(|f| has_sum(&f.1))).collect();
                let [place] = holding.as_slice() else { return false };
                let Some((Factor::Times, inner)) = list.get(*place).cloned() else { return false };
                let mut others = list.clone();
                others.remove(*place);
                others.insert(0, (Factor::Times, factor.clone()));
                self.add(&inner, &expr(ExprKind::Product(others)), minus)
            }
            _ if has_sum(e) => false,
            _ => {
                let sign = if minus { Sign::Minus } else { Sign::Plus };
                if *e != numeral(0) {
                    self.rest.push((sign, product(vec![factor.clone(), e.clone()])));
                }
                true
            }
        }
    }

    /// The rest beside the sums of this side, or beside those of another where this one has none.
    fn moved_to(&mut self, other: &mut Linear) {
        let (from, to) = if other.sums.is_empty() { (self, other) } else { (other, self) };
        let moved = from.rest.drain(..).map(|(sign, e)| (if sign == Sign::Plus { Sign::Minus } else { Sign::Plus }, e));
        to.rest.extend(moved);
    }

    /// What one member adds: of N members each has N times its own part, and the rest; without a rest its own part.
    fn member(&self, members: &Members, count: Option<&Expr>) -> Result<Expr, Fail> {
        let mut list = Vec::new();
        for (factor, index, body) in &self.sums {
            let body = put_in(body, &index.name.text, &name(members.k()))?;
            list.push((Sign::Plus, product(count.into_iter().cloned().chain([factor.clone(), body]).collect())));
        }
        list.extend(self.rest.iter().cloned());
        Ok(if list.is_empty() { numeral(0) } else { total(list) })
    }
}

fn has_sum(e: &Expr) -> bool {
    let mut sums = Vec::new();
    outermost(e, &mut sums);
    !sums.is_empty()
}

/// What members may be bounded by, from below and from above: tangents of their exponentials, logarithms, roots and quotients, at 1
/// (of an exponential at 0) and at the mean of their arguments. Whether it is a bound, the members have to show.
fn tangents(members: &Members) -> Vec<(Expr, Relation)> {
    let mut out = Vec::new();
    for way in [at_one, at_mean] {
        let mut bound = members.body.clone();
        changed(&mut bound, members, way);
        if bound != members.body {
            out.extend([Relation::GreaterEqual, Relation::LessEqual].map(|relation| (bound.clone(), relation)));
        }
    }
    out
}

/// exp u >= 1 + u, ln u >= 1 − 1/u, sqrt u <= (u + 1)/2.
fn at_one(f: &str, u: &Expr, _: &Members) -> Option<Expr> {
    Some(match f {
        "exp" => plus(&numeral(1), u.clone()),
        "ln" => minus(&numeral(1), &inverse(u)),
        "sqrt" => over(plus(u, numeral(1)), numeral(2)),
        _ => return None,
    })
}

/// 1/u, a quotient turned round: divisors that hold no index stay to be seen.
fn inverse(u: &Expr) -> Expr {
    let ExprKind::Product(list) = &u.kind else { return over(numeral(1), u.clone()) };
    let turned = |how: Factor| if how == Factor::Times { Factor::Over } else { Factor::Times };
    let turned = list.iter().map(|(how, e)| (turned(*how), e.clone()));
    expr(ExprKind::Product([(Factor::Times, numeral(1))].into_iter().chain(turned).collect()))
}

/// With the mean m of u: exp u >= exp(m)·(1 + u − m), ln u <= ln m + u/m − 1, sqrt u <= sqrt(m)·(u/m + 1)/2, 1/u >= (2 − u/m)/m.
fn at_mean(f: &str, u: &Expr, members: &Members) -> Option<Expr> {
    let all = Members { body: u.clone(), ..members.clone() };
    let m = over(all.sum_of(u), members.count());
    let part = over(product(vec![u.clone(), members.count()]), all.sum_of(u));
    let of_mean = |f: &str| apply(f, m.clone());
    Some(match f {
        "exp" => product(vec![of_mean(f), plus(&numeral(1), minus(u, &m))]),
        "ln" => plus(&of_mean(f), minus(&part, &numeral(1))),
        "sqrt" => over(product(vec![of_mean(f), plus(&part, numeral(1))]), numeral(2)),
        "1/" => over(minus(&numeral(2), &part), m),
        _ => return None,
    })
}

type Tangent = fn(&str, &Expr, &Members) -> Option<Expr>;

fn changed(e: &mut Expr, members: &Members, tangent: Tangent) {
    match &mut e.kind {
        ExprKind::Apply(f, arguments) => {
            if let [u] = arguments.as_slice()
                && holds(u, members.k())
                && let Some(new) = tangent(&f.text, u, members)
            {
                *e = new;
                return;
            }
        }
        ExprKind::Product(list) => {
            for (how, u) in list {
                let is_divisor = *how == Factor::Over && holds(u, members.k());
                match tangent("1/", u, members).filter(|_| is_divisor) {
                    Some(new) => (*how, *u) = (Factor::Times, new),
                    None => changed(u, members, tangent),
                }
            }
            return;
        }
        _ => {}
    }
    parts_mut(e, &mut |part| changed(part, members, tangent));
}
