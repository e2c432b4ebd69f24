"""benches/results/work-precision.svg from its JSON: a panel for each scene, time against the digits that are right."""

# Okabe and Ito's colours; certified tools have filled marks.
LOOK = {
    "Carom": ("#0072B2", "o"), "Arb": ("#D55E00", "s"), "MPFR": ("#009E73", "^"), "mpmath": ("#CC79A7", "v"),
    "PARI": ("#E69F00", "D"), "printed formula, double": ("#000000", "X"),
}
TITLES = {
    "eta": "η, ratio 10, e = 9/10, n = 7",
    "L_7": "L₇, ratio 10",
    "L_2, ratio 1e34": "L₂, ratio 10³⁴: cancellation",
    "eta, n = 1e6": "η, n = 10⁶, 1 − e = 10⁻⁷",
    "L_n, n = 1e6": "Lₙ, n = 10⁶, ratio 10",
    "e - L_7, e near": "e − L₇, e within 10⁻³⁰ of L₇",
}
# Where an answer without one right digit, or without a number, is drawn.
NONE = 0.15


def seconds(x, _=None):
    for unit, size in (("s", 1), ("ms", 1e-3), ("µs", 1e-6), ("ns", 1e-9)):
        if x >= size * 0.999:
            return f"{x / size:g} {unit}"
    return f"{x / 1e-9:g} ns"


def place(reached):
    return NONE if reached is None or reached < 0.7 else reached


def picture(record, path):
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams.update({"svg.hashsalt": "precision", "font.size": 10, "font.family": "DejaVu Sans", "svg.fonttype": "path"})
    from matplotlib import pyplot
    from matplotlib.lines import Line2D

    figure, panels = pyplot.subplots(3, 2, figsize=(8.6, 11.2), sharex=True, sharey=True)
    for panel, (scene, title) in zip(panels.flat, TITLES.items()):
        panel.set_xscale("log")
        panel.set_yscale("log")
        panel.axvspan(0.06, 0.35, color="#EEEEEE", zorder=0)
        for tool, (colour, marker) in LOOK.items():
            points = [p for p in record["points"] if p["scene"] == scene and p["tool"] == tool]
            if not points:
                continue
            certified = points[0]["certified"]
            x, y = [place(p["reached"]) for p in points], [p["seconds"] for p in points]
            panel.plot(x, y, color=colour, marker=marker, markersize=6, linewidth=1.6 if tool == "Carom" else 0.9,
                       markerfacecolor=colour if certified else "white", markeredgecolor=colour, zorder=3 if tool == "Carom" else 2)
            for p, a, b in zip(points, x, y):
                # What was asked for and not reached.
                if not certified and a < 0.9 * p["digits"]:
                    panel.plot([a, p["digits"]], [b, b], color=colour, linewidth=0.8, linestyle=":", zorder=1)
        panel.set_title(title, loc="left", fontsize=11, fontweight="bold")
        panel.grid(True, which="major", color="#DDDDDD", linewidth=0.6)
        panel.set_xlim(0.06, 3e6)
        panel.set_xticks([NONE, 1, 10, 100, 1e3, 1e4, 1e5, 1e6], ["none", "1", "10", "10²", "10³", "10⁴", "10⁵", "10⁶"])
        panel.xaxis.set_minor_locator(matplotlib.ticker.NullLocator())
        panel.yaxis.set_major_locator(matplotlib.ticker.LogLocator(numticks=12))
        panel.yaxis.set_major_formatter(seconds)
        panel.yaxis.set_minor_locator(matplotlib.ticker.NullLocator())
        panel.spines[["top", "right"]].set_visible(False)
    for panel in panels[-1]:
        panel.set_xlabel("digits that are right (measured)")
    for panel in panels[:, 0]:
        panel.set_ylabel("time of one call")
    handles = [
        Line2D([], [], color=colour, marker=marker, markersize=6, markeredgecolor=colour,
               markerfacecolor=colour if tool in ("Carom", "Arb") else "white",
               label=f"{tool} (certified)" if tool in ("Carom", "Arb") else tool)
        for tool, (colour, marker) in LOOK.items()
    ]
    figure.legend(handles=handles, loc="upper center", ncols=3, frameon=False, fontsize=10)
    figure.tight_layout(rect=(0, 0, 1, 0.935))
    figure.savefig(path, metadata={"Date": None})
    pyplot.close(figure)
