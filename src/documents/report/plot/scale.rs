//! Scales and their ticks.
//!
//! Contract: a tick and its label are one number, an integer times a power of ten, so that a label is right to the last
//! digit. `Scale::choices` has the sets of ticks that a scale may carry, the best first, each with two labels at least;
//! which of them fits on the page is decided where text is measured.

use super::letters::plain;

/// Values of which none is farther from the others than this share of them are drawn as one.
const FLAT: f64 = 1e-12;
/// The scale from 0 to 1 is kept for values that spread over this much of it.
const SPREAD: f64 = 0.25;
/// The most labels of an axis.
const LABELS: usize = 9;

/// A scale.
#[derive(Clone, Debug)]
pub struct Scale {
    /// The values at its two ends.
    pub ends: (f64, f64),
    /// Whether it is logarithmic.
    pub logarithmic: bool,
    /// Whether only whole numbers have ticks.
    pub whole: bool,
    /// What it measures.
    pub label: String,
}

/// A labelled tick.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tick {
    /// Where it stands.
    pub value: f64,
    /// The same in words.
    pub label: String,
}

/// The ticks of a scale.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Ticks {
    /// Those with labels.
    pub main: Vec<Tick>,
    /// Fine ones without.
    pub fine: Vec<f64>,
}

/// `digits·10^exponent`, correctly rounded.
fn value(digits: i64, exponent: i32) -> f64 {
    format!("{digits}e{exponent}").parse().unwrap_or(f64::NAN)
}

/// The exponent of the first digit of `digits·10^exponent`.
fn leading(digits: i64, exponent: i32) -> i32 {
    exponent + digits.unsigned_abs().checked_ilog10().unwrap_or(0) as i32
}

/// `digits·10^exponent` written out, with a true minus sign.
fn written(digits: i64, exponent: i32) -> String {
    let (sign, text) = (if digits < 0 { "−" } else { "" }, digits.unsigned_abs().to_string());
    let places = exponent.unsigned_abs() as usize;
    if exponent >= 0 {
        return if digits == 0 { text } else { format!("{sign}{text}{}", "0".repeat(places)) };
    }
    let text = format!("{}{text}", "0".repeat((places + 1).saturating_sub(text.len())));
    let (whole, part) = text.split_at(text.len() - places);
    format!("{sign}{whole}.{part}")
}

/// Whether numbers with this leading exponent are written out.
fn is_plain(leading: i32) -> bool {
    (-4..6).contains(&leading)
}

/// The label of `digits·10^exponent`: written out, or as a multiple of `10^common`.
fn label(digits: i64, exponent: i32, common: i32) -> String {
    if digits == 0 {
        return "0".to_owned();
    }
    if is_plain(common) {
        return written(digits, exponent);
    }
    let power = format!("10^{{{}}}", written(i64::from(common), 0));
    match written(digits, exponent - common).as_str() {
        "1" => power,
        factor => format!("{factor}·{power}"),
    }
}

/// A power of ten, written out only for 1 and 10.
fn decade(k: i32) -> Tick {
    let label = match k {
        0 => "1".to_owned(),
        1 => "10".to_owned(),
        _ => format!("10^{{{}}}", written(i64::from(k), 0)),
    };
    Tick { value: value(1, k), label }
}

/// The number next to `x` downwards (upwards) with at most two digits more than the leading one of `span`.
fn outward(x: f64, span: f64, up: bool) -> f64 {
    let exponent = span.log10().floor() as i32 - 1;
    let units = x / value(1, exponent);
    value((if up { units.ceil() } else { units.floor() }) as i64, exponent)
}

/// What values come to on a scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Spread {
    /// They are one value, as far as a picture can show.
    Flat,
    /// They spread from the first to the second end.
    Over(f64, f64),
}

impl Spread {
    /// Of some values.
    pub(crate) fn of(values: impl Iterator<Item = f64>) -> Spread {
        let (lo, hi) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), v| (lo.min(v), hi.max(v)));
        if hi - lo > FLAT * hi.abs().max(lo.abs()) { Spread::Over(lo, hi) } else { Spread::Flat }
    }
}

/// The ends of a scale for curves of shares, which lie from 0 to 1: 0 and 1 where the curves read well on them, else what
/// the curves need. No curve lies on the frame.
pub(crate) fn shares(curves: &[Vec<(f64, f64)>]) -> (f64, f64) {
    let values = || curves.iter().flatten().map(|p| p.1);
    let (mut from, mut to) = match Spread::of(values()) {
        Spread::Over(lo, hi) if hi - lo < SPREAD => {
            let (span, margin) = (hi - lo, 0.06 * (hi - lo));
            let from = if lo < span { 0.0 } else { outward(lo - margin, span, false) };
            (from, outward(hi + margin, span, true))
        }
        Spread::Over(..) => (0.0, 1.0),
        Spread::Flat => {
            let flat = values().next().unwrap_or(0.0);
            if flat > 0.0 && flat < 0.1 { (0.0, outward(2.0 * flat, flat, true)) } else { (0.0, 1.0) }
        }
    };
    let span = to - from;
    let lies = |curve: &Vec<(f64, f64)>, at: f64| curve.iter().all(|p| (p.1 - at).abs() < 0.005 * span);
    if curves.iter().any(|curve| lies(curve, from)) {
        from = outward(from - 0.04 * span, span, false);
    }
    if curves.iter().any(|curve| lies(curve, to)) {
        to = outward(to + 0.04 * span, span, true);
    }
    (from, to)
}

/// The ends of a scale that begins at 0 or below and has some room above; `share` of the whole.
pub(crate) fn from_zero(values: impl Iterator<Item = f64> + Clone, share: f64) -> (f64, f64) {
    let (low, high) = (values.clone().fold(0.0, f64::min), values.fold(0.0, f64::max));
    let span = high - low;
    if span == 0.0 {
        return (0.0, 1.0);
    }
    let from = if low < 0.0 { outward(low - share * span, span, false) } else { 0.0 };
    (from, outward(high + share * span, span, true))
}

impl Scale {
    /// An even scale.
    #[must_use]
    pub fn even(from: f64, to: f64, label: &str) -> Scale {
        Scale { ends: (from, to), logarithmic: false, whole: false, label: label.to_owned() }
    }

    /// A logarithmic scale; its ends are above 0.
    #[must_use]
    pub fn logarithmic(from: f64, to: f64, label: &str) -> Scale {
        Scale { logarithmic: true, ..Scale::even(from, to, label) }
    }

    /// An even scale of whole numbers.
    #[must_use]
    pub fn whole(from: f64, to: f64, label: &str) -> Scale {
        Scale { whole: true, ..Scale::even(from, to, label) }
    }

    /// The scale in words.
    pub(super) fn words(&self) -> String {
        let kind = if self.logarithmic { ", logarithmic" } else { "" };
        let end = |v: f64| match v.abs() {
            0.0 | 1e-4..1e6 => v.to_string(),
            _ => format!("{v:e}"),
        };
        let (from, to) = (end(self.ends.0).replace('-', "−"), end(self.ends.1).replace('-', "−"));
        format!("{} from {from} to {to}{kind}", plain(&self.label))
    }

    /// The share of the way from one end to the other; no number where there is none.
    pub(super) fn share(&self, value: f64) -> f64 {
        let (from, to) = self.ends;
        if self.logarithmic { (value.ln() - from.ln()) / (to.ln() - from.ln()) } else { (value - from) / (to - from) }
    }

    /// The sets of ticks from which the page takes the first that fits.
    pub(super) fn choices(&self) -> Vec<Ticks> {
        let mut choices = if self.logarithmic { self.logarithmic_choices() } else { self.even_choices() };
        choices.retain(|ticks| ticks.main.len() >= 2);
        choices
    }

    /// Multiples of 1, 2 or 5 times a power of ten: some six of them, then fewer.
    fn even_choices(&self) -> Vec<Ticks> {
        let (from, to) = self.ends;
        let raw = (to - from) / 6.0;
        let power = raw.log10().floor() as i32;
        let steps = (power..power + 3).flat_map(|p| [1, 2, 5].map(|s| (s, p)));
        let steps = steps.filter(|(s, p)| value(*s, *p) >= raw * (1.0 - 1e-9));
        let mut steps: Vec<(i64, i32)> =
            steps.map(|(s, p)| if self.whole && p < 0 { (1, 0) } else { (s, p) }).collect();
        steps.dedup();
        steps.into_iter().take(5).map(|(s, p)| Ticks { main: self.multiples(s, p), fine: Vec::new() }).collect()
    }

    /// The multiples of `factor·10^exponent` on the scale.
    fn multiples(&self, factor: i64, exponent: i32) -> Vec<Tick> {
        let step = value(factor, exponent);
        let (first, last) = (self.ends.0 / step, self.ends.1 / step);
        let digits: Vec<i64> =
            ((first - 1e-9).ceil() as i64..=(last + 1e-9).floor() as i64).take(100).map(|k| k * factor).collect();
        let common = digits.iter().map(|d| leading(*d, exponent)).max().unwrap_or(0);
        digits.iter().map(|d| Tick { value: value(*d, exponent), label: label(*d, exponent, common) }).collect()
    }

    /// Powers of ten where there are three; else 1, 2 and 5 times them; else an even scale's ticks.
    fn logarithmic_choices(&self) -> Vec<Ticks> {
        let (from, to) = self.ends;
        let (low, high) = ((from.log10() - 1e-9).ceil() as i32, (to.log10() + 1e-9).floor() as i32);
        let inside = |v: f64| (-1e-9..=1.0 + 1e-9).contains(&self.share(v));
        let fine: Vec<f64> = (low - 1..=high).flat_map(|k| (1..10).map(move |d| value(d, k))).collect();
        let fine: Vec<f64> = fine.into_iter().filter(|v| inside(*v)).collect();
        let mut decades: Vec<Ticks> = [1, 2, 5, 10, 20, 50, 100, 200]
            .into_iter()
            .map(|step| Ticks {
                main: (low..=high).filter(|k| k.rem_euclid(step) == 0).map(decade).collect(),
                fine: if step == 1 { fine.clone() } else { Vec::new() },
            })
            .filter(|ticks| ticks.main.len() <= LABELS)
            .collect();
        let mut parts = Vec::new();
        for (k, factor) in (low - 1..=high).flat_map(|k| [1, 2, 5].map(|d| (k, d))) {
            if inside(value(factor, k)) && parts.len() <= LABELS {
                parts.push(Tick { value: value(factor, k), label: label(factor, k, k) });
            }
        }
        let few = decades.first().is_none_or(|ticks| ticks.main.len() < 3);
        let mut choices = Vec::new();
        if few {
            let parts = Ticks { main: parts, fine };
            let scarce = parts.main.len() < 3;
            let even = self.even_choices();
            if scarce {
                choices.extend(even);
                choices.push(parts);
            } else {
                choices.push(parts);
                choices.extend(even);
            }
        }
        choices.append(&mut decades);
        choices
    }
}
