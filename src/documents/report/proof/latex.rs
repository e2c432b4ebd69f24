//! A proof in words as LaTeX: sentences around displayed formulas.
//!
//! Contract: the text needs [`MACROS`] before it. A formula wider than the line is made smaller, or broken at its
//! relations and signs, by TeX itself, which alone knows how wide it is.

use crate::claim::print::Style;
use crate::explain::document::{Block, Document, Piece};
use crate::report::latex::escape;

/// `\formula{…}{…}` sets a formula on lines of its own; the second text is the same with parentheses that may be broken.
pub(crate) const MACROS: &str = r"\ifdefined\carombox\else\newsavebox{\carombox}\fi
\providecommand{\formula}[2]{\sbox{\carombox}{$\displaystyle #1$}%
  \par\smallskip
  \ifdim\wd\carombox<\linewidth{\centering\usebox{\carombox}\par}%
  \else\ifdim\wd\carombox<1.3\linewidth\noindent\resizebox{\linewidth}{!}{\usebox{\carombox}}\par
  \else{\raggedright\hangindent=2em\hangafter=1\noindent\footnotesize\relpenalty=0 \binoppenalty=0
  \lineskip=3pt$\displaystyle #2$\par}\fi\fi\smallskip}
";

/// Lists of LaTeX nest no deeper than this.
const DEEPEST: usize = 4;

/// The proof as LaTeX.
#[must_use]
pub(crate) fn latex(document: &Document) -> String {
    let mut out = String::new();
    blocks(&document.blocks, 0, &mut out);
    out
}

/// A formula of mathematics mode on a line of its own, behind its number.
#[must_use]
pub(crate) fn formula(number: &str, math: &str) -> String {
    let breakable = math.replace("\\left(", "(").replace("\\right)", ")");
    format!("\\formula{{{number}{math}}}{{{number}{breakable}}}\n")
}

fn blocks(list: &[Block], depth: usize, out: &mut String) {
    for block in list {
        match block {
            Block::Sentence(pieces) => {
                out.push_str(&format!("{{\\raggedright\\noindent {}\\par}}\n", sentence(pieces)));
            }
            Block::Formula { prop, number, .. } => {
                let number = number.map_or(String::new(), |n| format!("\\text{{({n})}}\\quad "));
                out.push_str(&formula(&number, &Style::Latex.prop(prop)));
            }
            Block::Inner(inner) if depth < DEEPEST => {
                out.push_str(
                    "\\begin{list}{}{\\leftmargin=1.5em\\rightmargin=0pt\\topsep=0pt\\partopsep=0pt}\\item[]\n",
                );
                blocks(inner, depth + 1, out);
                out.push_str("\\end{list}\n");
            }
            Block::Inner(inner) => blocks(inner, depth, out),
        }
    }
}

fn sentence(pieces: &[Piece]) -> String {
    let math = |text: String| {
        let breakable = text.replace("\\left(", "(").replace("\\right)", ")").replace(" \\, ", " \\,\\allowbreak ");
        format!("${breakable}$")
    };
    pieces
        .iter()
        .map(|piece| match piece {
            Piece::Text(text) => escape(text),
            Piece::Expr(e) => math(Style::Latex.expr(e)),
            Piece::Prop(p) | Piece::Fact(_, p) => math(Style::Latex.prop(p)),
            Piece::Number(n) => format!("({n})"),
        })
        .collect()
}
