//! Sheets as a LaTeX document, on A4 or letter paper.
//!
//! Contract: nothing is wider than the text: columns have fixed widths, and a number that is longer is set smaller. Each
//! sheet begins on a page of its own.

use super::sketch::{Sketch, Stroke};
use super::{Cell, Part, Sheet, Table, with_powers};
use crate::report::latex::escape;

/// The document with all sheets.
#[must_use]
pub fn document(sheets: &[Sheet], letter: bool) -> String {
    let paper = if letter { "letterpaper" } else { "a4paper" };
    let mut out = format!(
        "% carom {}: needs pdflatex or lualatex with amssymb, array, booktabs, fancyhdr, geometry and graphicx.\n\
         \\documentclass[11pt,{paper}]{{article}}\n\\usepackage[utf8]{{inputenc}}\n\
         \\usepackage{{amssymb,array,booktabs,fancyhdr,graphicx}}\n\\usepackage[{paper},margin=20mm,headheight=14pt]{{geometry}}\n\
         \\setlength{{\\parindent}}{{0pt}}\\setlength{{\\parskip}}{{4pt}}\\pagestyle{{fancy}}\\fancyhf{{}}\n\
         \\renewcommand{{\\headrulewidth}}{{0pt}}\n\
         % A number that is wider than its column is set smaller; a strut leaves room for a pen.\n\
         \\newsavebox{{\\numeral}}\n\
         \\newcommand{{\\fit}}[1]{{\\savebox{{\\numeral}}{{#1}}\\ifdim\\wd\\numeral>\\linewidth\\resizebox{{\\linewidth}}{{!}}{{\\usebox{{\\numeral}}}}\
         \\else\\usebox{{\\numeral}}\\fi}}\n\
         \\newcommand{{\\pen}}{{\\rule[-2.4mm]{{0pt}}{{8mm}}\\hrulefill}}\n\
         \\newcolumntype{{L}}[1]{{>{{\\raggedright\\arraybackslash}}p{{#1}}}}\n\
         \\newcolumntype{{R}}[1]{{>{{\\raggedleft\\arraybackslash}}p{{#1}}}}\n\\begin{{document}}\n",
        env!("CARGO_PKG_VERSION")
    );
    for (place, sheet) in sheets.iter().enumerate() {
        if place > 0 {
            out.push_str("\\newpage\n");
        }
        out.push_str(&one(sheet));
    }
    out.push_str("\\end{document}\n");
    out
}

fn one(sheet: &Sheet) -> String {
    let mut out = format!(
        "\\setcounter{{page}}{{1}}\\fancyfoot[L]{{\\footnotesize {}}}\\fancyfoot[R]{{\\footnotesize page \\thepage}}\n\\section*{{{}}}\n",
        escape(&sheet.foot),
        escape(&sheet.title)
    );
    for part in &sheet.parts {
        match part {
            Part::Names => out.push_str(
                "Name \\rule{70mm}{0.4pt}\\hfill Class \\rule{22mm}{0.4pt}\\hfill Date \\rule{28mm}{0.4pt}\\par\\medskip\n",
            ),
            Part::Heading(text) => out.push_str(&format!("\\subsection*{{{}}}\n", escape(text))),
            Part::Text(text) => out.push_str(&format!("{}\\par\n", formulas(text))),
            Part::Sketch(sketch) => out.push_str(&drawn(sketch)),
            Part::Choice { ask, options, .. } => {
                let boxes = options.iter().map(|(text, right)| {
                    let mark = if *right { "\\boxtimes" } else { "\\square" };
                    format!("\\mbox{{${mark}$ {}}}", escape(text))
                });
                let boxes = boxes.collect::<Vec<_>>().join("\\qquad{} ");
                out.push_str(&format!("{}\\par\n{{\\raggedright\\leftskip=6mm {boxes}\\par}}\n", formulas(ask)));
            }
            Part::Open { ask, answer, lines, .. } => {
                out.push_str(&format!("{}\\par\n", formulas(ask)));
                match answer {
                    Some(answer) => out.push_str(&format!("\\hspace*{{6mm}}\\textbf{{{}}}\\par\n", powers(answer))),
                    None => out.push_str(&"\\rule{0pt}{8mm}\\hrulefill\\par\n".repeat(*lines)),
                }
            }
            Part::Table(found) => out.push_str(&table(found)),
        }
    }
    out
}

/// The width of a sketch, in points of PostScript.
const WIDTH: f32 = 455.0;

/// A sketch in LaTeX's own picture environment, which counts from the lower left corner.
fn drawn(sketch: &Sketch) -> String {
    let height = sketch.height();
    let mut out =
        format!("\\par\\medskip{{\\setlength{{\\unitlength}}{{1bp}}\\begin{{picture}}({WIDTH:.0},{height:.0})\n");
    for stroke in sketch.strokes(WIDTH) {
        match stroke {
            Stroke::Line(points) => {
                for pair in points.windows(2) {
                    let ((x, y), (to_x, to_y)) = (pair[0], pair[1]);
                    let step = |d: f32| if d == 0.0 { 0 } else { d.signum() as i32 };
                    let (dx, dy) = (step(to_x - x), step(y - to_y));
                    let length = (to_x - x).abs().max((to_y - y).abs());
                    out.push_str(&format!("\\put({x:.1},{:.1}){{\\line({dx},{dy}){{{length:.1}}}}}\n", height - y));
                }
            }
            Stroke::Label((x, y), text, size) => out.push_str(&format!(
                "\\put({x:.1},{:.1}){{\\makebox(0,0){{\\fontsize{{{size:.1}}}{{{size:.1}}}\\selectfont {}}}}}\n",
                height - y,
                powers(&text)
            )),
        }
    }
    out + "\\end{picture}}\\par\\medskip\n"
}

/// Text with its powers of ten in mathematics mode.
fn powers(text: &str) -> String {
    with_powers(&escape(text), |digits, exponent| format!("${digits}\\cdot 10^{{{exponent}}}$"))
}

/// Text with the formulas of a sheet in mathematics mode.
fn formulas(text: &str) -> String {
    powers(text).replace("p = m v is", "$p = mv$ is").replace("E = m v$^2$/2 the", "$E = \\frac12 mv^2$ the")
}

fn table(table: &Table) -> String {
    let width = match table.columns.len() {
        0..=3 => 32,
        4 => 24,
        _ => 19,
    };
    let columns = format!("R{{{width}mm}}").repeat(table.columns.len());
    let mut out = String::from("\\par\\medskip\\begin{minipage}{\\linewidth}\n");
    if !table.title.is_empty() {
        out.push_str(&format!("\\textbf{{{}}}\\par\\smallskip\n", formulas(&table.title)));
    }
    out.push_str(&format!("\\begin{{tabular}}{{@{{}}L{{48mm}}{columns}@{{}}}}\n\\toprule\n"));
    let heads: Vec<String> = table.columns.iter().map(|c| escape(c)).collect();
    out.push_str(&format!(" & {} \\\\\n", heads.join(" & ")));
    for group in &table.groups {
        out.push_str("\\midrule\n");
        for row in group {
            let cells = row.cells.iter().map(|cell| match cell {
                Cell::Number(text) => format!("\\fit{{{}}}", number(text)),
                Cell::Blank(_) => "\\pen".to_owned(),
                Cell::Nothing => String::new(),
            });
            out.push_str(&format!("{} & {} \\\\\n", escape(&row.name), cells.collect::<Vec<_>>().join(" & ")));
        }
    }
    out.push_str("\\bottomrule\n\\end{tabular}\n\\end{minipage}\\par\n");
    out
}

/// A number in mathematics mode, so that its sign is a minus.
fn number(text: &str) -> String {
    let text = text.replace('±', "\\pm ").replace('−', "-");
    match text.rsplit_once('e') {
        Some((mantissa, exponent)) => format!("${mantissa} \\cdot 10^{{{exponent}}}$"),
        None => format!("${text}$"),
    }
}
