#!/usr/bin/env python3
"""Holds compiled theorems against changed statements: none may pass for another statement than its own.

    proofs/coq/mutate.py FOLDER [--every N] [--module NAME]

FOLDER is one of `carom export coq --proofs`, compiled. Each statement of its theorems is changed one place at a time in
its conclusion or definitions (a relation, an operator, a number) or loses a hypothesis, and the theorem is given as the
proof of what results. It may pass for none but one that Coq computes to be the same, as 2 / 1 and 2. Where the folder
holds further.v, compiled, the theorems that claims.v has from there are changed alike. Exit code 1 if one passes.
"""
import argparse
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

RELATIONS = {"=": "<>", "<>": "=", "<=": ">", "<": ">=", ">=": "<", ">": "<="}
UNCHANGED = "unchanged"
OPERATORS = {"+": "-", "-": "+", "*": "/"}
TOKEN = re.compile(r"\s+|[A-Za-z_][\w']*(?:\.\w+)*|\d+|<->|->|=>|:=|<=|>=|<>|/\\|\\/|%nat|.", re.S)


def conclusion_places(text):
    """Places of tokens in lines that are no hypotheses."""
    lines, at, places = text.split("\n"), 0, []
    for line in lines:
        premise = line.rstrip().endswith("->") or line.lstrip().startswith("forall")
        for m in TOKEN.finditer(line):
            if not premise:
                places.append((at + m.start(), m.group()))
        at += len(line) + 1
    return places


def mutants(text):
    """(what was changed, the changed text), in order."""
    places = conclusion_places(text)
    for i, (at, token) in enumerate(places):
        before = next((t for _, t in reversed(places[:i]) if not t.isspace()), "(")
        binary = before not in ("(", "[", ";", "=", "<=", ">=", "<", ">", "*", "/", ":=", "=>", "~", ",")
        put = None
        if token in RELATIONS:
            put = RELATIONS[token]
        elif token in OPERATORS and binary:
            put = OPERATORS[token]
        elif token.isdigit():
            put = str(int(token) + 1)
        if put is not None:
            line = text.count("\n", 0, at) + 1
            yield f"line {line}: {token} to {put} at {at}", text[:at] + put + text[at + len(token):]
    at = 0
    for line in text.split("\n"):
        if line.rstrip().endswith("->"):
            start = line.index("),") + 2 if line.lstrip().startswith("forall (") and ")," in line else 0
            pieces = re.split(r"(?<= ->)", line[start:])
            depth, part, offset = 0, "", start
            for piece in pieces:
                part += piece
                depth += piece.count("(") - piece.count(")")
                if depth == 0 and part.strip().endswith("->"):
                    s = at + offset
                    yield f"without {part.strip()[:-2].strip()}", text[:s] + text[s + len(part):]
                    offset, part = offset + len(part), ""
        at += len(line) + 1


def statements(text, opening):
    return dict(re.findall(opening + r" (\w+)(?: : Prop)? :=?\n(.*?)\.\n(?=Proof|\n|$)", text, re.S))


def run(folder, module, header, jobs):
    """The jobs whose proof goes through."""
    # Loading takes as long as it takes; a step of a proof does not.
    source = [header, "Set Default Timeout 60."]
    for number, (_, _, text, script) in enumerate(jobs):
        source.append(f"Definition m_{number} : Prop :=\n{text}.\nGoal m_{number}.\n{script}\nSave s_{number}.\n"
                      f"Abort.\nCheck s_{number}.")
    session = subprocess.run(["coqtop", "-w", "none", "-q", "-color", "off", "-Q", ".", "Carom"], cwd=folder, text=True,
                         input="\n".join(source) + "\nQuit.\n", stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    if session.returncode < 0:
        sys.exit(f"{module}: the session was ended by signal {-session.returncode}, perhaps for want of memory")
    out = session.stdout
    done = {int(n) for n in re.findall(r"s_(\d+)\s*:\s*m_\1\b", out)}
    # The statements as they are must go through, or the session shows nothing.
    for number, (name, what, _, _) in enumerate(jobs):
        if what == UNCHANGED and number not in done:
            sys.exit(f"{module}: {name} is not proved in the session as it stands")
    return [jobs[n] for n in sorted(done) if jobs[n][1] != UNCHANGED]


def theorems(folder):
    """The compiled theorems of a folder: module, name, statement."""
    defined = statements((folder / "statements.v").read_text(), "Definition")
    for line in (folder / "theorems.txt").read_text().splitlines():
        module, theorem, says = line.split(" ", 2)
        name = re.search(r"statements\.([\w']+)", says).group(1)
        yield module, theorem, defined[name] if says.startswith("statements.") else f"~ (\n{defined[name]})"
    if (folder / "further.vo").exists():
        text = (folder / "claims.v").read_text()
        for name, body in re.findall(r"^Theorem (\w+) : (.*?)\.\nProof\. exact further\.\1\. Qed\.", text, re.S | re.M):
            yield "further", name, "  " + body


def held(folder, every, only):
    """Holds each compiled theorem of a folder against changed statements; whether none passes."""
    work, count = [], 0
    for module, theorem, body in theorems(folder):
        if not (folder / f"{module}.vo").exists() or (only and module != only):
            continue
        header = f"From Carom Require Import vocabulary.\nFrom Carom Require {module}."
        script = f"exact {module}.{theorem}."
        jobs = []
        for what, changed in mutants(body):
            count += 1
            if count % every == 0:
                jobs.append((theorem, what, changed, script))
        if jobs:
            work.append((module, header, [(theorem, UNCHANGED, body, script)] + jobs))
    tried, passed = 0, 0
    with ThreadPoolExecutor(2) as pool:
        for (module, _, jobs), alive in zip(work, pool.map(lambda w: run(folder, *w), work)):
            tried += len(jobs) - 1
            passed += len(alive)
            for name, what, _, _ in alive:
                print(f"{name} | {what} | THE THEOREM PASSES FOR IT")
    print(f"{len(work)} theorems held against {tried} changed statements of {count}: {passed} pass")
    return passed == 0 and tried > 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--every", type=int, default=1, help="try every N-th change only")
    parser.add_argument("--module", help="only the theorems of this file")
    args = parser.parse_args()
    return 0 if held(args.folder, args.every, args.module) else 1


if __name__ == "__main__":
    sys.exit(main())
