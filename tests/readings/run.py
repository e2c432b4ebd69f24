#!/usr/bin/env python3
"""Lets `carom audit` judge random claims, and compares its verdicts with an evaluation of the claims as written.

    pip install mpmath
    python3 tests/readings/run.py CAROM [--verdicts 10000] [--seed 1]
    python3 tests/readings/run.py CAROM --files FILE ...

Prints every wrong verdict with the text of its claim, then a table by kind. Exit code 0 if none is wrong, 1 if one is,
2 if there are too few verdicts or too few that could be evaluated. The same seed gives the same claims.
"""

import argparse
import collections
import functools
import itertools
import json
import multiprocessing
import pathlib
import re
import subprocess
import sys
import tempfile
import time

import generate
from compare import compare

BATCH = 100
# Seconds and steps that Carom may take for a claim: what it does not decide soon is of no use here.
TIME, STEPS = 1, 4_000
# The least part of the verdicts that the evaluator has to judge.
LEAST = 0.8
COLUMNS = ("claims", "proved", "refuted", "contradictory", "undecided", "refused", "evaluated", "wrong")


def judged(carom, texts):
    """The verdict and the counterexample of each claim. Each has its own file: one that is refused hides no other."""
    with tempfile.TemporaryDirectory() as folder:
        for i, text in enumerate(texts):
            named = re.sub(r"(?m)^claim \S+", f"claim c{i}", text, count=1)
            pathlib.Path(folder, f"c{i}.claim").write_text(named, encoding="utf-8")
        command = [carom, "audit", "--format", "json", "--time", str(TIME), "--max-steps", str(STEPS), folder]
        done = subprocess.run(command, capture_output=True, text=True, encoding="utf-8")
    try:
        report = json.loads(done.stdout)
    except ValueError:
        raise RuntimeError(f"{carom} audit gave no report: {done.stderr[:2000]}") from None
    out = [("refused", None)] * len(texts)
    for entry in report["claims"]:
        out[int(entry["id"][1:])] = entry["verdict"], entry["witness"]
    for error in report["errors"]:
        if "contradict each other" in error["message"]:
            out[int(re.search(r"c(\d+)(?:\.claim)?$", error["claim"]).group(1))] = "contradictory", None
    return out


def batch(carom, seed, first):
    """The rows of the claims from a number on: kind, text, verdict, comparison or None."""
    known = generate.known_claims()
    claims = [generate.claim(seed, i, known) for i in range(first, first + BATCH)]
    return rows(carom, claims, seed)


def rows(carom, claims, seed):
    out = []
    for (kind, text), (verdict, witness) in zip(claims, judged(carom, [text for _, text in claims])):
        decided = verdict in ("proved", "refuted", "contradictory")
        out.append((kind, text, verdict, compare(text, verdict, witness, seed) if decided else None))
    return out


def blind_spots():
    """The known claims for which a wrong verdict would not be noticed, or a right one would be called wrong."""
    for folder, name in itertools.product(("deceptions", "truths"), ("readings.claim", "arcs.claim")):
        for text in generate.claims_of(generate.TESTS / folder / name):
            is_true = folder != "deceptions" or text.startswith("claim true")
            wrong, right = ("refuted", "proved") if is_true else ("proved", "refuted")
            if not compare(text, wrong, None, 1).fault:
                yield f"the verdict {wrong} is not noticed as wrong", text
            fault = compare(text, right, None, 1).fault
            if fault and "promises undecided" not in fault:
                yield f"the verdict {right} is called wrong: {fault}", text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("carom", help="the program")
    parser.add_argument("--verdicts", type=int, default=10_000, help="how many verdicts to compare [default: 10000]")
    parser.add_argument("--seed", type=int, default=1, help="[default: 1]")
    parser.add_argument("--files", nargs="+", help="compare the claims of these files instead")
    asked = parser.parse_args()
    for fault, text in blind_spots():
        parser.error(f"the evaluator fails on a known claim: {fault}\n{text}")
    start = time.monotonic()
    counts = collections.defaultdict(collections.Counter)

    def count(found):
        for kind, text, verdict, comparison in found:
            counts[kind].update(("claims", verdict))
            if comparison:
                counts[kind]["evaluated"] += comparison.evaluated
                counts[kind]["verdicts"] += 1
                if comparison.fault:
                    counts[kind]["wrong"] += 1
                    print(f"WRONG: {comparison.fault}\n{text}", flush=True)

    if asked.files:
        claims = [(pathlib.Path(path).name, text) for path in asked.files for text in generate.claims_of(path)]
        count(rows(asked.carom, claims, asked.seed))
    else:
        with multiprocessing.Pool() as pool:
            # Batches are counted in their order, so that the same seed compares the same claims.
            work = functools.partial(batch, asked.carom, asked.seed)
            for found in pool.imap(work, batches(asked.verdicts)):
                count(found)
                if sum(c["verdicts"] for c in counts.values()) >= asked.verdicts:
                    pool.terminate()
                    break
    total = report(counts, time.monotonic() - start)
    if total["wrong"]:
        return 1
    if not asked.files and (total["verdicts"] < asked.verdicts or total["evaluated"] < LEAST * total["verdicts"]):
        print("too few verdicts, or too few that the evaluator can judge: this run shows nothing")
        return 2
    return 0


def batches(verdicts):
    """The first numbers of batches, at least as many as could be needed."""
    return range(0, 8 * verdicts + 8 * BATCH, BATCH)


def report(counts, seconds):
    """Prints the table, and returns its last line."""
    print(f"{'kind':34}" + "".join(f"{column:>14}" for column in COLUMNS))
    total = collections.Counter()
    for kind, count in sorted(counts.items()):
        total += count
        print(f"{kind:34}" + "".join(f"{count[column]:14}" for column in COLUMNS))
    print(f"{'all':34}" + "".join(f"{total[column]:14}" for column in COLUMNS))
    summary = f"{total['verdicts']} verdicts, {total['evaluated']} of them evaluated, {total['wrong']} wrong"
    print(f"\n{summary}; {seconds:.0f} s")
    return total


if __name__ == "__main__":
    try:
        sys.exit(main())
    except RuntimeError as fault:
        print(fault, file=sys.stderr)
        sys.exit(2)
