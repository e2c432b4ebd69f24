//! Certified tables and pictures in the page.

use super::wide;
use crate::report::handout::numbers::{Plot, Table, WHAT_IS_CERTAIN};
use crate::report::handout::{Handout, address, named, plot_file, provenance, table_file};
use crate::report::markup::escape;

/// Writes all of them.
pub(super) fn all(out: &mut String, handout: &Handout) {
    out.push_str(&format!("<p>{WHAT_IS_CERTAIN}</p>\n"));
    for (place, one) in handout.tables.iter().enumerate() {
        table(out, handout, place, one);
    }
    for (place, one) in handout.plots.iter().enumerate() {
        plot(out, handout, place, one);
    }
}

/// A text in which names of claims stand between backquotes, as links where the page has them.
fn linked(handout: &Handout, text: &str) -> String {
    let known = |name: &str| handout.catalogue && handout.audit.entries.iter().any(|e| e.claim.name.text == name);
    let part = |(place, part): (usize, &str)| match (place % 2, escape(part)) {
        (1, name) if known(part) => format!("<a href=\"#{name}\">{name}</a>"),
        (1, name) => format!("<code>{name}</code>"),
        (_, text) => text,
    };
    text.split('`').enumerate().map(part).collect()
}

fn table(out: &mut String, handout: &Handout, place: usize, table: &Table) {
    let title = format!("Table {}: {}", place + 1, table.title());
    let said: Vec<String> = provenance(handout, table).iter().map(|text| linked(handout, text)).collect();
    out.push_str(&format!("<h3 id=\"page.table.{}\">{}</h3>\n{}", place + 1, escape(&title), wide(&title)));
    out.push_str(&format!("<table class=\"numbers\"><caption>{}.</caption>\n<thead><tr>", said.join(". ")));
    let class = |numeric: bool| if numeric { " class=\"number\"" } else { "" };
    for column in &table.head.columns {
        out.push_str(&format!("<th scope=\"col\"{}>{}</th>", class(column.numeric), escape(&column.name)));
    }
    out.push_str("</tr></thead>\n<tbody>\n");
    for row in &table.rows {
        out.push_str("<tr>");
        for (entry, column) in row.iter().zip(&table.head.columns) {
            let (kept, small, exponent) = entry.parts();
            let small = if small.is_empty() { String::new() } else { format!("<small>{}</small>", escape(small)) };
            let exponent = if exponent.is_empty() { String::new() } else { format!("e{}", escape(exponent)) };
            out.push_str(&format!("<td{}>{}{small}{exponent}</td>", class(column.numeric), escape(kept)));
        }
        out.push_str("</tr>\n");
    }
    out.push_str("</tbody></table>\n</div>\n");
    let (csv, certificate) = (address(&table_file(place, "csv")), address(&table_file(place, "jsonl")));
    out.push_str(&format!(
        "<p class=\"meta\"><code>{}</code> · <a href=\"{csv}\">CSV</a> · <a href=\"{certificate}\">certificate</a></p>\n",
        escape(&table.command)
    ));
}

fn plot(out: &mut String, handout: &Handout, place: usize, plot: &Plot) {
    let (title, number) = (escape(&plot.title), place + 1);
    // The picture is the file's text, which the engine made; only its identifiers are its own.
    out.push_str(&format!(
        "<figure>\n<h3 id=\"page.plot.{number}\">Figure {number}: {title}</h3>\n{}\
         <figcaption>The formulas are those of {}.</figcaption>\n</figure>\n",
        plot.inline,
        linked(handout, &named(handout, plot.claims)),
    ));
    let (svg, png) = (address(&plot_file(place, "svg")), address(&plot_file(place, "png")));
    out.push_str(&format!(
        "<p class=\"meta\"><code>{}</code> · <a href=\"{svg}\">SVG</a> · <a href=\"{png}\">PNG</a></p>\n",
        escape(&plot.command)
    ));
}
