//! Sheets laid out on pages of A4 or letter paper, from the shapes and letters of pictures.
//!
//! Contract: every shape lies within the margins; each sheet begins on a page of its own; a table or a question is not cut.
//! A number that is wider than its column is set smaller.
//!
//! A sheet is one page where it fits: the tables of its collisions become one table, the questions stand in two columns, and the
//! letters get smaller as far as needed, down to 7.5 points. What is to be filled in is then as high as the page allows, from 5.3 to 11 millimetres.
//! Up to four collisions fit so. A longer sheet has several pages, whose cells are seven millimetres high.

use super::sketch::Stroke;
use super::{Cell, Part, STANDARD, Sheet, Table, with_powers};
use crate::report::plot::letters::Letters;
use crate::report::plot::shape::{Anchor, BLACK, Colour, Page, Shape};
use std::cell::RefCell;
use std::collections::BTreeMap;

/// The margin, in points.
const MARGIN: f32 = 38.0;
/// Room for the foot above the lower margin.
const FOOT: f32 = 14.0;
/// Sizes of letters.
const TITLE: f32 = 14.0;
const HEADING: f32 = 11.5;
const BODY: f32 = 9.5;
const SMALL: f32 = 7.5;
/// From one line to the next, for each point of the letters.
const LEADING: f32 = 1.35;
/// The height of a cell with a number, and of one for a pen.
const PRINTED: f32 = 15.0;
const PEN: f32 = 19.9;
/// What is tried for the height of a pen on a single page: first a good one with letters of all sizes, then the least.
const PENS: [f32; 3] = [22.0, 18.0, 15.0];
/// The highest cell for a pen.
const HIGH: f32 = 31.0;
/// Sizes of letters on a single page, in those of a longer sheet.
const SCALES: [f32; 5] = [1.0, 0.95, 0.9, 0.842, 0.79];
/// The widest column of numbers, and the least width of the names of rows.
const COLUMN: f32 = 96.0;
const NAMES: f32 = 160.0;
/// Between a number and the edge of its column.
const PAD: f32 = 6.0;
/// Between two columns of the page.
const GUTTER: f32 = 18.0;
/// The least room for a pen behind a question, as a share of the line.
const BEHIND: f32 = 0.3;
const GREY: Colour = Colour(0x88, 0x88, 0x88);

/// The pages of all sheets.
#[must_use]
pub fn pages(sheets: &[Sheet], letter: bool) -> Vec<Page> {
    let (width, height) = if letter { (612.0, 792.0) } else { (595.0, 842.0) };
    let letters = Letters::new();
    let known = Lines::default();
    let flow = |sheet, scale, pen| Flow {
        letters: &letters,
        known: &known,
        sheet,
        width,
        height,
        scale,
        pen,
        left: MARGIN,
        room: width - 2.0 * MARGIN,
        y: MARGIN,
        pages: Vec::new(),
        shapes: Vec::new(),
    };
    let one = |sheet, scale, pen| {
        let mut flow = flow(sheet, scale, pen);
        flow.single();
        (flow.pages.len() == 1).then_some(flow.pages)
    };
    let mut out = Vec::new();
    for sheet in sheets {
        let tries = PENS.into_iter().flat_map(|pen| SCALES.map(|scale| (scale, pen)));
        let found = tries.into_iter().find_map(|(scale, pen)| Some((scale, pen, one(sheet, scale, pen)?)));
        let found = found.map(|(scale, pen, pages)| {
            // The highest cells that still fit: halving, for higher cells never take less room.
            let (mut best, mut low, mut high) = (pages, pen, HIGH + 1.0);
            while high - low > 1.0 {
                let middle = ((low + high) / 2.0).floor();
                match one(sheet, scale, middle) {
                    Some(pages) => (best, low) = (pages, middle),
                    None => high = middle,
                }
            }
            best
        });
        out.extend(found.unwrap_or_else(|| {
            let mut flow = flow(sheet, 1.0, PEN);
            flow.all();
            flow.pages
        }));
    }
    out
}

/// The lines of texts, by size and room: a page that is tried with other cells has the same ones.
type Lines = RefCell<BTreeMap<(String, u32, u32), Vec<String>>>;

/// A sheet on its way onto pages.
struct Flow<'a> {
    letters: &'a Letters,
    known: &'a Lines,
    sheet: &'a Sheet,
    width: f32,
    height: f32,
    /// The size of letters and of what is printed, in that of a long sheet.
    scale: f32,
    /// The height of a cell or line to be filled in.
    pen: f32,
    /// The left end and the width of the column that is filled.
    left: f32,
    room: f32,
    y: f32,
    pages: Vec<Page>,
    shapes: Vec<Shape>,
}

/// The parts from one heading to the next.
fn sections(parts: &[Part]) -> Vec<&[Part]> {
    let heads = parts.iter().enumerate().filter(|(_, part)| matches!(part, Part::Heading(_))).map(|(place, _)| place);
    let mut from = 0;
    let ends: Vec<usize> = heads.chain([parts.len()]).collect();
    ends.into_iter().map(|end| &parts[std::mem::replace(&mut from, end)..end]).filter(|list| !list.is_empty()).collect()
}

impl Flow<'_> {
    fn body(&self) -> f32 {
        BODY * self.scale
    }

    fn all(&mut self) {
        self.title();
        let parts = &self.sheet.parts;
        for (place, part) in parts.iter().enumerate() {
            // A heading stays with what follows it.
            let mut needed = self.height_of(part);
            if let (Part::Heading(_), Some(next)) = (part, parts.get(place + 1)) {
                needed += self.height_of(next);
            }
            self.make_room(needed);
            self.part(part);
        }
        self.turn();
    }

    fn title(&mut self) {
        self.paragraph(&self.sheet.title.clone(), TITLE * self.scale, 0.0);
        self.y += 4.0 * self.scale;
    }

    /// The sheet for a single page: what happens beside the predictions, one table, the last questions in two columns.
    fn single(&mut self) {
        self.title();
        let all = sections(&self.sheet.parts);
        let (mut at, mut first) = (0, Vec::new());
        if let Some(setting) = all.first().filter(|list| !matches!(list.first(), Some(Part::Heading(_)))) {
            at = 1;
            let drawn = setting.iter().any(|part| matches!(part, Part::Sketch(_)));
            for part in *setting {
                match part {
                    Part::Names => self.placed(part),
                    // It is long, and the columns are narrow.
                    Part::Text(text) if text.starts_with(STANDARD) => self.placed(part),
                    // The sketch says the same.
                    Part::Table(_) if drawn => {}
                    part => first.push(part),
                }
            }
        }
        if let Some(guesses) = all.get(at).filter(|list| list.iter().any(|part| matches!(part, Part::Choice { .. }))) {
            at += 1;
            let guesses: Vec<&Part> = guesses.iter().collect();
            // A stack is high and narrow.
            let is_stack = |part: &&Part| matches!(part, Part::Sketch(sketch) if sketch.is_upright());
            let (stacks, others): (Vec<&Part>, Vec<&Part>) = first.iter().copied().partition(is_stack);
            if stacks.is_empty() {
                self.columns(&[(&first, 0.5), (&guesses, 0.5)]);
            } else {
                self.columns(&[(&others, 0.27), (&stacks, 0.27), (&guesses, 0.46)]);
            }
        } else {
            first.into_iter().for_each(|part| self.placed(part));
        }
        for list in all.get(at..).unwrap_or_default() {
            let tables: Vec<&Table> = list.iter().filter_map(titled).collect();
            let asks: Vec<&Part> = list.iter().filter(|part| matches!(part, Part::Open { .. })).collect();
            let is_other = |part: &&Part| titled(part).is_none() && !matches!(part, Part::Open { .. });
            let (heads, rest): (Vec<&Part>, Vec<&Part>) =
                list.iter().filter(is_other).partition(|part| matches!(part, Part::Heading(_)) || asks.is_empty());
            heads.into_iter().for_each(|part| self.placed(part));
            if !tables.is_empty() {
                self.joined(&tables);
            }
            if !asks.is_empty() {
                let (left, right) = asks.split_at(self.half(&asks));
                self.columns(&[(left, 0.5), (right, 0.5)]);
            }
            rest.into_iter().for_each(|part| self.placed(part));
        }
        self.turn();
    }

    /// A part at its place, on the next page where it does not fit.
    fn placed(&mut self, part: &Part) {
        self.make_room(self.height_of(part));
        self.part(part);
    }

    /// Columns side by side, each with its share of the width.
    fn columns(&mut self, columns: &[(&[&Part], f32)]) {
        let (top, from, whole) = (self.y, self.left, self.room);
        let free = whole - GUTTER * columns.len().saturating_sub(1) as f32;
        let mut lowest = top;
        for (parts, share) in columns {
            (self.y, self.room) = (top, free * share);
            parts.iter().for_each(|part| self.placed(part));
            self.left += self.room + GUTTER;
            lowest = lowest.max(self.y);
        }
        (self.y, self.left, self.room) = (lowest, from, whole);
    }

    /// So many of these parts belong into the left column, that the higher one is as low as possible.
    fn half(&mut self, parts: &[&Part]) -> usize {
        let whole = self.room;
        self.room = (whole - GUTTER) / 2.0;
        let heights: Vec<f32> = parts.iter().map(|part| self.height_of(part)).collect();
        self.room = whole;
        let higher = |split: usize| heights[..split].iter().sum::<f32>().max(heights[split..].iter().sum());
        (0..=parts.len()).min_by(|a, b| higher(*a).total_cmp(&higher(*b))).unwrap_or(0)
    }

    /// Begins a page where this does not fit on the one that is begun.
    fn make_room(&mut self, needed: f32) {
        if self.y > MARGIN && self.y + needed > self.height - MARGIN - FOOT {
            self.turn();
        }
    }

    /// Ends the page.
    fn turn(&mut self) {
        let (left, bottom, number) = (MARGIN, self.height - MARGIN, self.pages.len() + 1);
        let right = format!("page {number}");
        let free = self.width - 2.0 * MARGIN - self.letters.width(&right, SMALL) - 12.0;
        let foot = self.sheet.foot.clone();
        let size = self.fitted(&foot, SMALL, free);
        self.text((left, bottom), &foot, size, Anchor::Start);
        self.text((self.width - MARGIN, bottom), &right, SMALL, Anchor::End);
        self.pages.push(Page {
            width: self.width,
            height: self.height,
            title: self.sheet.title.clone(),
            description: String::new(),
            shapes: std::mem::take(&mut self.shapes),
        });
        self.y = MARGIN;
    }

    fn text(&mut self, at: (f32, f32), text: &str, size: f32, anchor: Anchor) {
        self.shapes.push(Shape::Text { at, text: text.to_owned(), size, anchor, upwards: false });
    }

    fn line(&mut self, from: (f32, f32), to: (f32, f32), colour: Colour, width: f32) {
        self.shapes.push(Shape::Line { points: vec![from, to], colour, width, dash: &[] });
    }

    /// The size at which a text is at most so wide.
    fn fitted(&self, text: &str, size: f32, room: f32) -> f32 {
        let width = self.letters.width(text, size);
        if width <= room { size } else { size * room / width }
    }

    fn lines(&self, text: &str, size: f32, indent: f32) -> Vec<String> {
        let room = self.room - indent;
        let key = (text.to_owned(), size.to_bits(), room.to_bits());
        let mut known = self.known.borrow_mut();
        known.entry(key).or_insert_with(|| self.letters.lines(&with_powers(text, raised), size, room)).clone()
    }

    fn paragraph(&mut self, text: &str, size: f32, indent: f32) {
        for line in self.lines(text, size, indent) {
            // A paragraph longer than a page continues on the next page.
            self.make_room(size * LEADING);
            self.y += size * LEADING;
            self.text((self.left + indent, self.y - 0.3 * size), &line, size, Anchor::Start);
        }
    }

    fn height_of(&self, part: &Part) -> f32 {
        let (body, scale) = (self.body(), self.scale);
        let text = |text: &str, indent: f32| self.lines(text, body, indent).len() as f32 * body * LEADING;
        match part {
            Part::Names => self.pen.min(PEN) + 14.0 * scale,
            Part::Heading(_) => (HEADING * LEADING + 9.0) * scale,
            Part::Text(content) => text(content, 0.0) + 4.0 * scale,
            Part::Sketch(sketch) => sketch.height() + 12.0,
            Part::Choice { ask, options, .. } => {
                let rows = self.rows(ask, options).len() as f32;
                let beside = self.beside(ask, options).is_some();
                let rows = if beside { rows - 1.0 } else { rows };
                text(ask, 0.0) + rows * body * 1.6 + 6.0 * scale
            }
            Part::Open { ask, answer, lines, .. } => {
                let below = match answer {
                    Some(answer) => text(ask, 0.0) + text(answer, 18.0),
                    None if self.behind(ask).is_some() => *lines as f32 * self.pen,
                    None => text(ask, 0.0) + *lines as f32 * self.pen,
                };
                below + 6.0 * scale
            }
            Part::Table(table) => {
                let title = if table.title.is_empty() { 0.0 } else { body * LEADING + 4.0 };
                let rows: f32 = table.groups.iter().flatten().map(|row| self.row_height(&row.cells)).sum();
                title + PRINTED * scale + rows + 14.0
            }
        }
    }

    /// The height of a row.
    fn row_height(&self, cells: &[Cell]) -> f32 {
        let blank = cells.iter().any(|cell| matches!(cell, Cell::Blank(_)));
        if blank { self.pen } else { PRINTED * self.scale }
    }

    /// Where a line for a pen begins behind a question, if there is room.
    fn behind(&self, ask: &str) -> Option<f32> {
        let [only] = self.lines(ask, self.body(), 0.0).try_into().ok().map(|line: [String; 1]| line)?;
        let end = self.letters.width(&only, self.body()) + 6.0;
        (self.room - end >= BEHIND * self.room).then_some(end)
    }

    /// Where boxes to tick begin behind a question, if all of them have room there.
    fn beside(&self, ask: &str, options: &[(String, bool)]) -> Option<f32> {
        let lines = self.lines(ask, self.body(), 0.0);
        let end = self.letters.width(lines.last()?, self.body()) + 14.0;
        let width: f32 = options.iter().map(|option| self.option_width(&option.0)).sum();
        (end + width <= self.room).then_some(end)
    }

    /// Boxes to tick in rows that are not too wide.
    fn rows<'o>(&self, ask: &str, options: &'o [(String, bool)]) -> Vec<Vec<&'o (String, bool)>> {
        if self.beside(ask, options).is_some() {
            return vec![options.iter().collect()];
        }
        let mut rows: Vec<Vec<&(String, bool)>> = vec![Vec::new()];
        let mut x = 18.0;
        for option in options {
            let width = self.option_width(&option.0);
            if x + width > self.room && x > 18.0 {
                rows.push(Vec::new());
                x = 18.0;
            }
            x += width;
            if let Some(row) = rows.last_mut() {
                row.push(option);
            }
        }
        rows
    }

    fn option_width(&self, text: &str) -> f32 {
        self.letters.width(text, self.body()) + 3.0 * self.body()
    }

    fn part(&mut self, part: &Part) {
        let (body, scale) = (self.body(), self.scale);
        match part {
            Part::Names => {
                self.y += self.pen.min(PEN) + 2.0;
                let fields = [("Name", 0.0, 0.50), ("Class", 0.52, 0.70), ("Date", 0.72, 1.0)];
                for (name, from, to) in fields {
                    let (x, end) = (self.left + from * self.room, self.left + to * self.room);
                    self.text((x, self.y), name, body, Anchor::Start);
                    let begin = x + self.letters.width(name, body) + 5.0;
                    self.line((begin, self.y + 1.0), (end, self.y + 1.0), GREY, 0.7);
                }
                self.y += 12.0 * scale;
            }
            Part::Heading(text) => {
                self.y += 6.0 * scale;
                self.paragraph(text, HEADING * scale, 0.0);
                self.y += 3.0 * scale;
            }
            Part::Text(text) => {
                self.paragraph(text, body, 0.0);
                self.y += 4.0 * scale;
            }
            Part::Sketch(sketch) => {
                self.y += 4.0;
                for stroke in sketch.strokes(self.room) {
                    match stroke {
                        Stroke::Line(points) => {
                            let points = points.iter().map(|(x, y)| (self.left + x, self.y + y)).collect();
                            self.shapes.push(Shape::Line { points, colour: BLACK, width: 0.8, dash: &[] });
                        }
                        Stroke::Label((x, y), text, size) => {
                            let at = (self.left + x, self.y + y + 0.36 * size);
                            self.text(at, &with_powers(&text, raised), size, Anchor::Middle);
                        }
                    }
                }
                self.y += sketch.height() + 8.0;
            }
            Part::Choice { ask, options, .. } => {
                self.paragraph(ask, body, 0.0);
                let beside = self.beside(ask, options);
                for row in self.rows(ask, options) {
                    self.y += if beside.is_some() { 0.0 } else { body * 1.6 };
                    let base = if beside.is_some() { self.y - 0.3 * body } else { self.y };
                    let mut x = self.left + beside.unwrap_or(18.0);
                    for (text, right) in row {
                        self.tick((x, base - 0.84 * body), *right);
                        self.text((x + 1.3 * body, base), text, body, Anchor::Start);
                        x += self.option_width(text);
                    }
                }
                self.y += 6.0 * scale;
            }
            Part::Open { ask, answer, lines, .. } => {
                let behind = self.behind(ask).filter(|_| answer.is_none());
                if let Some(from) = behind {
                    self.y += self.pen - body * LEADING;
                    self.paragraph(ask, body, 0.0);
                    self.line((self.left + from, self.y), (self.left + self.room, self.y), GREY, 0.7);
                } else {
                    self.paragraph(ask, body, 0.0);
                }
                match answer {
                    Some(answer) => self.paragraph(answer, body, 18.0),
                    None => {
                        for _ in usize::from(behind.is_some())..*lines {
                            self.y += self.pen;
                            self.line((self.left, self.y), (self.left + self.room, self.y), GREY, 0.7);
                        }
                    }
                }
                self.y += 6.0 * scale;
            }
            Part::Table(table) => self.table(table),
        }
    }

    /// A box, ticked or not.
    fn tick(&mut self, (x, y): (f32, f32), ticked: bool) {
        let s = 0.9 * self.body();
        let points = vec![(x, y), (x + s, y), (x + s, y + s), (x, y + s), (x, y)];
        self.shapes.push(Shape::Line { points, colour: BLACK, width: 0.8, dash: &[] });
        if ticked {
            self.line((x + 1.5, y + 1.5), (x + s - 1.5, y + s - 1.5), BLACK, 1.4);
            self.line((x + s - 1.5, y + 1.5), (x + 1.5, y + s - 1.5), BLACK, 1.4);
        }
    }

    fn table(&mut self, table: &Table) {
        let body = self.body();
        if !table.title.is_empty() {
            let size = self.fitted(&table.title, body, self.room);
            self.y += body * LEADING;
            self.text((self.left, self.y - 3.0), &table.title, size, Anchor::Start);
            self.y += 4.0;
        }
        let columns = table.columns.len().max(1) as f32;
        let column = COLUMN.min((self.room - NAMES.min(self.room / 3.0)) / columns);
        let names = self.room - column * columns;
        let right = self.left + self.room;
        let edge = |place: usize| self.left + names + column * (place as f32 + 1.0);
        let edges: Vec<f32> = (0..table.columns.len()).map(edge).collect();
        self.line((self.left, self.y), (right, self.y), BLACK, 1.0);
        self.y += PRINTED * self.scale;
        for (head, edge) in table.columns.iter().zip(&edges) {
            let size = self.fitted(head, body, column - 2.0 * PAD);
            self.text((edge - PAD, self.y - 4.0), head, size, Anchor::End);
        }
        for group in &table.groups {
            self.line((self.left, self.y), (right, self.y), BLACK, 0.6);
            for row in group {
                let top = self.y;
                self.y += self.row_height(&row.cells);
                let size = self.fitted(&row.name, body, names - PAD);
                self.text((self.left, self.y - 4.5), &row.name, size, Anchor::Start);
                for (cell, edge) in row.cells.iter().zip(&edges) {
                    self.cell(cell, *edge, column, top, self.y - 4.5);
                }
            }
        }
        self.line((self.left, self.y), (right, self.y), BLACK, 1.0);
        self.y += 14.0;
    }

    /// A cell from `top` to where the row ends, whose number stands on the line `base`.
    fn cell(&mut self, cell: &Cell, edge: f32, column: f32, top: f32, base: f32) {
        match cell {
            Cell::Number(text) => {
                let shown = shown(text);
                let pad = PAD.min(0.08 * column);
                let size = self.fitted(&shown, self.body(), column - 2.0 * pad);
                self.text((edge - pad, base), &shown, size, Anchor::End);
            }
            Cell::Blank(_) => {
                let (x, end) = (edge - column + 1.5, edge - 1.5);
                let (y, low) = (top + 1.5, self.y - 1.5);
                let points = vec![(x, y), (end, y), (end, low), (x, low), (x, y)];
                self.shapes.push(Shape::Line { points, colour: GREY, width: 0.6, dash: &[] });
            }
            Cell::Nothing => {}
        }
    }

    /// Tables with the same rows as a single one, which has a row for each of their columns. Masses are above it.
    fn joined(&mut self, tables: &[&Table]) {
        let body = self.body();
        let small = (SMALL * self.scale).max(6.8);
        let Some(first) = tables.first() else { return };
        let is_asked = |row: &&super::Row| !row.name.starts_with("mass");
        let heads: Vec<&str> = first.groups.iter().flatten().filter(is_asked).map(|row| row.name.as_str()).collect();
        let names = tables.iter().flat_map(|table| &table.columns).map(|name| self.letters.width(name, body));
        let names = names.fold(0.0, f32::max) + PAD;
        let column = (self.room - names) / heads.len().max(1) as f32;
        let edges: Vec<f32> = (1..=heads.len()).map(|k| self.left + names + column * k as f32).collect();
        let heads: Vec<Vec<String>> = heads.iter().map(|head| self.letters.lines(head, small, column - 3.0)).collect();
        let lines = heads.iter().map(Vec::len).max().unwrap_or(0) as f32;
        let right = self.left + self.room;
        self.make_room(lines * small * 1.2 + 6.0);
        self.line((self.left, self.y), (right, self.y), BLACK, 1.0);
        for (head, edge) in heads.iter().zip(&edges) {
            for (line, place) in head.iter().zip(1_u8..) {
                let size = self.fitted(line, small, column - 3.0);
                let at = (edge - column / 2.0, self.y + f32::from(place) * small * 1.2);
                self.text(at, line, size, Anchor::Middle);
            }
        }
        self.y += lines * small * 1.2 + 4.0;
        for table in tables {
            let rows: Vec<&super::Row> = table.groups.iter().flatten().filter(is_asked).collect();
            let cells = |place: usize| rows.iter().filter_map(move |row| row.cells.get(place)).cloned().collect();
            let columns: Vec<Vec<Cell>> = (0..table.columns.len()).map(cells).collect();
            let needed: f32 = columns.iter().map(|cells| self.row_height(cells)).sum();
            self.make_room(needed + body * LEADING + 2.0);
            self.line((self.left, self.y), (right, self.y), BLACK, 0.6);
            self.y += body * LEADING + 1.0;
            let size = self.fitted(&table.title, body, self.room);
            self.text((self.left, self.y - 3.0), &table.title, size, Anchor::Start);
            for (name, cells) in table.columns.iter().zip(&columns) {
                let top = self.y;
                self.y += self.row_height(cells);
                let base = (top + self.y) / 2.0 + 0.36 * body;
                self.text((self.left, base), name, body, Anchor::Start);
                for (cell, edge) in cells.iter().zip(&edges) {
                    self.cell(cell, *edge, column, top, base);
                }
            }
            self.y += 1.5;
        }
        self.line((self.left, self.y), (right, self.y), BLACK, 1.0);
        self.y += 4.0;
    }
}

/// A table of a collision: the tables of bodies have no title.
fn titled(part: &Part) -> Option<&Table> {
    match part {
        Part::Table(table) if !table.title.is_empty() => Some(table),
        _ => None,
    }
}

/// A number with true minus signs, and its power of ten raised.
fn shown(text: &str) -> String {
    with_powers(text, raised).replace('-', "−")
}

/// A decimal with a power of ten.
fn raised(digits: &str, exponent: &str) -> String {
    format!("{digits}·10^{{{}}}", exponent.replace('-', "−"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::decimal::Digits;
    use crate::report::worksheet::{Style, Subject, sheet};
    use crate::scene::read::{Subject as Scene, described};
    use crate::table::worksheet::Worksheet;

    /// All sheets of a scene, with numbers that are far too long for their cells.
    fn sheets(text: &str) -> Vec<Sheet> {
        let (about, scene) = described(text).expect("it reads");
        let (worksheet, drop) = match &scene {
            Scene::Chain(scene) => (Worksheet::of(scene.inputs.chain().expect("a chain")), None),
            Scene::Drop(drop, _) => (Worksheet::of_drop(drop), Some(drop)),
        };
        let worksheet = worksheet.expect("a worksheet");
        let standard =
            Some("a standard of so many words that it does not fit on a single line of a page, whatever the paper");
        let title = "A title that goes on and on, longer than a line of any page on which it could ever be printed";
        let subject = Subject {
            worksheet: &worksheet,
            about: &about,
            drop,
            title,
            version: Some(('A', u64::MAX)),
            standard,
            asked: None,
        };
        let style = Style { digits: Digits::Significant(60), exact: true };
        [false, true].map(|filled| sheet(&subject, style, filled).expect("a sheet")).to_vec()
    }

    #[test]
    fn nothing_lies_over_the_margin_and_no_two_lines_of_text_overlap() {
        let letters = Letters::new();
        for text in [
            include_str!("../../../../examples/scenes/car-chain.toml"),
            include_str!("../../../../examples/scenes/three-balls-measured.toml"),
            "[chain]\nfirst = \"2\"\nlast = \"1e-9\"\ninserted = 12\nrestitution = \"1/3\"\n",
        ] {
            for letter in [false, true] {
                for page in pages(&sheets(text), letter) {
                    let (left, right, bottom) = (MARGIN - 0.5, page.width - MARGIN + 0.5, page.height - MARGIN + 3.0);
                    let mut words: Vec<(f32, f32, f32, String)> = Vec::new();
                    for shape in &page.shapes {
                        match shape {
                            Shape::Text { at, text, size, anchor, .. } => {
                                let width = letters.width(text, *size);
                                let from = match anchor {
                                    Anchor::Start => at.0,
                                    Anchor::Middle => at.0 - width / 2.0,
                                    Anchor::End => at.0 - width,
                                };
                                assert!(
                                    from >= left && from + width <= right,
                                    "{text:?} from {from} to {}",
                                    from + width
                                );
                                assert!(at.1 - size >= MARGIN - 8.0 && at.1 <= bottom, "{text:?} at {}", at.1);
                                for (y, begin, end, other) in &words {
                                    let apart = (at.1 - y).abs() > 1.0 || from >= *end || from + width <= *begin;
                                    assert!(apart, "{text:?} over {other:?}");
                                }
                                words.push((at.1, from, from + width, text.clone()));
                            }
                            Shape::Line { points, .. } => {
                                assert!(
                                    points.iter().all(|p| p.0 >= left && p.0 <= right && p.1 <= bottom),
                                    "{points:?}"
                                );
                            }
                            other => panic!("a sheet has text and lines alone: {other:?}"),
                        }
                    }
                }
            }
        }
    }
}
