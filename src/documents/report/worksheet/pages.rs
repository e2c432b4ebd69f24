//! Sheets laid out on pages of A4 or letter paper, from the shapes and letters of pictures.
//!
//! Contract: every shape lies within the margins; each sheet begins on a page of its own; a table or a question is not cut.
//! A number that is wider than its column is set smaller. Cells to be filled in are seven millimetres high.

use super::sketch::Stroke;
use super::{Cell, Part, Sheet, Table, with_powers};
use crate::report::plot::letters::Letters;
use crate::report::plot::shape::{Anchor, BLACK, Colour, Page, Shape};

/// The margin, in points.
const MARGIN: f32 = 54.0;
/// Room for the foot above the lower margin.
const FOOT: f32 = 18.0;
/// Sizes of letters.
const TITLE: f32 = 15.0;
const HEADING: f32 = 12.0;
const BODY: f32 = 9.5;
const SMALL: f32 = 7.5;
/// From one line to the next, for each point of the letters.
const LEADING: f32 = 1.4;
/// The height of a cell with a number, and of one for a pen.
const PRINTED: f32 = 15.0;
const PEN: f32 = 19.9;
/// The widest column of numbers, and the least width of the names of rows.
const COLUMN: f32 = 96.0;
const NAMES: f32 = 160.0;
/// Between a number and the edge of its column.
const PAD: f32 = 6.0;
const GREY: Colour = Colour(0x88, 0x88, 0x88);

/// The pages of all sheets.
#[must_use]
pub fn pages(sheets: &[Sheet], letter: bool) -> Vec<Page> {
    let (width, height) = if letter { (612.0, 792.0) } else { (595.0, 842.0) };
    let letters = Letters::new();
    let mut out = Vec::new();
    for sheet in sheets {
        let mut flow =
            Flow { letters: &letters, sheet, width, height, y: MARGIN, pages: Vec::new(), shapes: Vec::new() };
        flow.all();
        out.append(&mut flow.pages);
    }
    out
}

/// A sheet on its way onto pages.
struct Flow<'a> {
    letters: &'a Letters,
    sheet: &'a Sheet,
    width: f32,
    height: f32,
    y: f32,
    pages: Vec<Page>,
    shapes: Vec<Shape>,
}

impl Flow<'_> {
    fn room(&self) -> f32 {
        self.width - 2.0 * MARGIN
    }

    fn all(&mut self) {
        self.paragraph(&self.sheet.title.clone(), TITLE, 0.0);
        self.y += 4.0;
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
        let free = self.room() - self.letters.width(&right, SMALL) - 12.0;
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
        self.letters.lines(&with_powers(text, raised), size, self.room() - indent)
    }

    fn paragraph(&mut self, text: &str, size: f32, indent: f32) {
        for line in self.lines(text, size, indent) {
            // A paragraph longer than a page continues on the next page.
            self.make_room(size * LEADING);
            self.y += size * LEADING;
            self.text((MARGIN + indent, self.y - 0.3 * size), &line, size, Anchor::Start);
        }
    }

    fn height_of(&self, part: &Part) -> f32 {
        let text = |text: &str, indent: f32| self.lines(text, BODY, indent).len() as f32 * BODY * LEADING;
        match part {
            Part::Names => 34.0,
            Part::Heading(_) => HEADING * LEADING + 12.0,
            Part::Text(content) => text(content, 0.0) + 5.0,
            Part::Sketch(sketch) => sketch.height() + 14.0,
            Part::Choice { ask, options, .. } => text(ask, 0.0) + self.rows(options).len() as f32 * BODY * 1.7 + 7.0,
            Part::Open { ask, answer, lines, .. } => {
                let below = answer.as_ref().map_or(*lines as f32 * PEN, |answer| text(answer, 18.0));
                text(ask, 0.0) + below + 7.0
            }
            Part::Table(table) => {
                let title = if table.title.is_empty() { 0.0 } else { BODY * LEADING + 4.0 };
                let rows: f32 = table.groups.iter().flatten().map(|row| height(&row.cells)).sum();
                title + PRINTED + rows + 14.0
            }
        }
    }

    /// Boxes to tick in rows that are not too wide.
    fn rows<'o>(&self, options: &'o [(String, bool)]) -> Vec<Vec<&'o (String, bool)>> {
        let mut rows: Vec<Vec<&(String, bool)>> = vec![Vec::new()];
        let mut x = 18.0;
        for option in options {
            let width = self.option_width(&option.0);
            if x + width > self.room() && x > 18.0 {
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
        self.letters.width(text, BODY) + 34.0
    }

    fn part(&mut self, part: &Part) {
        match part {
            Part::Names => {
                self.y += 22.0;
                let fields = [("Name", 0.0, 0.50), ("Class", 0.52, 0.70), ("Date", 0.72, 1.0)];
                for (name, from, to) in fields {
                    let (x, end) = (MARGIN + from * self.room(), MARGIN + to * self.room());
                    self.text((x, self.y), name, BODY, Anchor::Start);
                    let begin = x + self.letters.width(name, BODY) + 5.0;
                    self.line((begin, self.y + 1.0), (end, self.y + 1.0), GREY, 0.7);
                }
                self.y += 12.0;
            }
            Part::Heading(text) => {
                self.y += 9.0;
                self.paragraph(text, HEADING, 0.0);
                self.y += 3.0;
            }
            Part::Text(text) => {
                self.paragraph(text, BODY, 0.0);
                self.y += 5.0;
            }
            Part::Sketch(sketch) => {
                self.y += 4.0;
                for stroke in sketch.strokes(self.room()) {
                    match stroke {
                        Stroke::Line(points) => {
                            let points = points.iter().map(|(x, y)| (MARGIN + x, self.y + y)).collect();
                            self.shapes.push(Shape::Line { points, colour: BLACK, width: 0.8, dash: &[] });
                        }
                        Stroke::Label((x, y), text, size) => {
                            let at = (MARGIN + x, self.y + y + 0.36 * size);
                            self.text(at, &with_powers(&text, raised), size, Anchor::Middle);
                        }
                    }
                }
                self.y += sketch.height() + 10.0;
            }
            Part::Choice { ask, options, .. } => {
                self.paragraph(ask, BODY, 0.0);
                for row in self.rows(options) {
                    self.y += BODY * 1.7;
                    let mut x = MARGIN + 18.0;
                    for (text, right) in row {
                        self.tick((x, self.y - 8.0), *right);
                        self.text((x + 13.0, self.y), text, BODY, Anchor::Start);
                        x += self.option_width(text);
                    }
                }
                self.y += 7.0;
            }
            Part::Open { ask, answer, lines, .. } => {
                self.paragraph(ask, BODY, 0.0);
                match answer {
                    Some(answer) => self.paragraph(answer, BODY, 18.0),
                    None => {
                        for _ in 0..*lines {
                            self.y += PEN;
                            self.line((MARGIN, self.y), (self.width - MARGIN, self.y), GREY, 0.7);
                        }
                    }
                }
                self.y += 7.0;
            }
            Part::Table(table) => self.table(table),
        }
    }

    /// A box, ticked or not.
    fn tick(&mut self, (x, y): (f32, f32), ticked: bool) {
        let s = 8.5;
        let points = vec![(x, y), (x + s, y), (x + s, y + s), (x, y + s), (x, y)];
        self.shapes.push(Shape::Line { points, colour: BLACK, width: 0.8, dash: &[] });
        if ticked {
            self.line((x + 1.5, y + 1.5), (x + s - 1.5, y + s - 1.5), BLACK, 1.4);
            self.line((x + s - 1.5, y + 1.5), (x + 1.5, y + s - 1.5), BLACK, 1.4);
        }
    }

    fn table(&mut self, table: &Table) {
        if !table.title.is_empty() {
            let size = self.fitted(&table.title, BODY, self.room());
            self.y += BODY * LEADING;
            self.text((MARGIN, self.y - 3.0), &table.title, size, Anchor::Start);
            self.y += 4.0;
        }
        let columns = table.columns.len().max(1) as f32;
        let column = COLUMN.min((self.room() - NAMES) / columns);
        let names = self.room().min(NAMES.max(self.room() - COLUMN * columns)).min(self.room() - column * columns);
        let right = MARGIN + names + column * columns;
        let edge = |place: usize| MARGIN + names + column * (place as f32 + 1.0);
        self.line((MARGIN, self.y), (right, self.y), BLACK, 1.0);
        self.y += PRINTED;
        for (place, head) in table.columns.iter().enumerate() {
            let size = self.fitted(head, BODY, column - 2.0 * PAD);
            self.text((edge(place) - PAD, self.y - 4.0), head, size, Anchor::End);
        }
        for group in &table.groups {
            self.line((MARGIN, self.y), (right, self.y), BLACK, 0.6);
            for row in group {
                let top = self.y;
                self.y += height(&row.cells);
                let base = self.y - 4.5;
                let size = self.fitted(&row.name, BODY, names - PAD);
                self.text((MARGIN, base), &row.name, size, Anchor::Start);
                for (place, cell) in row.cells.iter().enumerate() {
                    match cell {
                        Cell::Number(text) => {
                            let shown = shown(text);
                            let size = self.fitted(&shown, BODY, column - 2.0 * PAD);
                            self.text((edge(place) - PAD, base), &shown, size, Anchor::End);
                        }
                        Cell::Blank(_) => {
                            let (x, end) = (edge(place) - column + 3.0, edge(place) - 3.0);
                            let (y, low) = (top + 2.0, self.y - 2.0);
                            let points = vec![(x, y), (end, y), (end, low), (x, low), (x, y)];
                            self.shapes.push(Shape::Line { points, colour: GREY, width: 0.6, dash: &[] });
                        }
                        Cell::Nothing => {}
                    }
                }
            }
        }
        self.line((MARGIN, self.y), (right, self.y), BLACK, 1.0);
        self.y += 14.0;
    }
}

/// The height of a row.
fn height(cells: &[Cell]) -> f32 {
    if cells.iter().any(|cell| matches!(cell, Cell::Blank(_))) { PEN } else { PRINTED }
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
