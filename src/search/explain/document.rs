//! A proof in words: sentences that contain formulas, formulas on lines of their own, and nested parts under a supposition.
//! The writers of text, HTML and LaTeX decide the layout.

use crate::certificate::Label;
use crate::claim::syntax::{Claim, Expr, Prop};
use crate::claim::write_out::Words;

/// A part of a sentence.
#[derive(Clone, Debug)]
pub enum Piece {
    /// Words.
    Text(String),
    /// An expression.
    Expr(Expr),
    /// A proposition.
    Prop(Prop),
    /// A cited fact: its number if it has a line of its own, else its text.
    Fact(Label, Prop),
    /// The number of a formula.
    Number(usize),
}

/// A part of a proof.
#[derive(Clone, Debug)]
pub enum Block {
    /// A sentence.
    Sentence(Vec<Piece>),
    /// A formula on a line of its own.
    Formula {
        /// The fact that it says.
        label: Option<Label>,
        /// The formula.
        prop: Prop,
        /// Its number, if something refers to it.
        number: Option<usize>,
    },
    /// The part of a proof under a supposition or for a new variable.
    Inner(Vec<Block>),
}

/// A proof in words.
#[derive(Clone, Debug, Default)]
pub struct Document {
    /// Its parts in order.
    pub blocks: Vec<Block>,
}

impl Document {
    /// A document in which the formulas that something refers to have numbers, counted from 1.
    pub(super) fn numbered(mut blocks: Vec<Block>) -> Document {
        let mut asked = Vec::new();
        references(&blocks, &mut asked);
        let mut numbers = Vec::new();
        number(&mut blocks, &asked, &mut numbers);
        refer(&mut blocks, &numbers);
        Document { blocks }
    }

    /// The document in the words of the claim's author: `cos(theta/2)` for the name that the reader made.
    pub(super) fn in_words(mut self, claim: &Claim) -> Document {
        put_words(&mut self.blocks, &Words::of(claim));
        self
    }
}

fn put_words(blocks: &mut [Block], words: &Words) {
    for block in blocks {
        match block {
            Block::Sentence(pieces) => pieces.iter_mut().for_each(|piece| match piece {
                Piece::Expr(e) => *e = words.expr(e),
                Piece::Prop(prop) | Piece::Fact(_, prop) => *prop = words.prop(prop),
                Piece::Text(_) | Piece::Number(_) => {}
            }),
            Block::Formula { prop, .. } => *prop = words.prop(prop),
            Block::Inner(inner) => put_words(inner, words),
        }
    }
}

fn references(blocks: &[Block], out: &mut Vec<Label>) {
    for block in blocks {
        match block {
            Block::Sentence(pieces) => out.extend(pieces.iter().filter_map(|piece| match piece {
                Piece::Fact(label, _) => Some(label.clone()),
                _ => None,
            })),
            Block::Formula { .. } => {}
            Block::Inner(inner) => references(inner, out),
        }
    }
}

fn number(blocks: &mut [Block], asked: &[Label], numbers: &mut Vec<(Label, usize)>) {
    for block in blocks {
        match block {
            Block::Formula { label: Some(label), number, .. } if asked.contains(label) => {
                *number = Some(numbers.len() + 1);
                numbers.push((label.clone(), numbers.len() + 1));
            }
            Block::Inner(inner) => self::number(inner, asked, numbers),
            _ => {}
        }
    }
}

fn refer(blocks: &mut [Block], numbers: &[(Label, usize)]) {
    for block in blocks {
        match block {
            Block::Sentence(pieces) => {
                for piece in pieces {
                    let Piece::Fact(label, prop) = piece else { continue };
                    *piece = match numbers.iter().find(|n| n.0 == *label) {
                        Some((_, number)) => Piece::Number(*number),
                        None => Piece::Prop(prop.clone()),
                    };
                }
            }
            Block::Formula { .. } => {}
            Block::Inner(inner) => refer(inner, numbers),
        }
    }
}
