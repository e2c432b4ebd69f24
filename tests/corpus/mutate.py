#!/usr/bin/env python3
"""Lets Carom judge changed statements of this folder, and judges its verdicts by evaluation (check.py).

    cargo build --release --locked
    python3 tests/corpus/mutate.py [--each 6] [--seed 1] [--carom target/release/carom] [FILE ...]

A change removes a hypothesis, frees a variable from its domain, turns a relation or a sign round, or moves a number by
one; nobody knows whether what results is true. Wrong is: a claim that is proved and fails at a point at which its
hypotheses hold; a claim that is refuted and holds at its witness, or whose hypotheses do not hold there; hypotheses
that are said to contradict each other and hold at a point. Each wrong one is printed. Exit code 0 if there is none.
"""
import argparse
import collections
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile

import mpmath

import check

RELATIONS = {">=": "<=", "<=": ">=", ">": "<", "<": ">", "=": ">="}


def changed(text, rng):
    """The claim with one change, or None where the change does not fit."""
    lines = text.splitlines()
    places = [i for i, line in enumerate(lines) if line.startswith(("given", "assume", "prove", "  "))]
    i = rng.choice(places)
    line, kind = lines[i], rng.randrange(5)
    if kind == 0 and line.startswith("assume"):
        return "\n".join(lines[:i] + lines[i + 1 :])
    if kind == 1 and line.startswith("given"):
        lines[i] = re.sub(r"((?:\w+(?:\(k\))?, )*\w+(?:\(k\))?) (>=?|<=?|in) [^;]+", r"\1 real", line, count=1)
    elif kind == 2 and not line.startswith("given"):
        found = list(re.finditer(r" (>=|<=|>|<|=) ", line))
        if found:
            m = rng.choice(found)
            lines[i] = line[: m.start(1)] + RELATIONS[m[1]] + line[m.end(1) :]
    elif kind == 3:
        found = list(re.finditer(r" ([+-]) ", line))
        if found:
            m = rng.choice(found)
            lines[i] = line[: m.start(1)] + {"+": "-", "-": "+"}[m[1]] + line[m.end(1) :]
    else:
        found = list(re.finditer(r"(?<![\w.])\d+(?![\w.])", line))
        if found:
            m = rng.choice(found)
            lines[i] = line[: m.start()] + str(int(m[0]) + rng.choice([-1, 1])).replace("-1", "(-1)") + line[m.end() :]
    return "\n".join(lines) if lines[i] != line else None


def mutants(paths, each, rng):
    for path in paths:
        for text in re.split(r"^(?=claim )", path.read_text(), flags=re.M)[1:]:
            text = re.sub(r"^(#.*|expect .*|\s*)\n", "", text, flags=re.M).rstrip()
            found = {changed(text, rng) for _ in range(each)} - {None}
            for number, mutant in enumerate(sorted(found)):
                name = f"{text.split()[1]}-{number}"
                yield name, re.sub(r"^claim \S+", f"claim {name}", mutant)


def judged(carom, list_of_claims):
    """The verdict and the witness by name; claims that Carom does not read are left out."""
    with tempfile.TemporaryDirectory() as folder:
        while list_of_claims:
            path = pathlib.Path(folder) / "mutants.claim"
            path.write_text("\n\n".join(text for _, text in list_of_claims) + "\n")
            command = [carom, "audit", "--format", "json", "--time", "1", "--max-steps", "20000", str(path)]
            run = subprocess.run(command, capture_output=True, text=True)
            if run.stdout:
                break
            # Claims with a fault are found one by one.
            list_of_claims = [claim for claim in list_of_claims if readable(carom, claim[1], path)]
    if not list_of_claims:
        return {}
    report = json.loads(run.stdout)
    verdicts = {c["id"]: (c["verdict"], c["witness"]) for c in report["claims"]}
    for error in report["errors"]:
        if "contradict each other" in error["message"]:
            verdicts[error["claim"]] = ("contradictory", None)
    return verdicts


def readable(carom, text, path):
    path.write_text(text + "\n")
    return subprocess.run([carom, "print", str(path)], capture_output=True).returncode == 0


def as_written(claim, witness):
    """A witness in the claim's own words: angles by their cosines and sines, within their bounds; floors are left out."""
    own = {n: v for n, v in witness.items() if not re.match(r"(cos|sin)_|floor_\d+_(up|down)$", n)}
    domains = {name: domain for name, _, domain in claim.domains}
    for name in [n[4:] for n in witness if n.startswith("cos_")]:
        cosine, sine = (check.value(check.Parser(witness[f"{f}_{name}"]).sum(), {}) for f in ("cos", "sin"))
        angle, _, over = name.partition("_over_")
        over = int(over or 1)
        if angle not in domains:
            continue
        turns = [over * (mpmath.atan2(sine, cosine) + 2 * mpmath.pi * k) for k in (0, 1, -1, 2, -2)]
        within = [t for t in turns if check.inside(domains[angle], t, {})]
        own[angle] = mpmath.nstr((within or turns)[0], 60)
    return own


def fault(text, verdict, witness):
    """What is wrong with a verdict, or None."""
    try:
        claim = check.Claim(text)
    except SyntaxError:
        return None
    if claim.open:
        return None
    rng = random.Random(claim.name)
    if verdict == "proved":
        found = claim.counterexample(300)
        return found and f"proved, and fails at {found}"
    if verdict == "refuted" and witness and all(re.fullmatch(r"-?\d+(/\d+)?", v) for v in witness.values()):
        is_of_angles = any(n.startswith("cos_") for n in witness)
        witness = as_written(claim, witness)
        try:
            env = claim.start(rng, witness)
        except (AssertionError, check.Undefined):
            return f"refuted at {witness}, which is outside its domains"
        try:
            if not claim.allowed(env, rng):
                # Angles without bounds may be told up to whole turns only.
                if is_of_angles and claim.assumed:
                    return None
                return f"refuted at {witness}, where its hypotheses do not hold"
            if claim.goal[0] not in ("limit", "exists", "all", "maximum", "minimum") and claim.holds(env, rng):
                return f"refuted at {witness}, where it holds"
        except (check.Undefined, KeyError, TypeError):
            return None
    if verdict == "contradictory":
        found = claim.sample(300)
        return found and f"its hypotheses are said to contradict each other, and hold at {found}"
    return None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--each", type=int, default=6, help="changes tried of each claim")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--carom", default="target/release/carom")
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    a = parser.parse_args()
    folder = pathlib.Path(__file__).parent
    made = list(mutants(a.files or sorted(folder.glob("*.claim")), a.each, random.Random(a.seed)))
    verdicts = judged(a.carom, made)
    counts, wrong = collections.Counter(v for v, _ in verdicts.values()), 0
    for name, text in made:
        found = name in verdicts and fault(text, *verdicts[name])
        if found:
            wrong += 1
            print(f"# WRONG: {found}\n{text}\n", flush=True)
    print(f"seed {a.seed}: {len(made)} changed claims, " + ", ".join(f"{n} {v}" for v, n in sorted(counts.items())) + f", {wrong} wrong")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
