//! Which claim rests on which, drawn as SVG.

use crate::refute::outcome::Verdict;
use crate::report::Entry;
use crate::report::markup::escape;
use std::collections::BTreeMap;

/// Pixels of a letter in the mean; the font is the reader's.
const LETTER: usize = 7;
const HEIGHT: usize = 26;
const STEP: usize = 36;
const GAP: usize = 44;
/// The most letters of a name that are shown.
const LETTERS: usize = 24;

/// The claims that cite or are cited, as a figure; empty if there are none. A claim stands to the right of all that
/// it cites, and about as high as these.
pub(super) fn svg(entries: &[Entry]) -> String {
    let index: BTreeMap<&str, usize> =
        entries.iter().enumerate().map(|(i, e)| (e.claim.name.text.as_str(), i)).collect();
    let mut edges: Vec<(usize, usize)> = Vec::new();
    for (i, entry) in entries.iter().enumerate() {
        edges.extend(entry.claim.using.iter().filter_map(|n| Some((*index.get(n.text.as_str())?, i))));
    }
    if edges.is_empty() {
        return String::new();
    }
    let columns = columns(entries.len(), &edges);
    let shown = |i: usize| -> String {
        let name = &entries[i].claim.name.text;
        let mark = if entries[i].outcome.verdict == Verdict::Proved { "" } else { " ✗" };
        match name.char_indices().nth(LETTERS) {
            Some((end, _)) => format!("{}…{mark}", &name[..end]),
            None => format!("{name}{mark}"),
        }
    };
    let longest = columns.iter().flatten().map(|i| shown(*i).chars().count()).max().unwrap_or(0);
    let wide = longest * LETTER + 16;
    let rows = columns.iter().map(Vec::len).max().unwrap_or(0);
    let (width, height) = (columns.len() * (wide + GAP) - GAP + 8, rows * STEP + 8);
    let mut place: BTreeMap<usize, (usize, usize)> = BTreeMap::new();
    for (x, column) in columns.iter().enumerate() {
        for (y, i) in column.iter().enumerate() {
            place.insert(*i, (x * (wide + GAP) + 4, y * STEP + 4));
        }
    }
    let mut out = format!(
        "<figure class=\"wide graph\" role=\"region\" aria-label=\"Which claim rests on which\" tabindex=\"0\">\n\
         <svg width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" role=\"group\" \
         aria-label=\"{} claims and the {} citations between them; each claim's section lists what it rests on\" \
         xmlns=\"http://www.w3.org/2000/svg\" font-family=\"system-ui,sans-serif\" font-size=\"13\">\n",
        place.len(),
        edges.len()
    );
    for (from, to) in &edges {
        let (Some((x, y)), Some((u, v))) = (place.get(from), place.get(to)) else { continue };
        let (x, y, u, v) = (x + wide, y + HEIGHT / 2, *u, v + HEIGHT / 2);
        let middle = usize::midpoint(x, u);
        out.push_str(&format!(
            "<path d=\"M{x} {y}C{middle} {y} {middle} {v} {u} {v}\" fill=\"none\" stroke=\"#777\"/>\n"
        ));
    }
    for (i, (x, y)) in &place {
        let (name, title) = (escape(&entries[*i].claim.name.text), escape(&entries[*i].claim.title));
        let verdict = entries[*i].outcome.verdict;
        let stroke = match verdict {
            Verdict::Proved => "#14532d",
            Verdict::Refuted => "#8a1c1c",
            Verdict::Undecided => "#6b4a00",
        };
        out.push_str(&format!(
            "<a href=\"#{name}\"><title>{name}, {}: {title}</title><rect x=\"{x}\" y=\"{y}\" width=\"{wide}\" \
             height=\"{HEIGHT}\" rx=\"4\" fill=\"#fff\" stroke=\"{stroke}\"/><text x=\"{}\" y=\"{}\" \
             fill=\"#1b1b1b\">{}</text></a>\n",
            verdict.name(),
            x + 8,
            y + 18,
            escape(&shown(*i))
        ));
    }
    out.push_str("</svg>\n<figcaption>A line leads from a claim to those, further right, that cite it.");
    out.push_str(" ✗ marks a claim that is not proved.</figcaption>\n</figure>\n");
    out
}

/// The claims that have a citation, in columns: each to the right of all that it cites, in the order of the middle
/// heights of these.
fn columns(claims: usize, edges: &[(usize, usize)]) -> Vec<Vec<usize>> {
    // The longest path to each; citations have no circles, so as many rounds as claims suffice.
    let mut depth = vec![0usize; claims];
    for _ in 0..claims {
        let before = depth.clone();
        for (from, to) in edges {
            depth[*to] = depth[*to].max(depth[*from] + 1);
        }
        if depth == before {
            break;
        }
    }
    let mut out: Vec<Vec<usize>> = vec![Vec::new(); depth.iter().max().map_or(0, |d| d + 1)];
    for i in (0..claims).filter(|i| edges.iter().any(|e| e.0 == *i || e.1 == *i)) {
        out[depth[i]].push(i);
    }
    let mut height: BTreeMap<usize, usize> = BTreeMap::new();
    for column in &mut out {
        column.sort_by_cached_key(|i| {
            let cited: Vec<usize> =
                edges.iter().filter(|e| e.1 == *i).filter_map(|e| height.get(&e.0).copied()).collect();
            // In thousandths, so that the order is that of whole numbers.
            (cited.iter().sum::<usize>() * 1000).checked_div(cited.len()).unwrap_or(0)
        });
        height.extend(column.iter().enumerate().map(|(y, i)| (*i, y)));
    }
    out
}
