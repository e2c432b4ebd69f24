//! Cross tables: one axis runs down, another one across, as textbooks print them.
//!
//! Contract: each value of the plan stands in one cell, rounded as the plan says, at the row and under the heading of its
//! place; a cell is the fraction itself where that is asked for and short. A table that would be wider than its [`Room`] is cut
//! into several, each with its own first column; a third axis makes a table for each of its values.

use super::{Column, Entry, Head};
use crate::table::{Plan, Row};
use std::collections::BTreeMap;

/// The room across, and what a column takes of it.
#[derive(Clone, Copy, Debug)]
pub struct Room {
    /// All of it.
    pub most: usize,
    /// For each character of the widest entry.
    pub character: usize,
    /// Between columns.
    pub gap: usize,
}

/// Text and Markdown, in characters: a page of letters holds them.
pub const PAGE: Room = Room { most: 84, character: 1, gap: 2 };
/// LaTeX, in tenths of a point: the width of the class article in ten points, its digits, and its space between columns
/// with what siunitx puts between groups of digits.
pub const LATEX: Room = Room { most: 3450, character: 53, gap: 165 };

/// The longest fraction in a cell, in characters.
const FRACTION: usize = 11;

/// The cross tables of a plan from its rows; `across` is the place of an axis among [`Plan::axis_names`]. Without `room` columns
/// are never cut, and a third axis is a column of its own.
#[must_use]
pub fn tables(
    plan: &Plan,
    rows: &[Row],
    across: usize,
    fractions: bool,
    room: Option<Room>,
) -> Vec<(Head, Vec<Vec<Entry>>)> {
    let names = plan.axis_names();
    let down: Vec<usize> = (0..names.len()).filter(|axis| *axis != across).collect();
    // The last of the other axes runs down; what is before it tells tables apart.
    let (apart, down) = if room.is_none() {
        (Vec::new(), down)
    } else {
        (down[..down.len().saturating_sub(1)].to_vec(), down[down.len().saturating_sub(1)..].to_vec())
    };
    let pick =
        |row: &Row, axes: &[usize]| axes.iter().filter_map(|axis| row.labels.get(*axis).cloned()).collect::<Vec<_>>();
    let heads = in_order(rows.iter().filter_map(|row| row.labels.get(across).cloned()));
    let tables = in_order(rows.iter().map(|row| pick(row, &apart)));
    let lines = in_order(rows.iter().map(|row| pick(row, &down)));
    let cells: BTreeMap<_, _> =
        rows.iter().map(|row| ((pick(row, &apart), pick(row, &down), row.labels.get(across).cloned()), row)).collect();
    let cell = |row: &Row| {
        let fraction = row.exact.as_ref().filter(|text| fractions && text.len() <= FRACTION);
        fraction.unwrap_or(&row.value).clone()
    };
    let mut out = Vec::new();
    for table in tables {
        let body: Vec<Vec<String>> = lines
            .iter()
            .map(|line| {
                let at = |head: &String| cells.get(&(table.clone(), line.clone(), Some(head.clone())));
                heads.iter().map(|head| at(head).map_or(String::new(), |row| cell(row))).collect()
            })
            .collect();
        let name = names.get(across).copied().unwrap_or_default();
        let title = |head: &String| format!("{name} = {head}");
        let width = |place: usize| {
            let cells = body.iter().filter_map(|line| line.get(place)).map(|cell| cell.chars().count());
            cells.max().unwrap_or(0).max(heads.get(place).map_or(0, |head| title(head).chars().count()))
        };
        let widths: Vec<usize> = (0..heads.len()).map(width).collect();
        let fixed: Vec<String> =
            apart.iter().zip(&table).map(|(axis, label)| format!("{} = {label}", names[*axis])).collect();
        let first = axis_column(down.last().map_or("", |axis| names[*axis]), &fixed).name.chars().count();
        for part in parts(first, &widths, room) {
            let mut head = Head::of(plan);
            head.facts.retain(|fact| fact.0 != "exact" || fractions);
            head.columns = down.iter().map(|axis| axis_column(names[*axis], &fixed)).collect();
            head.columns.extend(part.clone().map(|place| Column {
                name: title(&heads[place]),
                latex: format!("${} = {}$", latex(name), heads[place]),
                numeric: true,
            }));
            let rows = lines.iter().zip(&body).map(|(line, cells)| {
                line.iter().chain(&cells[part.clone()]).map(|text| Entry::Plain(text.clone())).collect()
            });
            out.push((head, rows.collect()));
        }
    }
    out
}

/// The column of the axis that runs down; its heading also has what is the same in the whole table.
fn axis_column(name: &str, fixed: &[String]) -> Column {
    let plain = fixed.iter().map(|text| format!("{text}; ")).collect::<String>() + name;
    let set = fixed.iter().filter_map(|text| text.split_once(" = "));
    let set = set.map(|(axis, value)| format!("${} = {value}$, ", latex(axis))).collect::<String>();
    Column { name: plain, latex: format!("{set}${}$", latex(name)), numeric: true }
}

fn latex(axis: &str) -> &str {
    if axis == "ratio" { "m_1/m_2" } else { axis }
}

/// Columns side by side, as many as fit beside the first one, and one at least.
fn parts(first: usize, widths: &[usize], room: Option<Room>) -> Vec<std::ops::Range<usize>> {
    let Some(Room { most, character, gap }) = room else { return std::iter::once(0..widths.len()).collect() };
    let (mut out, mut from, mut used) = (Vec::new(), 0, first * character);
    for (place, width) in widths.iter().enumerate() {
        let column = width * character + gap;
        if place > from && used + column > most {
            out.push(from..place);
            (from, used) = (place, first * character);
        }
        used += column;
    }
    out.push(from..widths.len());
    out
}

/// Each once, in the order of their first appearance.
fn in_order<T: PartialEq + Ord + Clone>(list: impl Iterator<Item = T>) -> Vec<T> {
    let mut seen = std::collections::BTreeSet::new();
    list.filter(|item| seen.insert(item.clone())).collect()
}
