"""The page of all tables and the bar chart in benches/results, and the short table of docs/peers.md between its markers."""
import re

import aims
from load import LOADED
from peer import DIGITS
from tools import CERTIFIED, EXACT, PLAIN, PROOF, TITLES

# The cases that the tables show where there are many; the JSON holds all.
SHOWN = {
    "J3": [f"{what}/{count}" for what in ("eta", "L_7") for count in DIGITS],
    "J4": ["equal/1", "equal/12", "above/6", "below/1", "below/3", "below/6", "below/12", "far/12"],
    "J5": ["1", "2", "3", "4", "5", "6", "7", "8"],
    "J6": [f"last/{10**k}" for k in range(2, 7)] + ["all/1000"],
}
# What the chart shows of each job.
CHART = [
    ("J1", "19 identities"), ("J2a", "one of 100000 cells"), ("J2b", "one of 1000000 cells"), ("J3", "L_7/100"),
    ("J3", "L_7/1000000"), ("J4", "below/6"), ("J5", "6"), ("J6", "last/10000"), ("J7", "1e9"), ("J8", "first answer"),
]
# The lines of the short table: job, case, and what was measured.
SHORT = [
    ("J1", "19 identities", "19 identities of the catalogue"),
    ("J2a", "one of 100000 cells", "η in one of 10⁵ scattered cells"),
    ("J2b", "one of 1000000 cells", "η in one of 10⁶ cells of a grid"),
    ("J3", "eta/100", "η to 100 digits"), ("J3", "eta/10000", "η to 10⁴ digits"), ("J3", "eta/1000000", "η to 10⁶ digits"),
    ("J3", "L_7/100", "L₇ to 100 digits"), ("J3", "L_7/1000000", "L₇ to 10⁶ digits"),
    ("J4", "equal/12", "sign of e − L₁₂, which is 0"), ("J4", "below/6", "sign of e − L₆, e 10⁻³⁰ below"),
    ("J4", "far/12", "sign of e − L₁₂, e far off"),
    ("J5", "2", "L₃ ≥ L₂ for all masses"), ("J5", "6", "L₇ ≥ L₆ for all masses"),
    ("J6", "last/10000", "last velocity of 10⁴ bodies, exact"), ("J6", "all/1000", "all velocities of 1000 bodies, exact"),
    ("J7", "1e9", "best number of bodies, near 10⁹"),
    ("J8", "first answer", "cold process to its first answer"),
    ("J9", "10", "one collision in a line of 10 bodies"), ("J9", "10000", "one collision in a line of 10⁴ bodies"),
    ("J10", "one call", "η in one call from Python"), ("J10", "one of 100000 rows", "η in one of 10⁵ rows from Python"),
]
# The columns of the short table, by how the names of their tools begin; what no column takes goes into the last one.
COLUMNS = [
    ("SymPy", ("SymPy",)), ("mpmath", ("mpmath",)), ("python-flint, Arb", ("python-flint", "Arb", "FLINT")), ("MPFR", ("MPFR",)),
    ("PARI/GP", ("PARI",)), ("Z3", ("Z3",)), ("cvc5", ("cvc5",)), ("Maxima", ("Maxima",)),
]
OTHERS = "C, NumPy, gmpy2, Python"
# Okabe and Ito's colours, told apart by hatching too.
LOOK = {PROOF: ("#009E73", ""), EXACT: ("#56B4E9", "//"), CERTIFIED: ("#0072B2", ".."), PLAIN: ("#D9D9D9", "xx")}


def duration(seconds):
    for unit, size in (("s", 1), ("ms", 1e-3), ("µs", 1e-6), ("ns", 1e-9)):
        if seconds >= size or unit == "ns":
            return f"{seconds / size:.3g} {unit}" if seconds < 999.5 * size else f"{seconds / size:.0f} {unit}"


def ratio(value):
    return f"{value:.2f}" if value < 10 else f"{value:.0f}"


def cell(result, case, ours, limit):
    found = result["cases"].get(case)
    if found is None:
        return f"> {limit:g} s" if case in result["timeouts"] else "–"
    text = duration(found["median"])
    if found["runs"] > 1:
        text += f" ± {100 * found['spread'] / 2:.0f} %"
    return text if ours is None or result["cases"] is ours else f"{text} (× {ratio(found['median'] / ours[case]['median'])})"


def total(results, name):
    """The sum over all cases, for those who finished all that Carom did."""
    cases = results[0]["cases"]
    mine = next(r["cases"] for r in results if r["tool"] == name)
    done = [case for case in cases if case in mine]
    return sum(mine[c]["median"] for c in done), len(done), len(cases)


def table(job, record):
    results, limit = record["results"], record["limit"]
    cases = SHOWN.get(job) or [case for case in results[0]["cases"] if not case.startswith("least/")]
    head = ["tool", "what the answer is worth", *cases] + (["all"] if job in ("J4", "J5") else [])
    ours = results[0]["cases"]
    lines = [f"### {job}: {TITLES[job]}", "", row(head), row(["---"] * len(head))]
    for result in results:
        cells = [result["tool"], result["guarantee"]]
        cells += [cell(result, case, ours if case in ours else None, limit) for case in cases]
        if job in ("J4", "J5"):
            seconds, done, all_cases = total(results, result["tool"])
            cells.append(duration(seconds) if done == all_cases else f"{done} of {all_cases}")
        lines.append(row(cells))
    lines += over_products(ours, results) if job == "J3" else []
    lines += over_least(job, cases, ours)
    lines += ["", f"Measured {record['when']}, commit {record['commit']}, {beside(record)}."]
    # Of the cases that were not measured again.
    lines += [f"Of {part['when']}, {beside(part)}: {', '.join(part['cases'])}." for part in record.get("earlier", [])]
    lines.append("")
    return "\n".join(lines)


# The operations of full length in the quickest formula known, roots, quotients, squares and products: for eta three square
# roots, a quotient and three squares; for L_7 three square roots and the seventh root, three squares for the eighth power
# and four products for the seventh, and a quotient. One takes between half a product (a short square) and some products.
OPERATIONS = {"eta": 7, "L_7": 12}


def over_products(ours, results):
    """J3 in units of one product of that length, by the same library."""
    counts = [count for count in DIGITS if f"product/{count}" in ours]
    if not counts:
        return []
    lines = ["", "The same in products of two numbers of that length by the same library, and in brackets for each operation of that",
             "length that the formula has: a root, a quotient, a square or a product.", ""]
    lines += [row(["", *(f"{count} digits" for count in counts)]), row(["---"] * (len(counts) + 1))]
    for what, count in OPERATIONS.items():
        times = [ours[f"{what}/{digits}"]["median"] / ours[f"product/{digits}"]["median"] for digits in counts]
        lines.append(row([f"{what}, {count} operations", *(f"{ratio(t)} ({ratio(t / count)})" for t in times)]))
    lines.append(row(["one product", *(duration(ours[f"product/{count}"]["median"]) for count in counts)]))
    gmp = next((r["cases"] for r in results if f"product/{counts[0]}" in r["cases"] and r["cases"] is not ours), None)
    if gmp:
        times = [(gmp[f"product/{count}"]["median"], ours[f"product/{count}"]["median"]) for count in counts]
        lines.append(row(["one product of GMP", *(f"{duration(t)} (× {ratio(t / own)})" for t, own in times)]))
    return lines


# What no answer to a case can do without, by job.
LEAST = {
    "J2a": "to read three doubles and write two",
    "J2b": "to write two doubles",
    "J6": "for the last velocity the last product of its numerator and of its denominator, each of two numbers of half the "
    "length; for all velocities a long number times a short one for each numerator and each denominator",
}


def over_least(job, cases, ours):
    """How many times what an answer cannot do without."""
    known = [case for case in cases if f"least/{case}" in ours]
    if not known:
        return []
    least = {case: ours[f"least/{case}"]["median"] for case in known}
    return ["", f"No answer can do without this: {LEAST[job]}.", "", row(["", *known]), row(["---"] * (len(known) + 1)),
            row(["that alone", *(duration(least[case]) for case in known)]),
            row(["Carom, so many times that", *(ratio(ours[case]["median"] / least[case]) for case in known)])]


def beside(record):
    """The load of other processes while a job ran."""
    others = record.get("others")
    if others is None:
        # Older records have the load average before the job, one of which the job before it may have been.
        return f"load average {record['load']}" if "load" in record else "load not known"
    loaded = ", a loaded machine" if others >= LOADED else ""
    return f"{others} other processes on average{loaded}"


def row(cells):
    return "| " + " | ".join(cells) + " |"


def tables(record):
    versions = ", ".join(f"{name} {version}" for name, version in record["versions"].items())
    parts = [f"Machine: {record['machine']}.", "", f"Versions: {versions}.", "", row(["job", "aim", "measured", "reached"])]
    parts.append(row(["---"] * 4))
    parts += [row([job, aim, measured, "yes" if reached else "**no**"]) for job, aim, measured, reached in aims.lines(record)]
    parts.append("")
    return "\n".join(parts + [table(job, data) for job, data in record["jobs"].items()])


def chart(record, path):
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams.update({"svg.hashsalt": "peers", "font.size": 8, "hatch.linewidth": 0.4, "font.family": "DejaVu Sans"})
    from matplotlib import pyplot
    from matplotlib.patches import Patch

    shown = [(job, case) for job, case in CHART if job in record["jobs"]]
    if not shown:
        return
    counts = [len(record["jobs"][job]["results"]) for job, _ in shown]
    figure, panels = pyplot.subplots(
        len(shown), 1, figsize=(8.2, 0.17 * sum(counts) + 0.62 * len(shown)), squeeze=False,
        gridspec_kw={"height_ratios": counts},
    )
    for panel, (job, case) in zip(panels[:, 0], shown):
        data = record["jobs"][job]
        known = [r["cases"][case]["median"] for r in data["results"] if case in r["cases"]]
        late = [data["limit"] for r in data["results"] if case in r["timeouts"]]
        low, top = min(known + late), max(known + late)
        panel.set_xscale("log")
        panel.set_xlim(low / 2, top * 12)
        for place, result in enumerate(data["results"]):
            colour, hatch = LOOK[result["guarantee"]]
            found = result["cases"].get(case)
            late = case in result["timeouts"]
            if found is None and not late:
                continue
            seconds = data["limit"] if late else found["median"]
            ours = result["tool"].startswith("Carom")
            panel.barh(place, seconds, color="white" if late else colour, hatch="" if late else hatch,
                       edgecolor="black", linewidth=1.6 if ours else 0.5, linestyle=":" if late else "-")
            panel.text(seconds * 1.15, place, f"> {data['limit']:g} s" if late else duration(seconds), va="center",
                       fontweight="bold" if ours else "normal")
        panel.set_yticks(range(len(data["results"])), [r["tool"] for r in data["results"]])
        panel.invert_yaxis()
        panel.tick_params(axis="y", length=0)
        panel.set_title(f"{job}  {TITLES[job]}" + (f": {case}" if job in SHOWN else ""), loc="left", fontsize=8.5, fontweight="bold")
        panel.xaxis.set_major_formatter(lambda x, _: duration(x))
        panel.xaxis.set_minor_formatter(lambda x, _: "")
        panel.spines[["top", "right"]].set_visible(False)
    handles = [Patch(facecolor=c, hatch=h, edgecolor="black", linewidth=0.5, label=name) for name, (c, h) in LOOK.items()]
    figure.legend(handles=handles, loc="upper center", ncols=4, frameon=False)
    figure.tight_layout(rect=(0, 0, 1, 1 - 0.35 / figure.get_size_inches()[1]))
    figure.savefig(path, metadata={"Date": None})
    pyplot.close(figure)


PAGE = """# Carom beside its peers, job by job

`benches/peers/run` writes this page. [Its README](../peers/README.md) lists the method and the variants of each tool. A cell
shows the median, ± half the spread of the rounds, and in brackets the time divided by Carom's: above 1 Carom is faster. *Exact*
answers are right. A *proof* is a verdict with its argument, from the text of the claim. A *certified enclosure* contains the
number. *Uncertified* numbers agree here, without a guarantee by the tool. `> 10 s` was given up.

![Time of every tool, logarithmic](peers.svg)

In two jobs a tool is fast only with knowledge of the problem. J5 asks PARI, SymPy and python-flint twice: to count the
real roots, their general method, and to divide out (y − 1)² and look at the coefficients. In J4 Arb and PARI use the
theorem that L_n is rational only if the mass ratio r is a perfect power. Without it they would not end on equality.

{tables}
"""


def times(value):
    """Two digits, also of what is far from 1."""
    return f"{value:.1g}" if value < 0.1 else ratio(value) if value < 1000 else f"{float(f'{value:.2g}'):,.0f}"


def column(name):
    return next((title for title, begins in COLUMNS if name.startswith(begins)), OTHERS)


def short_cell(results, case, ours, limit, with_name):
    """The quickest of these tools, with ≈ before an answer without a guarantee."""
    done = [result for result in results if case in result["cases"]]
    if not done:
        return f"> {limit:g} s" if any(case in result["timeouts"] for result in results) else ""
    best = min(done, key=lambda result: result["cases"][case]["median"])
    time = best["cases"][case]["median"]
    mark = "≈ " if best["guarantee"] == PLAIN else ""
    name = f"{best['tool'].split(',')[0]} " if with_name else ""
    return f"{mark}{name}{duration(time)} ({times(time / ours)})"


def short(record):
    lines = [row(["job", "what was measured", "Carom", *(title for title, _ in COLUMNS), OTHERS, "date, commit"])]
    lines.append(row(["---"] * (len(COLUMNS) + 5)))
    for job, case, what in SHORT:
        data = record["jobs"].get(job)
        if data is None or case not in data["results"][0]["cases"]:
            continue
        first, *rest = data["results"]
        ours = first["cases"][case]["median"]
        # A case that was left as it was is as old as it says.
        part = next((part for part in data.get("earlier", []) if case in part["cases"]), data)
        cells = [short_cell([r for r in rest if column(r["tool"]) == title], case, ours, data["limit"], title == OTHERS)
                 for title in [*(title for title, _ in COLUMNS), OTHERS]]
        lines.append(row([job, what, duration(ours), *cells, f"{part['when'].split()[0]}, {part['commit']}"]))
    return "\n".join(lines)


def write(record, folder):
    (folder / "peers.md").write_text(PAGE.format(tables=tables(record)))
    chart(record, folder / "peers.svg")


def write_short(record, page):
    """Replaces the table between the markers; the sentences around it are written by hand."""
    new = f"<!-- table -->\n{short(record)}\n<!-- end of table -->"
    page.write_text(re.sub(r"<!-- table -->.*<!-- end of table -->", lambda _: new, page.read_text(), flags=re.S))
