#!/usr/bin/env python3
"""Compares `carom eval --batch` with python-flint (Arb) at high precision on random scenes.

    python3 -m venv venv && venv/bin/pip install python-flint
    cargo build --release --locked
    venv/bin/python benches/oracle.py [--scenes 1000000] [--seed 1] [--best 0.05] [--carom PATH]

For every scene: the printed enclosures must contain Arb's value, the decimal must be within half a unit of its
last place, `helps` must be the sign of e - L_n (equality only where Arb cannot separate the two at 2000 bits), and
n* must be bracketed by the signs at n* and n* + 1. A finding is counted only where Arb's ball proves it; what
Arb leaves open (exact equality) is counted apart. Exit code 1 if anything is wrong.
"""
import argparse
import random
import subprocess
import sys
import tempfile
import time

from flint import arb, ctx, fmpq, fmpz


def rational(text):
    if "/" in text:
        p, q = text.split("/")
        return fmpq(fmpz(p), fmpz(q))
    mantissa, _, exponent = text.partition("e")
    whole, _, fraction = mantissa.partition(".")
    k = int(exponent or 0) - len(fraction)
    n = fmpz(whole + fraction)
    return fmpq(n * fmpz(10) ** k) if k >= 0 else fmpq(n, fmpz(10) ** -k)


def decimal(text):
    """A decimal as a ball: its value may have millions of digits."""
    mantissa, _, exponent = text.partition("e")
    whole, _, fraction = mantissa.partition(".")
    return arb(fmpz(whole + fraction)) * arb(10) ** fmpz(int(exponent or 0) - len(fraction))


def root(r, k):
    return arb(r).root(k) if k < 50 else (arb(r).log() / k).exp()


def bits_for(r, n):
    size = abs(int(fmpz(r.p).bit_length()) - int(fmpz(r.q).bit_length()))
    return 160 + 2 * n.bit_length() + min(size // (n + 1) + 1, 4000)


def threshold(r, n):
    # In halves, so that nothing grows beyond r.
    a, b = (1 + root(r, n + 1)) / 2, (1 + root(r, n)) / 2
    return 2 * a ** (n + 1) / b ** n - 1


def eta(r, e, n):
    t = root(r, n + 1)
    return (arb(1 + e) ** 2 * t / (1 + t) ** 2) ** (n + 1)


def scene(rng):
    kind = rng.random()
    n = rng.randint(1, 12) if kind < 0.6 else int(10 ** rng.uniform(0, 3)) if kind < 0.9 else int(10 ** rng.uniform(0, 9))
    shape = rng.random()
    if shape < 0.35:
        m1, m2 = str(rng.randint(1, 1000)), str(rng.randint(1, 1000))
    elif shape < 0.55:
        m1, m2 = f"{rng.randint(1, 10**6)}e{rng.randint(-300, 300)}", str(rng.randint(1, 1000))
    elif shape < 0.7:
        m1, m2 = f"{rng.randint(1, 10**9)}/{rng.randint(1, 10**9)}", f"0.{rng.randint(1, 10**6)}"
    elif shape < 0.85:
        k = n * (n + 1) if n < 8 and rng.random() < 0.5 else rng.randint(1, 12)
        m1, m2 = str(rng.randint(2, 7) ** k), str(rng.randint(1, 3) ** k)
    else:
        d = rng.randint(1, 18)
        m1, m2 = ("1." + "0" * d + str(rng.randint(1, 9))), "1"
    shape = rng.random()
    if shape < 0.05:
        e = rng.choice(["0", "1"])
    elif shape < 0.5:
        e = f"0.{rng.randint(0, 10**rng.randint(1, 16) - 1)}"
    elif shape < 0.7:
        q = rng.randint(1, 10**6)
        e = f"{rng.randint(0, q)}/{q}"
    elif shape < 0.8:
        e = "0." + "9" * rng.randint(1, 40)
    else:
        # A hair beside the threshold.
        r = rational(m1) / rational(m2)
        k = rng.randint(8, 30)
        ctx.prec = bits_for(r, n) + 4 * k
        l = threshold(r, n)
        value = (l * arb(10) ** k).floor().unique_fmpz()
        if value is None or value < 0:
            e = "1/2"
        else:
            value = min(max(value + rng.randint(-2, 3), fmpz(0)), fmpz(10) ** k)
            e = f"{value}/{fmpz(10) ** k}"
    return m1, m2, e, n


class Tally:
    def __init__(self):
        self.counts = {}
        self.wrong = []

    def add(self, name, ok, line):
        """ok: True right, None left open by Arb, False proved wrong."""
        right, open_, bad = self.counts.get(name, (0, 0, 0))
        self.counts[name] = (right + (ok is True), open_ + (ok is None), bad + (ok is False))
        if ok is False and len(self.wrong) < 20:
            self.wrong.append(f"{name}: {line}")


def within(lower, value, upper):
    if value < decimal(lower) or value > decimal(upper):
        return False
    return True if value >= decimal(lower) and value <= decimal(upper) else None


def rounded(text, value):
    mantissa, _, exponent = text.partition("e")
    places = len(mantissa.partition(".")[2]) - int(exponent or 0)
    half = decimal(f"5e{-places - 1}")
    gap = abs(value - decimal(text))
    return False if gap > half else True if gap <= half else None


def sign(r, e, n):
    for extra in (0, 256, 2000):
        ctx.prec = bits_for(r, n) + extra
        gap = arb(e) - threshold(r, n)
        if gap > 0:
            return "yes"
        if gap < 0:
            return "no"
    return "exactly on the threshold"


def check(fields, with_best, tally):
    line = ",".join(fields)
    r, e, n = rational(fields[0]) / rational(fields[1]), rational(fields[2]), int(fields[3])
    ctx.prec = bits_for(r, n)
    value = eta(r, e, n)
    tally.add("eta enclosure", within(fields[5], value, fields[6]), line)
    tally.add("eta decimal", rounded(fields[4], value), line)
    value = threshold(r, n)
    tally.add("L_n enclosure", within(fields[8], value, fields[9]), line)
    tally.add("L_n decimal", rounded(fields[7], value), line)
    tally.add("helps", fields[10] == sign(r, e, n), line)
    if not with_best:
        return
    best, tie = fields[11], fields[12]
    if best in ("infinite", "any"):
        tally.add("best-n", e == 1 and (r == 1) == (best == "any"), line)
        return
    best = int(best)
    here = "yes" if best == 0 else sign(r, e, best)
    good = sign(r, e, best + 1) == "no" and here == ("exactly on the threshold" if tie == "true" else "yes")
    tally.add("best-n", good, line)


def run(carom, scenes, with_best, tally):
    want = "eta,threshold,helps" + (",best-n" if with_best else "")
    with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
        for s in scenes:
            file.write(",".join(map(str, s)) + "\n")
        file.flush()
        started = time.time()
        out = subprocess.run([carom, "eval", "--batch", file.name, "--want", want], capture_output=True, text=True)
        spent = time.time() - started
    if out.returncode != 0:
        sys.exit(f"carom failed: {out.stderr}")
    lines = out.stdout.splitlines()[1:]
    if len(lines) != len(scenes):
        sys.exit(f"{len(lines)} answers to {len(scenes)} scenes")
    for line in lines:
        check(line.split(","), with_best, tally)
    return spent


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--scenes", type=int, default=1_000_000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--best", type=float, default=0.05, help="share of scenes for which n* is asked as well")
    parser.add_argument("--carom", default="target/release/carom")
    a = parser.parse_args()
    rng = random.Random(a.seed)
    tally = Tally()
    spent, done = 0.0, 0
    while done < a.scenes:
        size = min(20_000, a.scenes - done)
        scenes = [scene(rng) for _ in range(size)]
        cut = int(size * a.best)
        spent += run(a.carom, scenes[:cut], True, tally) if cut else 0.0
        spent += run(a.carom, scenes[cut:], False, tally)
        done += size
        print(f"\r{done} scenes", end="", file=sys.stderr, flush=True)
    print(f"\nseed {a.seed}: {done} scenes, {spent:.1f} s in carom")
    for name, (right, open_, bad) in tally.counts.items():
        print(f"  {name:<14} {right:>9} right  {open_:>7} left open by Arb (equality)  {bad} wrong")
    for line in tally.wrong:
        print("WRONG", line)
    sys.exit(1 if tally.wrong else 0)


if __name__ == "__main__":
    main()
