//! Which claim cites which, drawn from left to right.

use super::Entry;
use super::markup::escape;
use std::collections::BTreeMap;

const WIDTH: usize = 190;
const HEIGHT: usize = 26;
const GAP: usize = 60;

/// The claims that cite or are cited, as SVG; empty if there are none. A claim stands to the right of all that
/// it cites.
pub fn svg(entries: &[Entry]) -> String {
    let index: BTreeMap<&str, usize> =
        entries.iter().enumerate().map(|(i, e)| (e.claim.name.text.as_str(), i)).collect();
    let mut edges: Vec<(usize, usize)> = Vec::new();
    for (i, entry) in entries.iter().enumerate() {
        edges.extend(entry.claim.using.iter().filter_map(|n| Some((*index.get(n.text.as_str())?, i))));
    }
    if edges.is_empty() {
        return String::new();
    }
    // The longest path to each; citations have no circles, so as many rounds as claims suffice.
    let mut column = vec![0usize; entries.len()];
    for _ in 0..entries.len() {
        let before = column.clone();
        for (from, to) in &edges {
            column[*to] = column[*to].max(column[*from] + 1);
        }
        if column == before {
            break;
        }
    }
    let mut place: BTreeMap<usize, (usize, usize)> = BTreeMap::new();
    let mut filled: BTreeMap<usize, usize> = BTreeMap::new();
    for i in (0..entries.len()).filter(|i| edges.iter().any(|e| e.0 == *i || e.1 == *i)) {
        let rows = filled.entry(column[i]).or_insert(0);
        place.insert(i, (column[i] * (WIDTH + GAP) + 4, *rows * (HEIGHT + 10) + 4));
        *rows += 1;
    }
    let columns = filled.keys().max().map_or(0, |c| c + 1);
    let rows = filled.values().max().copied().unwrap_or(0);
    let (width, height) = (columns * (WIDTH + GAP) - GAP + 8, rows * (HEIGHT + 10) + 8);
    let mut out = format!(
        "<svg viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{} claims and the {} citations between them; \
         each claim's section lists what it rests on\" xmlns=\"http://www.w3.org/2000/svg\" \
         font-family=\"system-ui,sans-serif\" font-size=\"13\">\n",
        place.len(),
        edges.len()
    );
    for (from, to) in &edges {
        let (Some((x, y)), Some((u, v))) = (place.get(from), place.get(to)) else { continue };
        let (x, y, u, v) = (x + WIDTH, y + HEIGHT / 2, *u, v + HEIGHT / 2);
        let middle = usize::midpoint(x, u);
        out.push_str(&format!(
            "<path d=\"M{x} {y}C{middle} {y} {middle} {v} {u} {v}\" fill=\"none\" stroke=\"#777\"/>\n"
        ));
    }
    for (i, (x, y)) in &place {
        let name = escape(&entries[*i].claim.name.text);
        out.push_str(&format!(
            "<a href=\"#{name}\"><rect x=\"{x}\" y=\"{y}\" width=\"{WIDTH}\" height=\"{HEIGHT}\" rx=\"4\" fill=\"#fff\" \
             stroke=\"#333\"/><text x=\"{}\" y=\"{}\" fill=\"#1b1b1b\">{name}</text></a>\n",
            x + 8,
            y + 18
        ));
    }
    out.push_str("</svg>\n");
    out
}
