#!/usr/bin/env python3
"""Holds proofs that are made from changed certificates against the statements: none may prove another one.

    proofs/coq/changed_certificates.py CLAIMS FOLDER [--each N] [--seed S]

Makes certificates of the file CLAIMS, changes each in N ways (8) at one place, drawn by a fixed seed (16), and exports
proofs with the changed ones at hand. What the program states must be the same, letter by letter. Where the kernel takes
a changed certificate, Coq is asked whether its proof shows the statement of the claim; it may refuse, and nothing else.
FOLDER has to be new. CAROM=PATH takes a program that is built already.
"""
import argparse
import os
import random
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = [os.environ["CAROM"]] if os.environ.get("CAROM") else \
    ["cargo", "run", "--quiet", "--locked", "--manifest-path", str(ROOT / "Cargo.toml"), "--"]
SIGNS = {"+": "-", "-": "+", "*": "/", "/": "*", ">": "<", "<": ">", ">=": "<=", "<=": ">=", "=": "<=", "!=": "="}
# Numbers, labels, signs and rules of a step.
TOKEN = re.compile(r"\d+(?:[a-z]\d*)*|[<>!]=|[-+*/<>=]|\bh\d+\b|\b(?:combination|power|logic|instance|suppose|let)\b")
PAIRS = [("combination", "power"), ("logic", "instance"), ("suppose", "let")]
RULES = {a: b for pair in PAIRS for a, b in (pair, pair[::-1])}


def run(*words):
    done = subprocess.run([*PROGRAM, *map(str, words)], text=True, capture_output=True)
    # 1: a claim is refuted or undecided.
    if done.returncode not in (0, 1):
        sys.exit(done.stderr)


def changed(text, draw):
    """The certificate with one change in its steps."""
    head = re.match(r"(?:.*\n){3}", text).end()
    kind = draw.randrange(4)
    lines = text[head:].splitlines(keepends=True)
    at = draw.randrange(max(1, len(lines) - 1))
    if kind == 0:
        return text[:head] + "".join(lines[:at] + lines[at + 1:])
    if kind == 1:
        other = draw.randrange(max(1, len(lines) - 1))
        lines[at], lines[other] = lines[other], lines[at]
        return text[:head] + "".join(lines)
    places = list(TOKEN.finditer(text, head))
    if not places:
        return text
    place = draw.choice(places)
    word = place.group()
    put = SIGNS.get(word) or RULES.get(word) or (str(int(word) + 1) if word.isdigit() else draw.choice(places).group())
    return text[:place.start()] + put + text[place.end():]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("claims", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--each", type=int, default=8)
    parser.add_argument("--seed", type=int, default=16)
    args = parser.parse_args()
    draw = random.Random(args.seed)
    args.folder.mkdir(parents=True)
    claims = args.folder / "all.claim"
    shutil.copy(args.claims, claims)
    good = args.folder / "good"
    run("audit", claims, "--certificates", good)
    kept = args.folder / "kept"
    run("export", "coq", "--proofs", "--output", kept, "--from", claims)
    stated = (kept / "statements.v").read_text()
    names = [line.split()[0] for line in (kept / "order.txt").read_text().splitlines()]
    texts = {name: {(kept / f"{name}.v").read_text()} for name in names}
    tried, more = 0, []
    for number in range(args.each):
        beside, made = args.folder / "certificates", args.folder / "made"
        beside.mkdir()
        for path in sorted(good.glob("*.cert")):
            text = path.read_text()
            mutant = changed(text, draw)
            tried += mutant != text
            (beside / path.name).write_text(mutant)
        run("export", "coq", "--proofs", "--output", made, "--from", claims)
        if (made / "statements.v").read_text() != stated:
            sys.exit("a changed certificate changed what is stated")
        for name in names:
            text = (made / f"{name}.v").read_text()
            if text in texts[name]:
                continue
            texts[name].add(text)
            # The same theorem from other steps, in a file of its own.
            module = f"{name}_c{number}"
            (kept / f"{module}.v").write_text(re.sub(r"^Theorem (\w+) :", rf"Theorem \1_c{number} :", text, flags=re.M))
            more.append((module, name, number))
        shutil.rmtree(beside)
        shutil.rmtree(made)
    order = dict(line.partition(" ")[::2] for line in (kept / "order.txt").read_text().splitlines())
    said = [line.split(" ", 2) for line in (kept / "theorems.txt").read_text().splitlines()]
    (kept / "order.txt").write_text("".join(f"{module} {order[name]}\n" for module, name, _ in more))
    (kept / "theorems.txt").write_text("".join(
        f"{module} {theorem}_c{number} {says}\n"
        for module, name, number in more for own, theorem, says in said if own == name))
    if not more:
        sys.exit("the kernel took no changed certificate: nothing was shown")
    done = subprocess.run(["bash", str(kept / "check")], text=True, capture_output=True)
    accepted = len(re.findall(r"^accepted ", done.stdout, re.M))
    theorems = len(re.findall(r"^theorem ", done.stdout, re.M))
    if "error:" in done.stderr or theorems < accepted:
        sys.exit(done.stdout + done.stderr)
    print(f"{tried} changed certificates; the kernel takes other steps in {len(more)} proofs, of which Coq accepts "
          f"{accepted}, each for the statement of its claim")
    return 0


if __name__ == "__main__":
    sys.exit(main())
