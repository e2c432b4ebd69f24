//! Numbers as people type them: the one reader of every field, flag, file and string.
//!
//! Contract: [`number`] reads one number or one measured value, [`list`] reads several. Both change the spelling and
//! never the value: `.9` and `0,9` are `0.9`, `90 %` is `0.90`, `1 000` is `1000`, `−3` with the sign U+2212 is `-3`,
//! `5 1/2` is `11/2`, `2·10^3` and `2·10³` are `2e3`, `2*5` is `10`. A text with two readings, such as `1,000` or `1/2*3`, is
//! refused with both of them. Whatever is no number in any of these spellings is handed on as it is, so that the reader of numerals says what is wrong with it.
//! [`read`] is both readers, one after the other.

use super::rational::{self, NumeralError};
use malachite::Rational;
use malachite::base::num::basic::traits::One;

/// Why a text has no one reading.
#[derive(Debug, PartialEq, Eq)]
pub struct Unclear(pub String);

/// Reads a number as it was typed.
///
/// ```
/// use carom_exact::number::typed::read;
/// assert_eq!(read("0,9"), read("90 %"));
/// assert!(read("1,000").unwrap_err().to_string().contains("write 1000 or 1.000"));
/// ```
///
/// # Errors
/// [`NumeralError`].
pub fn read(text: &str) -> Result<Rational, NumeralError> {
    let plain = number(text).map_err(|Unclear(what)| NumeralError::Unclear { what })?;
    rational::parse(&plain)
}

/// Blanks that may stand inside a number: of a keyboard, a word processor, a typeset table.
const BLANKS: [char; 4] = [' ', '\u{a0}', '\u{2009}', '\u{202f}'];
/// Signs of a measured value.
const PLUS_MINUS: [&str; 3] = ["±", "+/-", "+-"];
/// Signs between the factors of a product.
const TIMES: [char; 4] = ['·', '*', '×', '⋅'];
/// The most factors of a product.
const MAX_FACTORS: usize = 8;
/// Raised digits and signs.
const RAISED: [(char, char); 11] = [
    ('⁰', '0'),
    ('¹', '1'),
    ('²', '2'),
    ('³', '3'),
    ('⁴', '4'),
    ('⁵', '5'),
    ('⁶', '6'),
    ('⁷', '7'),
    ('⁸', '8'),
    ('⁹', '9'),
    ('⁻', '-'),
];
/// Fractions that have a character of their own.
const VULGAR: [(char, &str); 8] =
    [('½', "1/2"), ('⅓', "1/3"), ('⅔', "2/3"), ('¼', "1/4"), ('¾', "3/4"), ('⅕', "1/5"), ('⅛', "1/8"), ('⅒', "1/10")];

/// One number or measured value.
///
/// # Errors
/// [`Unclear`], with both readings.
pub fn number(text: &str) -> Result<String, Unclear> {
    let text = text.trim();
    if let Some(inside) = text.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
        // Two ends need a comma between them: a single one is no decimal comma.
        let is_single = inside.matches(',').count() == 1;
        let inside = if is_single { inside.replace(',', ";") } else { inside.to_owned() };
        let ends = list(&inside, |end| rational::parse(end).is_ok())?;
        return Ok(format!("[{}]", ends.join(", ")));
    }
    if let Some((centre, last)) = text.strip_suffix(')').and_then(|rest| rest.split_once('('))
        && digits(last)
    {
        return Ok(format!("{}({last})", one(centre)?));
    }
    let Some((sign, (centre, reach))) = PLUS_MINUS.iter().find_map(|sign| Some((*sign, text.split_once(sign)?))) else {
        return one(text);
    };
    let sign = if sign == "±" { sign } else { "+-" };
    // A share of the value before it, which has no such sign: 57.1 ± 1 %.
    let is_share = |reach: &&str| ![reach, centre].iter().any(|part| part.trim_end().ends_with('%'));
    let share = reach.trim_end().strip_suffix('%').filter(is_share);
    Ok(match share {
        Some(share) => format!("{} {sign} {} %", one(centre)?, one(share)?),
        None => format!("{} {sign} {}", one(centre)?, one(reach)?),
    })
}

/// Several numbers, separated by commas or, where commas are decimal ones, by semicolons or by commas with a blank.
/// `fits` says whether a number, in the engine's spelling, is possible here.
///
/// # Errors
/// [`Unclear`], with both readings.
pub fn list(text: &str, fits: impl Fn(&str) -> bool) -> Result<Vec<String>, Unclear> {
    if !parts(text, |c, _, _| c == ';').1.is_empty() {
        return parts(text, |c, _, _| c == ';').0.into_iter().map(number).collect();
    }
    let blank = |c: Option<char>| c.is_none_or(|c| BLANKS.contains(&c));
    let tight = |c: char, before: Option<char>, after: Option<char>| c == ',' && !blank(before) && !blank(after);
    let every: Vec<&str> = parts(text, |c, _, _| c == ',').0;
    let loose: Vec<&str> = parts(text, |c, before, after| c == ',' && !tight(c, before, after)).0;
    let read = |parts: &[&str]| -> Option<Vec<String>> {
        let found: Vec<String> = parts.iter().map(|part| number(part).ok()).collect::<Option<_>>()?;
        found.iter().all(|part| fits(part)).then_some(found)
    };
    if every.len() == loose.len() {
        return every.into_iter().map(number).collect();
    }
    match (read(&every), read(&loose)) {
        (Some(separate), None) => Ok(separate),
        (None, Some(decimal)) => Ok(decimal),
        (Some(_), Some(decimal)) => Err(Unclear(format!(
            "{text:?} has two readings: write {} if the comma is a decimal point, {} if it separates two numbers",
            decimal.join("; "),
            every.iter().map(|part| part.trim()).collect::<Vec<_>>().join("; "),
        ))),
        // Neither: the ambiguity of a single number is the better message, else the faulty element is named.
        (None, None) if loose.len() == 1 && every.len() == 2 => match number(text) {
            Err(unclear) => Err(unclear),
            Ok(_) => every.into_iter().map(number).collect(),
        },
        (None, None) => every.into_iter().map(number).collect(),
    }
}

/// The axis of a table: a list, or a run `start:stop:step`, whose parts may have decimal commas.
///
/// # Errors
/// [`Unclear`], with both readings.
pub fn grid(text: &str, fits: impl Fn(&str) -> bool) -> Result<String, Unclear> {
    if text.contains(';') || !text.contains(':') {
        return Ok(list(text, fits)?.join(","));
    }
    let part = |part: &str| match part.trim().strip_prefix('x') {
        Some(factor) => number(factor).map(|factor| format!("x{factor}")),
        None => number(part),
    };
    Ok(text.split(':').map(part).collect::<Result<Vec<_>, _>>()?.join(":"))
}

/// The parts of a text between separators that stand outside of brackets, and the separators' places.
fn parts(text: &str, separates: impl Fn(char, Option<char>, Option<char>) -> bool) -> (Vec<&str>, Vec<usize>) {
    let (mut depth, mut before) = (0_i32, None);
    let (mut found, mut places, mut from) = (Vec::new(), Vec::new(), 0);
    for (at, c) in text.char_indices() {
        depth += i32::from(c == '[') - i32::from(c == ']');
        let after = text[at + c.len_utf8()..].chars().next();
        if depth <= 0 && separates(c, before, after) {
            found.push(&text[from..at]);
            places.push(at);
            from = at + c.len_utf8();
        }
        before = Some(c);
    }
    found.push(&text[from..]);
    (found, places)
}

/// One number without an uncertainty.
fn one(text: &str) -> Result<String, Unclear> {
    let text = text.trim();
    let minus = text.strip_prefix(['\u{2212}', '\u{2013}', '-']).map(|rest| ("-", rest.trim_start()));
    let (sign, text) = minus.or_else(|| Some(("+", text.strip_prefix('+')?))).unwrap_or(("", text));
    let (text, percent) = match text.strip_suffix('%') {
        Some(rest) => (rest.trim_end(), true),
        None => (text, false),
    };
    let Some(plain) = unsigned(text)? else {
        // Not in these spellings: as it was typed.
        return Ok(format!("{sign}{text}{}", if percent { "%" } else { "" }));
    };
    let plain = if percent { hundredth(&plain) } else { plain };
    Ok(if sign == "-" { format!("-{plain}") } else { plain })
}

/// The hundredth of a number, as a decimal of as many digits where it is a decimal.
fn hundredth(plain: &str) -> String {
    let (whole, places) = plain.split_once('.').unwrap_or((plain, ""));
    if digits(whole) && places.bytes().all(|b| b.is_ascii_digit()) {
        let all = format!("{whole:0>3}");
        let (whole, last) = all.split_at(all.len() - 2);
        return format!("{whole}.{last}{places}");
    }
    rational::parse(plain).map_or_else(|_| plain.to_owned(), |value| (value / Rational::from(100)).to_string())
}

/// A number without sign and percent; `None` where it is none of these spellings.
fn unsigned(text: &str) -> Result<Option<String>, Unclear> {
    if text.contains(TIMES) && power(text).is_none_or(|(mantissa, _)| mantissa.contains(TIMES)) {
        return product(text);
    }
    if let Some((c, fraction)) = text.chars().last().and_then(|c| VULGAR.iter().find(|(v, _)| *v == c)) {
        let whole = text.trim_end_matches(*c).trim();
        return mixed(if whole.is_empty() { "0" } else { whole }, fraction);
    }
    if let Some((above, below)) = text.split_once(['/', '\u{2044}']) {
        let above = above.trim();
        // 5 1/2, but 1 000/3: a group of three digits belongs to the number before it.
        if let Some((whole, rest)) = above.rsplit_once(BLANKS)
            && rest.len() != 3
            && rest.bytes().all(|b| b.is_ascii_digit())
        {
            return mixed(whole, &format!("{rest}/{}", below.trim()));
        }
        let both = (natural(above), natural(below.trim()));
        return Ok(both.0.zip(both.1).map(|(above, below)| format!("{above}/{below}")));
    }
    let (mantissa, exponent) = match (text.find(['e', 'E']), power(text)) {
        (_, Some((mantissa, exponent))) => (mantissa, exponent),
        (Some(at), None) => (text[..at].trim(), text[at..].replace('\u{2212}', "-")),
        (None, None) => (text, String::new()),
    };
    let marks: Vec<char> = mantissa.chars().filter(|c| matches!(c, '.' | ',')).collect();
    let (whole, places) = match marks.as_slice() {
        [] => (mantissa, None),
        [mark] => match mantissa.split_once(*mark) {
            Some((whole, places)) => (whole, Some(places)),
            None => return Ok(None),
        },
        _ => return Ok(None),
    };
    if marks == [','] && exponent.is_empty() {
        let groups = places.is_some_and(|p| p.len() == 3) && (1..=3).contains(&whole.len()) && !whole.starts_with('0');
        if groups && digits(whole) && places.is_some_and(digits) {
            let places = places.unwrap_or_default();
            let message = format!("{text:?} has two readings: write {whole}{places} or {whole}.{places}");
            return Err(Unclear(message));
        }
    }
    // A point may begin a number, not be one.
    let bare = whole.is_empty() && places.is_some_and(|p| !p.is_empty());
    let whole = if bare { Some("0".to_owned()) } else { natural(whole) };
    let places = match places {
        None => Some(None),
        // A comma at the end separates, and is no decimal one.
        Some("") if marks == ['.'] && !mantissa.starts_with('.') => Some(None),
        Some(places) => grouped(places).map(Some),
    };
    Ok(whole.zip(places).map(|(whole, places)| match places {
        None => format!("{whole}{exponent}"),
        Some(places) => format!("{whole}.{places}{exponent}"),
    }))
}

/// The value of a product of numbers; `None` where a factor is none. Only the last factor may be written with a `/`: what
/// stands below the line of an earlier one is unclear.
fn product(text: &str) -> Result<Option<String>, Unclear> {
    let factors: Vec<&str> = text.split(TIMES).map(str::trim).collect();
    let Some((_, earlier)) = factors.split_last().filter(|_| factors.len() <= MAX_FACTORS) else { return Ok(None) };
    let mut value = Rational::ONE;
    for factor in &factors {
        let Some(plain) = unsigned(factor)? else { return Ok(None) };
        let Ok(number) = rational::parse(&plain) else { return Ok(None) };
        value *= number;
    }
    let divided = |factor: &&&str| factor.contains(['/', '\u{2044}']);
    if let Some(factor) = earlier.iter().find(divided) {
        let message = format!(
            "{text:?} has two readings: {factor} times what follows, or all of that below the line; write one number"
        );
        return Err(Unclear(message));
    }
    Ok(Some(value.to_string()))
}

/// Mantissa and exponent of `10^3`, `10³`, `2·10^3`, `2*10^-3` or `2×10^3`.
fn power(text: &str) -> Option<(&str, String)> {
    let plain = |c: char| RAISED.iter().find(|(raised, _)| *raised == c).map(|(_, plain)| *plain);
    let (before, exponent) = match text.split_once('^') {
        Some((before, exponent)) => (before, exponent.trim().replace('\u{2212}', "-")),
        None => {
            let before = text.trim_end_matches(|c| plain(c).is_some());
            (before, text[before.len()..].chars().filter_map(plain).collect())
        }
    };
    let exponent = exponent.strip_prefix('{').and_then(|inside| inside.strip_suffix('}')).unwrap_or(&exponent);
    let before = before.trim_end().strip_suffix("10")?.trim_end();
    let mantissa = match before.strip_suffix(TIMES) {
        Some(mantissa) => mantissa.trim_end(),
        None if before.is_empty() => "1",
        None => return None,
    };
    digits(exponent.trim_start_matches(['-', '+'])).then(|| (mantissa, format!("e{exponent}")))
}

fn digits(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit())
}

/// Digits, perhaps in groups of three from the right.
fn natural(text: &str) -> Option<String> {
    let mut groups = text.split(BLANKS);
    let first = groups.next()?;
    let rest: Vec<&str> = groups.collect();
    let fits = digits(first)
        && rest.iter().all(|group| group.len() == 3 && digits(group))
        && (rest.is_empty() || first.len() <= 3);
    fits.then(|| text.replace(BLANKS, ""))
}

/// Digits after the point, perhaps in equal groups of three or five from the left, as tables have them.
fn grouped(text: &str) -> Option<String> {
    let groups: Vec<&str> = text.split(BLANKS).collect();
    let (last, full) = groups.split_last()?;
    let size = full.first().map_or(5, |group| group.len());
    let fits = full.iter().all(|group| group.len() == size && digits(group)) && digits(last);
    let fits = fits && (full.is_empty() || matches!(size, 3 | 5) && last.len() <= size);
    fits.then(|| groups.concat())
}

/// A whole number and a fraction: their sum.
fn mixed(whole: &str, fraction: &str) -> Result<Option<String>, Unclear> {
    let sum = natural(whole).and_then(|whole| rational::parse(&whole).ok()).zip(rational::parse(fraction).ok());
    Ok(sum.map(|(whole, fraction)| (whole + fraction).to_string()))
}

#[cfg(test)]
mod tests {
    use super::{list, number};
    use crate::number::rational;
    use malachite::Rational;
    use malachite::base::num::basic::traits::{One, Zero};

    fn share(text: &str) -> bool {
        // A measured value is judged where it is used.
        text.contains(['[', '±']) || rational::parse(text).is_ok_and(|x| (Rational::ZERO..=Rational::ONE).contains(&x))
    }

    fn positive(text: &str) -> bool {
        rational::parse(text).is_ok_and(|x| x > 0)
    }

    #[test]
    fn numbers_as_classes_type_them() {
        for (typed, plain) in [
            (".9", "0.9"),
            ("+.9", "0.9"),
            ("0,9", "0.9"),
            (",9", "0.9"),
            ("5.", "5"),
            ("90 %", "0.90"),
            ("90%", "0.90"),
            ("12,5 %", "0.125"),
            ("1/2 %", "1/200"),
            ("250 %", "2.50"),
            ("10^3", "1e3"),
            ("2,5·10^−3", "2.5e-3"),
            ("2 * 10^{3}", "2e3"),
            ("10³", "1e3"),
            ("2,25 · 10⁻³", "2.25e-3"),
            ("2*5", "10"),
            ("2·5", "10"),
            ("-0,5 × 3", "-3/2"),
            ("2 * 3*10^2", "600"),
            ("2*50 %", "1.00"),
            ("2*5/4", "5/2"),
            ("2·½", "1"),
            ("1 000*2", "2000"),
            ("9\u{2044}16", "9/16"),
            ("1 000", "1000"),
            ("12\u{202f}345,5", "12345.5"),
            ("\u{2212}3", "-3"),
            ("\u{2013} 0,5", "-0.5"),
            ("½", "1/2"),
            ("5½", "11/2"),
            ("5 1/2", "11/2"),
            ("1 000/3", "1000/3"),
            ("2.5e-3", "2.5e-3"),
            ("2,5e\u{2212}3", "2.5e-3"),
            ("0.37313 75117 73739", "0.373137511773739"),
            ("57,1 ± 0,1", "57.1 ± 0.1"),
            ("57.1 +/- .1", "57.1 +- 0.1"),
            ("57,1(1)", "57.1(1)"),
            ("90 % ± 2 %", "0.90 ± 0.02"),
            ("57.1 ± 1 %", "57.1 ± 1 %"),
            ("57,1 ± 0,5%", "57.1 ± 0.5 %"),
            ("[.88, 0.92]", "[0.88, 0.92]"),
            ("[1,2]", "[1, 2]"),
            ("[0,88; 0,92]", "[0.88, 0.92]"),
            ("0,123", "0.123"),
        ] {
            assert_eq!(number(typed).as_deref(), Ok(plain), "{typed}");
        }
    }

    #[test]
    fn what_the_engine_reads_already_keeps_its_value() {
        for text in ["10", "3/4", "0.85", "-2.5e-1", "007", "1e40", "+3", "0.10"] {
            let plain = number(text).expect("one reading");
            assert_eq!(rational::parse(&plain), rational::parse(text), "{text}");
        }
        for text in ["0.85 ± 0.01", "[0.88, 0.92]", "0.9 +- 0.1", "(5.71 ± 0.01)e1", "57.1(1)", "5.71(1)e1"] {
            assert_eq!(number(text).as_deref(), Ok(text));
        }
    }

    #[test]
    fn two_readings_are_refused_with_both() {
        let refused = |found: Result<Vec<String>, super::Unclear>| found.expect_err("two readings").0;
        assert!(number("1,000").expect_err("two readings").0.contains("write 1000 or 1.000"));
        assert!(refused(list("0,1", share)).contains("write 0.1 if"), "0 and 1, or a tenth");
        assert!(refused(list("5,2", positive)).contains("5; 2"));
        assert!(number("1/2*3").expect_err("3/2 or 1/6").0.contains("write one number"));
        assert!(number("1,000*2").expect_err("2000 or 2").0.contains("write 1000 or 1.000"));
    }

    #[test]
    fn a_list_is_read_as_it_can_only_be_meant() {
        for (typed, fits, plain) in [
            ("0,9", share as fn(&str) -> bool, "0.9"),
            ("0.9,0.8", share, "0.9 0.8"),
            ("9/10,4/5, 7/10", share, "9/10 4/5 7/10"),
            ("0,9; 0,8", share, "0.9 0.8"),
            ("0,9, 0,8", share, "0.9 0.8"),
            ("90 %, 80 %", share, "0.90 0.80"),
            ("1, 0", share, "1 0"),
            ("1,1,0", share, "1 1 0"),
            ("[0.88, 0.92], 1", share, "[0.88, 0.92] 1"),
            ("0,9 ± 0,02", share, "0.9 ± 0.02"),
            ("1000,0.001", positive, "1000 0.001"),
            ("5, 5/2", positive, "5 5/2"),
        ] {
            assert_eq!(list(typed, fits).map(|l| l.join(" ")).as_deref(), Ok(plain), "{typed}");
        }
    }

    #[test]
    fn axes_of_tables_are_read_alike() {
        for (typed, plain) in [
            ("1,2,10,100", "1,2,10,100"),
            (".5, 90 %", "0.5,0.90"),
            ("0,5; 0,9", "0.5,0.9"),
            ("0.5:1:.1", "0.5:1:0.1"),
            ("0,5:1:0,1", "0.5:1:0.1"),
            ("1:1000:x10", "1:1000:x10"),
            ("0,5", "0.5"),
        ] {
            assert_eq!(
                super::grid(typed, |x| share(x) || plain.contains("10") && positive(x)).as_deref(),
                Ok(plain),
                "{typed}"
            );
        }
        assert!(super::grid("1,5", positive).is_err(), "1 and 5, or one and a half");
    }

    #[test]
    fn what_is_no_number_is_handed_on() {
        assert_eq!(number("1 ± 2 %%").as_deref(), Ok("1 ± 2 %%"));
        for text in [
            "ten", "1,", "", "1.2.3", "1 00", "12 34", "1/0", "√2", "10*", "*2", "2*-3", "2**3", "2*(3)", "2^3",
            "10^^2", "--3", "++3", "5 5", "1,2,3",
        ] {
            let plain = number(text).expect("no second reading");
            assert!(rational::parse(&plain).is_err(), "{text}: {plain}");
        }
    }
}
