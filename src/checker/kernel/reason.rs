//! Why the kernel rejects a step, in one place from variant to words.

use super::key;
use super::order::Signs;
use super::well_formed::Shape;
use crate::claim::syntax::{Expr, Prop};

/// Why a step is not justified.
#[derive(Clone, Debug)]
pub enum Reason {
    /// The certificate is of another claim.
    OtherClaim,
    /// A name is not declared here.
    Undeclared(String),
    /// A name that no text can say, or that has another meaning in the language.
    NoName(String),
    /// A tree that no text can say.
    Malformed(Shape),
    /// A name that should be new is in use.
    NameInUse(String),
    /// A label that should be new is in use.
    LabelInUse(String),
    /// No fact, and no accepted claim under `using`, has this name.
    NoFact(String),
    /// A sequence that is not defined by the member before.
    Sequence(String),
    /// A member of a sequence may have no value.
    Member(String, Box<Reason>),
    /// A variable that grows is tied to others by a hypothesis, family or sequence.
    Tied(String),
    /// What a point says of something that is no variable or member of the claim, or that has another value already, or
    /// with what is no number of its kind.
    Point(Expr),
    /// A family whose other members may not exist.
    PointFamily(String),
    /// An expression that is said to have no value is none of the goal, or needs nothing that could fail.
    NoPart(Expr),
    /// A block is open at the end.
    OpenBlock,
    /// No block is open.
    NoBlock,
    /// The last step does not show the goal.
    GoalNotShown,
    /// The cited fact is not the conclusion of the block.
    OtherConclusion(String),
    /// An implication is needed.
    NotAnImplication,
    /// A statement for all values is needed.
    NotForAll,
    /// `exists` is needed.
    NotExists,
    /// An extremum is needed.
    NotAnExtremum,
    /// A limit is needed, with what the rule cites.
    NotALimit,
    /// A single comparison is needed.
    NotSingle,
    /// An equation is needed.
    NotAnEquation,
    /// The left side of an equation that is put in is no single atom.
    NotAnAtom,
    /// The right side of a `name` step is no name.
    NotAName,
    /// A comparison with `<` or `>`, and a conclusion with `<=` or `>=`, are needed.
    NotStrict,
    /// A block, or an existence, of families.
    FamilyInBlock,
    /// A family is put for a family.
    FamilyForFamily,
    /// The families have different domains.
    OtherDomain(String),
    /// A sequence of the cited claim is not the same here.
    OtherSequence(String),
    /// A value for a name that is no variable, a variable without a value, or two values for one.
    ValueForNoVariable,
    /// With these values it says something else.
    ItSays(Prop),
    /// A proposition that is not among the cited facts.
    Needs(Prop),
    /// The domain of an induction is `natural` or `natural >= b` with a numeral.
    InductionDomain,
    /// An extremum is over real variables, with a value for each, which stand outside its scope.
    ExtremumDomain,
    /// The cited facts do not give a part of an expression the sign that it needs.
    NoValue {
        /// The part.
        part: Expr,
        /// The signs that it may have.
        signs: Signs,
    },
    /// An index outside its range, or a range that may end before it begins.
    Range(Expr),
    /// A limit is supposed, whose expression may have no value.
    LimitSupposed,
    /// The facts do not imply it.
    DoesNotFollow,
    /// In a case that the facts allow, a part of it has no value.
    NoValueInCase,
    /// A matrix where a number is needed.
    MatrixForNumber,
    /// A number where a matrix is needed.
    NumberForMatrix,
    /// The sizes of matrices do not fit, or matrices are put in order.
    MatrixSizes,
    /// A function has one argument.
    Arguments(String),
    /// An index that is not a whole number by its form.
    NotWhole,
    /// A derivative by what is not a real variable.
    NotAReal(String),
    /// A derivative of a member of a family or sequence, or of a sum or product over an index.
    DerivativeOfMember,
    /// A numeral that cannot be read.
    Numeral(String),
    /// The two sides of the combination differ.
    NoIdentity,
    /// Not of a form that rule `arc` shows.
    NotAnArc,
    /// A number that is not seen to lie less than three quarters of a turn from 0.
    BeyondThreeQuarters(Expr),
    /// The signs do not show the comparison.
    Signs,
    /// The multiplier may be 0.
    MultiplierMayBeZero,
    /// The powers on both sides are not shown to be the same.
    Powers,
    /// The sides are not the fact's sides to one power, nor the other way round.
    NotPowers,
    /// Neither a member of a sequence nor a sum or product.
    NothingToUnfold,
    /// It is not what the definition says.
    NotByDefinition,
    /// Not two sums or products over the same range.
    NotTermwise,
    /// A fact `for all t …: derivative(F, t) relation 0` is needed.
    NotADerivative,
    /// The first two facts do not say that an equation fails in opposite directions at the two values.
    SignsAtEnds,
    /// The domain of a fact about a derivative is no interval.
    NotAnInterval,
    /// Not a quotient of sums of powers of the variable that grows.
    NotRational,
    /// The leading coefficient of the divisor may be 0.
    LeadingCoefficient,
    /// The limit is another.
    OtherLimit,
    /// The bound does not hold for all large values.
    NotUnbounded,
    /// A division by 0.
    DivisionByZero,
    /// A polynomial is needed where a fraction stands.
    NotAPolynomial,
    /// A bound name would capture a name that is put in.
    Capture(String),
    /// A value takes the place of a variable that moves in a derivative or limit, or mentions it.
    Moves(String),
    /// A name or a family without a number at the point.
    NoNumber(Expr),
    /// It is false at the point.
    False,
    /// Enclosures do not decide it.
    NotDecided,
    /// A limit, extremum or derivative, or a statement about more than ranges, is not evaluated.
    NotEvaluated,
    /// A name that is put in is applied as a function is.
    NotAFunction(String),
}

impl std::fmt::Display for Reason {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let plain = match self {
            Reason::OtherClaim => "the certificate is of another claim",
            Reason::Undeclared(name) => return write!(f, "{name} is not declared here"),
            Reason::NoName(name) => return write!(f, "{name:?} cannot be a name here"),
            Reason::Malformed(shape) => match shape {
                Shape::Comparison => "a comparison has one more side than relations",
                Shape::Parts => "a sum or product has two parts at least, and begins with + or *",
                Shape::Connective => "`and`, `or` and `<=>` have two parts at least",
                Shape::Matrix => "a matrix has entries, in rows of one length",
                Shape::Arguments => "a function has an argument",
                Shape::Derivative => "a derivative is by a variable",
                Shape::Binding => "a quantifier and a declaration have names",
                Shape::Range => "what lies in a range `a..b` is natural",
                Shape::Extremum => "the point of an extremum gives each of its variables one value",
                Shape::WrittenLimit => "a limit at a point, or an infinite one, is written out",
                Shape::Label => "a label consists of letters and digits",
            },
            Reason::NameInUse(name) => return write!(f, "the name {name} is in use"),
            Reason::LabelInUse(label) => return write!(f, "the label {label} is in use"),
            Reason::NoFact(label) => return write!(f, "no fact and no accepted claim under `using` is called {label}"),
            Reason::Member(name, because) => return write!(f, "in the sequence {name} {because}"),
            Reason::Sequence(name) => return write!(f, "the sequence {name} is not defined by the member before"),
            Reason::Tied(name) => return write!(f, "{name} grows without bound and is tied to something else"),
            Reason::Point(place) => {
                let place = key::expr(place);
                return write!(f, "{place} is no place of a point here, or its value is no number for it");
            }
            Reason::PointFamily(name) => return write!(f, "{name} may have no other members in its domain"),
            Reason::NoPart(e) => {
                return write!(f, "{} is no expression of the goal, or nothing is needed for its value", key::expr(e));
            }
            Reason::OpenBlock => "a block is open at the end",
            Reason::NoBlock => "no block is open",
            Reason::GoalNotShown => "the last step does not show the goal",
            Reason::OtherConclusion(label) => return write!(f, "the fact {label} is not the block's conclusion"),
            Reason::NotAnImplication => "an implication is needed",
            Reason::NotForAll => "a statement `for all` one variable is needed",
            Reason::NotExists => "`exists` is needed",
            Reason::NotAnExtremum => "an extremum is needed",
            Reason::NotALimit => "a limit is needed",
            Reason::NotSingle => "a single comparison is needed, not a chain",
            Reason::NotAnEquation => "an equation is needed",
            Reason::NotAName => "the right side must be a new name",
            Reason::NotAnAtom => "the left side of an equation that is put in is a name, power, member, sum or product",
            Reason::NotStrict => "`<` or `>` is needed, and `<=` or `>=` as the conclusion",
            Reason::FamilyInBlock => "families are declared by the claim only",
            Reason::FamilyForFamily => "a family is put for a family",
            Reason::OtherDomain(name) => return write!(f, "the family {name} has another domain"),
            Reason::OtherSequence(name) => return write!(f, "the cited claim's sequence {name} is another here"),
            Reason::ValueForNoVariable => "each variable has one value, and nothing else has any",
            Reason::ItSays(p) => return write!(f, "with these values it says {}", key::prop(p)),
            Reason::BeyondThreeQuarters(e) => {
                return write!(f, "{} is not shown to be less than 3/4 of a turn", key::expr(e));
            }
            Reason::Needs(p) => return write!(f, "needs {}", key::prop(p)),
            Reason::InductionDomain => "induction is on one variable `natural` or `natural >= b`, b a numeral",
            Reason::ExtremumDomain => "an extremum is over real variables, with a value for each outside their scope",
            Reason::NoValue { part, signs } => {
                let what = match *signs {
                    Signs::NOT_ZERO => "other than 0",
                    Signs::POSITIVE => "positive",
                    _ => "at least 0",
                };
                return write!(f, "{} is not shown to be {what}", key::expr(part));
            }
            Reason::Range(e) => return write!(f, "the range or index of {} is not shown to be one", key::expr(e)),
            Reason::LimitSupposed => "a limit cannot be supposed",
            Reason::DoesNotFollow => "it does not follow from the cited facts",
            Reason::NoValueInCase => "a part of it may have no value where the cited facts hold",
            Reason::MatrixForNumber => "a number is needed where a matrix stands",
            Reason::NumberForMatrix => "a matrix is needed where a number stands",
            Reason::MatrixSizes => "matrices of different sizes, or in order",
            Reason::Arguments(name) => return write!(f, "{name} has one argument"),
            Reason::NotWhole => "an index or exponent that is not a whole number by its form",
            Reason::NotAReal(name) => return write!(f, "{name} is no real variable"),
            Reason::DerivativeOfMember => {
                "a derivative of a member of a family or sequence, or of a product over an index"
            }
            Reason::Numeral(text) => return write!(f, "the numeral {text} cannot be read"),
            Reason::NotAnArc => "this is no comparison of two arcs, and no equation for an arc",
            Reason::NoIdentity => "the two sides of the identity differ",
            Reason::Signs => "the signs do not show this",
            Reason::MultiplierMayBeZero => "the multiplier may be 0",
            Reason::Powers => "the powers on both sides are not shown to be the same",
            Reason::NotPowers => "these are not powers of the fact's sides with one exponent, nor the other way round",
            Reason::NothingToUnfold => "a member of a sequence, a sum or a product is needed",
            Reason::NotByDefinition => "this is not what the definition says",
            Reason::NotTermwise => "two sums or products over one range are needed, and a fact for all of it",
            Reason::NotADerivative => "a fact `for all t …: derivative(F, t) relation 0` is needed",
            Reason::SignsAtEnds => {
                "two facts are needed: the left side less than the right one at a, and greater at b; strictly where the domain lacks its ends"
            }
            Reason::NotAnInterval => {
                "a real variable with bounds `<`, `<=`, `>`, `>=` that do not mention it is needed"
            }
            Reason::NotRational => "a quotient of sums of powers of the variable that grows is needed",
            Reason::LeadingCoefficient => "the leading coefficient of the divisor may be 0",
            Reason::OtherLimit => "the limit is another",
            Reason::NotUnbounded => "the bound does not hold for all large values",
            Reason::DivisionByZero => "a division by 0",
            Reason::NotAPolynomial => "a polynomial is needed where a fraction stands",
            Reason::Capture(name) => return write!(f, "the bound name {name} would capture a name that is put in"),
            Reason::Moves(name) => {
                return write!(f, "a value is put in that takes the place of {name} or mentions it, which moves");
            }
            Reason::NoNumber(e) => return write!(f, "{} has no number here", key::expr(e)),
            Reason::False => "it is false",
            Reason::NotDecided => "enclosures do not decide it",
            Reason::NotEvaluated => {
                "limits, extrema, derivatives and statements about more than ranges are not evaluated"
            }
            Reason::NotAFunction(name) => return write!(f, "{name} is not a function"),
        };
        f.write_str(plain)
    }
}
