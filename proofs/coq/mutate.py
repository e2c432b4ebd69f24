#!/usr/bin/env python3
"""Changes statements one place at a time and tries the proofs on them again.

    proofs/coq/mutate.py FOLDER [--every N] [--module NAME]
    proofs/coq/mutate.py FOLDER --generated [--every N] [--module NAME]

FOLDER holds compiled copies of the Coq files. Each statement of statements.v is changed in its
conclusion or definitions (a relation, an operator, a number) or loses a hypothesis; its proof, read
from the file that holds it, is run on what results. Each theorem of claims.v is changed alike and
tried with its term. A changed statement that goes through is listed: it is true, as Coq has just
proved it. It must stand in survivors.txt with the reason, unless it lost a hypothesis that the proof
does not need, or says that a point exists (as the negation of a claim does). Exit code 1 otherwise.

With --generated FOLDER is one of `carom export coq --proofs`, compiled: each compiled theorem is held against its
changed statements, as the folder's `check` holds it against statements.v. It may pass for none but one that Coq
computes to be the same, as 2 / 1 and 2.
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


def sessions(module, header, jobs, originals):
    """Two sessions for each file, so that the work spreads over both cores; with the originals."""
    for part in (jobs[::2], jobs[1::2]):
        if part:
            names = dict.fromkeys(job[0] for job in part)
            yield module, header, [(name, UNCHANGED, *originals[name]) for name in names] + part


def generated(folder, every, only):
    """Holds each compiled theorem of a generated folder against changed statements; whether none passes."""
    defined = statements((folder / "statements.v").read_text(), "Definition")
    work, count = [], 0
    for line in (folder / "theorems.txt").read_text().splitlines():
        module, theorem, says = line.split(" ", 2)
        if not (folder / f"{module}.vo").exists() or (only and module != only):
            continue
        header = f"From Carom Require Import vocabulary.\nFrom Carom Require {module}."
        name = re.search(r"statements\.([\w']+)", says).group(1)
        body = defined[name] if says.startswith("statements.") else f"~ (\n{defined[name]})"
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
    parser.add_argument("--module", help="only the proofs of this file")
    parser.add_argument("--generated", action="store_true", help="FOLDER is one of generated proofs, compiled")
    args = parser.parse_args()
    if args.generated:
        return 0 if generated(args.folder, args.every, args.module) else 1
    here = Path(__file__).parent
    defined = statements((here / "statements.v").read_text(), "Definition")
    known = {}
    for line in (here / "survivors.txt").read_text().splitlines():
        if line.strip() and not line.startswith("#"):
            name, change, reason = [part.strip() for part in line.split("|")]
            known[name, change] = reason
    work, total, count = [], 0, 0

    def chosen(items):
        nonlocal count
        for item in items:
            count += 1
            if count % args.every == 0:
                yield item

    for path in sorted(here.glob("*.v")):
        text = path.read_text()
        proofs = re.findall(r"^Theorem (\w+) : statements\.\1\.\nProof\.(.*?)\bQed\.", text, re.S | re.M)
        if not proofs or (args.module and path.stem != args.module):
            continue
        header = "\n".join(re.findall(r"^From .*\.$", text, re.M))
        header += f"\nFrom Carom Require Import {path.stem}.\n"
        jobs = [(name, what, changed, script) for name, script in proofs if not name.endswith("_defined")
                for what, changed in chosen(mutants(defined[name]))]
        work += sessions(path.stem, header, jobs, {name: (defined[name], script) for name, script in proofs})
    if not args.module:
        text = (here / "claims.v").read_text()
        terms = dict(re.findall(r"Theorem (\w+) .*?Proof\. exact ([\w.]+)\. Qed\.", text, re.S))
        theorems = re.findall(r"^Theorem (\w+) :\s+(.*?)\.\nProof", text, re.S | re.M)
        header = "\n".join(re.findall(r"^From .*\.$", text, re.M))
        jobs = [("claims." + name, what, changed, f"exact {terms[name]}.") for name, body in theorems
                for what, changed in chosen(mutants("  " + body))]
        work += sessions("claims", header, jobs,
                         {"claims." + name: (body, f"exact {terms[name]}.") for name, body in theorems})
    bad = 0
    with ThreadPoolExecutor(2) as pool:
        for (module, _, jobs), alive in zip(work, pool.map(lambda w: run(args.folder, *w), work)):
            jobs = [job for job in jobs if job[1] != UNCHANGED]
            total += len(jobs)
            for name, what, _, _ in alive:
                reason = known.get((name, what))
                if reason is None and what.startswith("without "):
                    reason = "the proof does not need this hypothesis"
                if reason is None and defined.get(name, "").lstrip().startswith(("~", "exists")):
                    reason = "it says that a point exists, and the same point serves"
                bad += reason is None
                print(f"{name} | {what} | {reason or 'NOT EXPLAINED'}")
            print(f"-- {module}: {len(jobs)} changed statements, {len(alive)} go through", flush=True)
    print(f"{total} changed statements of {count}, {bad} go through without an explanation")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
