//! An audit as a LaTeX document.

use super::argument::{escape, latex};
use super::{Audit, summary};

/// The document: compile it with pdflatex, lualatex or tectonic.
pub fn document(audit: &Audit, title: &str) -> String {
    let s = summary(&audit.entries);
    let mut out = format!(
        "\\documentclass[a4paper,11pt]{{article}}\n\\usepackage[T1]{{fontenc}}\n\\usepackage[utf8]{{inputenc}}\n\
         \\usepackage{{amsmath,amssymb,textcomp}}\n\\usepackage[margin=25mm]{{geometry}}\n\\sloppy\n\
         \\allowdisplaybreaks\n\\title{{{}}}\n\\date{{}}\n\\begin{{document}}\n\\maketitle\n\
         {}: {} proved, {} refuted, {} undecided; {} not as expected.\n",
        escape(title),
        audit.count(),
        s.proved,
        s.refuted,
        s.undecided,
        s.unexpected
    );
    for (section, entries) in audit.sections() {
        out.push_str(&format!("\n\\section*{{{}}}\n", escape(section)));
        for entry in entries {
            out.push_str(&latex(entry));
            out.push('\n');
        }
    }
    out.push_str("\\end{document}\n");
    out
}
