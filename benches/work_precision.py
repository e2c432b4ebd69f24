#!/usr/bin/env python3
"""Draws docs/work-precision.svg from docs/work-precision.csv: run time against relative error, both logarithmic.

    cargo bench --bench work_precision > docs/work-precision.csv && python3 benches/work_precision.py
"""
import csv
import math
import pathlib

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "docs"
WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 860, 520, 80, 250, 50, 64
# Okabe and Ito: tells apart for colour-blind eyes and in grey.
COLOURS = {"eta": "#0072b2", "L_n": "#d55e00"}
SHAPES = {"printed formula in f64": "cross", "t-form in f64": "plus", "doubles certified": "square", "intervals": "dot"}


def mark(shape, x, y, colour):
    if shape == "dot":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" fill="{colour}"/>'
    if shape == "square":
        return f'<rect x="{x - 4:.1f}" y="{y - 4:.1f}" width="8" height="8" fill="{colour}"/>'
    if shape == "plus":
        return f'<path d="M{x - 5:.1f} {y:.1f}h10M{x:.1f} {y - 5:.1f}v10" stroke="{colour}" stroke-width="2"/>'
    return f'<path d="M{x - 4:.1f} {y - 4:.1f}l8 8m0 -8l-8 8" stroke="{colour}" stroke-width="2"/>'


def text(x, y, words, extra=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" {extra}>{words}</text>'


def main():
    with open(FOLDER / "work-precision.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    points = [
        (r["quantity"], r["method"], -float(r["log2_relative_error"]) * math.log10(2), float(r["seconds"]))
        for r in rows
        if r["quantity"] in COLOURS and r["method"] in SHAPES
    ]
    exact = {r["quantity"]: float(r["seconds"]) for r in rows if r["method"] == "exact"}
    # The horizontal axis is the logarithm of the number of right digits: errors from 1e-15 to 1e-301030.
    low, high = 1.0, math.log10(max(p[2] for p in points)) + 0.1
    bottom = math.floor(math.log10(min(p[3] for p in points)))
    top = math.ceil(math.log10(max(p[3] for p in points)))
    across, down = WIDTH - LEFT - RIGHT, HEIGHT - TOP - BOTTOM

    def place(digits, seconds):
        x = LEFT + (math.log10(digits) - low) / (high - low) * across
        return x, TOP + (top - math.log10(seconds)) / (top - bottom) * down

    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" '
        'font-family="sans-serif" font-size="13" fill="#222">',
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>',
        text(LEFT, 28, "Time for one value against its relative error: m1 : m2 = 10, e = 9/10, n = 7", 'font-size="15"'),
    ]
    for k in range(bottom, top + 1):
        _, y = place(10, 10.0**k)
        label = {0: "1 s", -3: "1 ms", -6: "1 µs", -9: "1 ns"}.get(k, "")
        out.append(f'<path d="M{LEFT} {y:.1f}h{across}" stroke="#ddd"/>' + text(LEFT - 8, y + 4, label, 'text-anchor="end"'))
    for digits in (10, 100, 1_000, 10_000, 100_000):
        x, _ = place(digits, 1)
        out.append(f'<path d="M{x:.1f} {TOP}v{down}" stroke="#ddd"/>')
        out.append(text(x, HEIGHT - BOTTOM + 22, f"1e−{digits}", 'text-anchor="middle"'))
    out.append(text(LEFT + across / 2, HEIGHT - 14, "relative error (logarithmic in the number of right digits)", 'text-anchor="middle"'))
    out.append(text(0, 0, "seconds", f'text-anchor="middle" transform="translate(20 {TOP + down / 2}) rotate(-90)"'))
    for quantity, colour in COLOURS.items():
        line = sorted((p[2], p[3]) for p in points if p[0] == quantity and p[1] == "intervals")
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in (place(*p) for p in line))
        out.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.5"/>')
        if quantity in exact:
            _, y = place(10, exact[quantity])
            out.append(f'<path d="M{LEFT} {y:.1f}h{across}" stroke="{colour}" stroke-dasharray="5 4"/>')
    for quantity, method, digits, seconds in points:
        out.append(mark(SHAPES[method], *place(digits, seconds), COLOURS[quantity]))
    y = TOP + 10
    for quantity, colour in COLOURS.items():
        for method, shape in SHAPES.items():
            if any(p[:2] == (quantity, method) for p in points):
                label = "double-double, certified" if shape == "square" else method
                out.append(mark(shape, WIDTH - RIGHT + 24, y - 4, colour) + text(WIDTH - RIGHT + 38, y, f"{quantity}: {label}"))
                y += 22
        if quantity in exact:
            x = WIDTH - RIGHT + 14
            dash = f'<path d="M{x} {y - 4}h20" stroke="{colour}" stroke-dasharray="5 4"/>'
            out.append(dash + text(x + 24, y, f"{quantity}: exact, 2^56 : 1"))
            y += 22
        y += 8
    out.append("</svg>\n")
    (FOLDER / "work-precision.svg").write_text("\n".join(out))


if __name__ == "__main__":
    main()
