//! The sizes of matrices: whether each stands where a matrix of that size may stand.

use super::outcome::Diagnose;
use crate::claim::syntax::*;
use crate::claim::walk::parts;

/// Rows and columns; none for a number.
type Size = Option<(usize, usize)>;

/// The largest matrix of which a determinant is taken.
pub(crate) const LARGEST: usize = 6;

/// The first matrix of a proposition that does not fit where it stands.
///
/// # Errors
/// What is wrong with it.
pub(crate) fn check(prop: &Prop) -> Result<(), Diagnose> {
    match &prop.kind {
        PropKind::Compare(sides, relations) => {
            let sizes = sides.iter().map(of).collect::<Result<Vec<Size>, _>>()?;
            sizes.windows(2).zip(relations).try_for_each(|(pair, relation)| compared(pair[0], *relation, pair[1], prop))
        }
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => list.iter().try_for_each(check),
        PropKind::Not(p) | PropKind::ForAll(_, p) | PropKind::Exists(_, p) => check(p),
        PropKind::Implies(p, q) => check(p).and_then(|()| check(q)),
        PropKind::Extremum(e) => [&e.of, &e.value].into_iter().chain(e.at.iter().map(|a| &a.1)).try_for_each(is_number),
        PropKind::Limit(l) => [&l.of, &l.value].into_iter().try_for_each(is_number),
        PropKind::WrittenLimit(l) => l.parts().try_for_each(is_number),
    }
}

fn compared(a: Size, relation: Relation, b: Size, prop: &Prop) -> Result<(), Diagnose> {
    let is_equation = matches!(relation, Relation::Equal | Relation::NotEqual);
    match (a, b) {
        (None, None) => Ok(()),
        (Some(a), Some(b)) if is_equation && a == b => Ok(()),
        (Some(_), Some(_)) if is_equation => fault(prop.span, "the sizes of these matrices differ"),
        (Some(_), Some(_)) => fault(prop.span, "matrices have no order: compare them by = or !="),
        _ => fault(prop.span, "a matrix is compared with a number"),
    }
}

fn is_number(e: &Expr) -> Result<(), Diagnose> {
    match of(e)? {
        None => Ok(()),
        Some(_) => fault(e.span, "a matrix stands where a number is needed"),
    }
}

fn of(e: &Expr) -> Result<Size, Diagnose> {
    match &e.kind {
        ExprKind::Number(_) | ExprKind::Name(_) => Ok(None),
        ExprKind::Negate(a) => of(a),
        ExprKind::Sum(list) => {
            let mut sizes = list.iter().map(|(_, a)| Ok((of(a)?, a.span)));
            let (first, _) = sizes.next().unwrap_or(Ok((None, e.span)))?;
            for next in sizes {
                match next? {
                    (size, _) if size == first => {}
                    (Some(_), span) if first.is_some() => return fault(span, "the sizes of these matrices differ"),
                    _ => return fault(e.span, "a number cannot be added to a matrix"),
                }
            }
            Ok(first)
        }
        ExprKind::Product(list) => list.iter().try_fold(None, |size, (operator, factor)| match (size, of(factor)?) {
            (_, Some(_)) if *operator == Factor::Over => fault(factor.span, "division by a matrix is not defined"),
            (None, size) | (size, None) => Ok(size),
            (Some((rows, inner)), Some((other, columns))) if inner == other => Ok(Some((rows, columns))),
            _ => fault(factor.span, "the sizes of these matrices do not match"),
        }),
        ExprKind::Apply(f, arguments) => match (f.text.as_str(), arguments.as_slice()) {
            ("det" | "transpose", [m]) => match (f.text.as_str(), of(m)?) {
                (_, None) => fault(m.span, "a matrix is needed here"),
                ("transpose", Some((rows, columns))) => Ok(Some((columns, rows))),
                (_, Some((rows, columns))) if rows == columns && rows <= LARGEST => Ok(None),
                _ => fault(m.span, "a square matrix of at most 6 rows is needed here"),
            },
            _ => numbers(e),
        },
        ExprKind::Matrix(rows) => numbers(e).map(|_| Some((rows.len(), rows.first().map_or(0, Vec::len)))),
        ExprKind::Power(..)
        | ExprKind::SumOver(..)
        | ExprKind::ProductOver(..)
        | ExprKind::IntegralOver(..)
        | ExprKind::Derivative(..) => numbers(e),
    }
}

/// All parts are numbers, and so is what is made of them.
fn numbers(e: &Expr) -> Result<Size, Diagnose> {
    let mut result = Ok(());
    parts(e, &mut |part| {
        if result.is_ok() {
            result = is_number(part);
        }
    });
    result.map(|()| None)
}

fn fault<T>(span: Span, message: &str) -> Result<T, Diagnose> {
    Err(Diagnose { message: message.to_string(), help: None, span })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claim::parse::parse_prop;

    #[test]
    fn a_matrix_stands_only_where_one_of_its_size_may() {
        let said = |text: &str| check(&parse_prop(text).expect("it parses")).err().map_or(String::new(), |f| f.message);
        for (text, message) in [
            ("[a, 1] < [2, a]", "matrices have no order"),
            ("[a, 1] != [1; a]", "the sizes of these matrices differ"),
            ("[a, 1] != 1", "a matrix is compared with a number"),
            ("[a, 1] + [1; a] = [1, 1]", "the sizes of these matrices differ"),
            ("[a, 1] + 1 = [1, 1]", "a number cannot be added to a matrix"),
            ("1/[a, 1] = [1, 1]", "division by a matrix is not defined"),
            ("[a, 1]*[1, a] = [1, 1]", "the sizes of these matrices do not match"),
            ("det(a) = 1", "a matrix is needed here"),
            ("det([1, a]) = 1", "a square matrix of at most 6 rows is needed here"),
            ("sqrt([1, a]) = 1", "a matrix stands where a number is needed"),
            ("[[1, a], 1] = [1, 1]", "a matrix stands where a number is needed"),
        ] {
            assert!(said(text).starts_with(message), "{text}: {}", said(text));
        }
        for text in ["2*[a, 1; 1, a]*[1; a] = [1; a]", "det(transpose([1, a; a, 1])) = 1", "[a, 1]*[1; a] = [2*a]"] {
            assert_eq!(said(text), "", "{text}");
        }
    }
}
