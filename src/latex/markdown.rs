//! A Markdown file as LaTeX: its displayed formulas and its comments, at the same places.
//!
//! Contract: the result has as many bytes as the source, and each formula and comment stands where it stands there. Formulas
//! are `$$ … $$` and code blocks with the word `math`; a comment is `<!-- carom … -->` on one line. Code and other
//! comments are passed over.

/// The LaTeX in a Markdown file; everything else is spaces.
#[must_use]
pub fn latex_of(source: &str) -> String {
    let mut out: Vec<u8> = source.bytes().map(|b| if b == b'\n' { b'\n' } else { b' ' }).collect();
    let mut keep = |from: usize, text: &str| {
        if let Some(place) = out.get_mut(from..from + text.len()) {
            place.copy_from_slice(text.as_bytes());
        }
    };
    let mut at = 0;
    // Whether a comment for people goes on.
    let mut is_comment = false;
    // The fence of a code block, and whether it holds a formula.
    let mut fence: Option<(&str, bool)> = None;
    let mut is_formula = false;
    for line in source.split_inclusive('\n') {
        let start = at;
        at += line.len();
        let trimmed = line.trim();
        let indent = line.len() - line.trim_start().len();
        let mut rest = 0;
        if is_comment {
            let Some(end) = line.find("-->") else { continue };
            is_comment = false;
            rest = end + 3;
        }
        if let Some((mark, is_math)) = fence {
            if trimmed.starts_with(mark) {
                fence = None;
                if is_math {
                    keep(start + indent, "$$");
                }
            } else if is_math {
                keep(start, line);
            }
            continue;
        }
        if let Some(mark) = ["```", "~~~"].into_iter().find(|mark| trimmed.starts_with(mark)).filter(|_| !is_formula) {
            let is_math = trimmed[mark.len()..].trim() == "math";
            fence = Some((mark, is_math));
            if is_math {
                keep(start + indent, "$$");
            }
            continue;
        }
        while rest < line.len() {
            if is_formula {
                let end = line[rest..].find("$$").map_or(line.len(), |end| rest + end + 2);
                keep(start + rest, &line[rest..end]);
                is_formula = !line[rest..end].ends_with("$$");
                rest = end;
                continue;
            }
            let next = ["$$", "<!-- carom", "<!--", "`"]
                .into_iter()
                .filter_map(|mark| Some((line[rest..].find(mark)?, mark)))
                .min_by_key(|(place, mark)| (*place, std::cmp::Reverse(mark.len())));
            let Some((place, mark)) = next else { break };
            let place = rest + place;
            match mark {
                "$$" => {
                    keep(start + place, "$$");
                    is_formula = true;
                    rest = place + 2;
                }
                "`" => rest = line[place + 1..].find('`').map_or(line.len(), |end| place + 1 + end + 1),
                "<!--" => match line[place..].find("-->") {
                    Some(end) => rest = place + end + 3,
                    None => {
                        is_comment = true;
                        break;
                    }
                },
                _ => {
                    let said = place + mark.len();
                    let end = line[said..].find("-->").map_or(line.len(), |end| said + end);
                    keep(start + place, "    %carom");
                    keep(start + said, line[said..end].trim_end_matches('\n'));
                    // The comment ends here; what follows it on the line is text.
                    if end < line.len() && line[end..].starts_with("-->") {
                        keep(start + end, "\n");
                    }
                    rest = (end + 3).min(line.len());
                }
            }
        }
    }
    // Only whole parts of the source were copied, so this is text.
    String::from_utf8(out).unwrap_or_default()
}
