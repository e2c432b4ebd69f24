//! A proof in words as HTML, the formulas as MathML.

use crate::explain::document::{Block, Document, Piece};
use crate::report::markup::escape;
use crate::report::mathml;

/// The proof as paragraphs; parts under a supposition are in a `div` of the class `inner`.
#[must_use]
pub(crate) fn html(document: &Document) -> String {
    let mut out = String::new();
    blocks(&document.blocks, &mut out);
    out
}

fn blocks(list: &[Block], out: &mut String) {
    for block in list {
        match block {
            Block::Sentence(pieces) => {
                out.push_str("<p>");
                for piece in pieces {
                    out.push_str(&match piece {
                        Piece::Text(text) => escape(text),
                        Piece::Expr(e) => mathml::expression_within(e),
                        Piece::Prop(p) | Piece::Fact(_, p) => mathml::within(p),
                        Piece::Number(n) => format!("({n})"),
                    });
                }
                out.push_str("</p>\n");
            }
            Block::Formula { prop, number, .. } => {
                let number = number.map_or(String::new(), |n| format!("<span class=\"number\">({n})</span>"));
                out.push_str(&format!("<div class=\"formula\">{number}{}</div>\n", mathml::statement(prop)));
            }
            Block::Inner(inner) => {
                out.push_str("<div class=\"inner\">\n");
                blocks(inner, out);
                out.push_str("</div>\n");
            }
        }
    }
}
