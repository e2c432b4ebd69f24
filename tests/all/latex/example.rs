//! The first paper once more, as LaTeX, and the example of the page for users.

use carom::certificate::text::digest;
use carom::claim::embedded;
use carom::claim::syntax::Claim;
use carom::kernel::statement::Statement;
use carom::latex::{Outcome, Paper, latex_of, paper};

fn claims(paper: Paper) -> Vec<Claim> {
    assert!(paper.faults.is_empty(), "{:?}", paper.faults);
    let read = |outcome: Outcome| match outcome {
        Outcome::Read(claim) => Some(*claim),
        Outcome::NotRead(faults) => panic!("{}", faults[0].message()),
        _ => None,
    };
    paper.equations.into_iter().filter_map(|equation| read(equation.outcome)).collect()
}

fn digest_of(claim: &Claim) -> String {
    digest(&Statement::of(claim).unwrap().text())
}

#[test]
fn an_equation_of_the_first_paper_says_something_else_in_latex() {
    let found = claims(paper(include_str!("../../../examples/papers/maximal-transfer.tex")).unwrap());
    assert_eq!(found.len(), 25);
    let all = embedded::claims(&[]).unwrap().unwrap();
    let mut other = Vec::new();
    for (place, claim) in found.iter().enumerate() {
        assert_eq!(claim.name.text, format!("eq{:02}", place + 1));
        let stored = all.iter().find(|c| c.name.text == claim.name.text).unwrap();
        if digest_of(claim) != digest_of(stored) {
            other.push(format!("{}\n{}", Statement::of(claim).unwrap().text(), Statement::of(stored).unwrap().text()));
        }
    }
    assert!(other.is_empty(), "{}", other.join("\n"));
}

#[test]
fn the_example_of_the_page_is_not_read() {
    let page = include_str!("../../../docs/latex.md");
    let example = page.split("```latex\n").nth(1).unwrap().split("```").next().unwrap();
    let names: Vec<String> = claims(paper(example).unwrap()).into_iter().map(|claim| claim.name.text).collect();
    assert_eq!(names, ["first", "second", "share"]);
}

#[test]
fn a_formula_of_a_markdown_file_is_not_read_at_its_place() {
    let text = "# Nöte\n\n<!-- carom given a, b > 0 -->\nThe `$$x$$` is code.\n\n$$ a + b = b + a $$\n\n```math\na b = b a\n```\n";
    let latex = latex_of(text);
    assert_eq!(latex.len(), text.len());
    let found = claims(paper(&latex).unwrap());
    assert_eq!(found.len(), 2, "{latex}");
    let span = found[0].goal.span;
    assert_eq!(&text[span.start..span.end], "a + b = b + a");
}
