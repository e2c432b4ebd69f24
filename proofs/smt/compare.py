#!/usr/bin/env python3
"""A third opinion: asks Z3 and cvc5 about the claims that fit QF_NRA, and compares verdicts.

    pip install z3-solver cvc5
    cargo build --release --locked
    python3 proofs/smt/compare.py [--carom PATH] [--seconds N] [ID ...]

`carom export smt2 ID` asserts the hypotheses and the negation of the claim: *unsat* is proved, *sat*
refuted. An answer that contradicts the expected one ends with exit code 1; *unknown* (the time is up)
contradicts nothing.
"""
import argparse
import re
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

SOLVERS = {
    "z3": """
import sys, z3
s = z3.Solver()
s.from_string(sys.stdin.read())
s.set("timeout", int(1000 * float(sys.argv[1])))
print(s.check())
""",
    "cvc5": """
import sys, cvc5
solver = cvc5.Solver()
solver.setOption("tlimit-per", str(int(1000 * float(sys.argv[1]))))
solver.setOption("nl-cov", "true")
parser = cvc5.InputParser(solver)
parser.setStringInput(cvc5.InputLanguage.SMT_LIB_2_6, sys.stdin.read(), "claim")
symbols = parser.getSymbolManager()
while True:
    command = parser.nextCommand()
    if command.isNull():
        break
    out = command.invoke(solver, symbols)
    if out.strip():
        print(out.strip())
""",
}


def ask(solver, script, seconds):
    started = time.time()
    try:
        done = subprocess.run([sys.executable, "-c", SOLVERS[solver], str(seconds)], input=script, text=True,
                              capture_output=True, timeout=seconds + 10)
        said = (done.stdout.split() or ["nothing"])[-1].strip("()").lower()
        errors = done.stderr.strip().splitlines() or ["no answer"]
        answer = {"sat": "sat", "unsat": "unsat", "unknown": "unknown", "timeout": "unknown"}.get(said, errors[-1])
    except subprocess.TimeoutExpired:
        answer = "unknown"
    return answer, time.time() - started


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--carom", default="target/release/carom")
    parser.add_argument("--seconds", type=float, default=10)
    parser.add_argument("ids", nargs="*")
    args = parser.parse_args()
    listed = subprocess.run([args.carom, "export", "smt2", "--list"], text=True, capture_output=True, check=True).stdout
    every = [line.split(":")[0] for line in listed.splitlines() if line.endswith(": yes")]
    names = args.ids or every
    work = []
    for name in names:
        script = subprocess.run([args.carom, "export", "smt2", name], text=True, capture_output=True, check=True).stdout
        work.append((name, script, re.search(r":status (\w+)", script).group(1)))
    pairs = [(name, script, expected, solver) for name, script, expected in work for solver in SOLVERS]
    with ThreadPoolExecutor(2) as pool:
        answers = list(pool.map(lambda p: ask(p[3], p[1], args.seconds), pairs))
    bad, unknown = 0, 0
    print("| claim | expected | " + " | ".join(SOLVERS) + " |\n|---|---|" + "---|" * len(SOLVERS))
    for name, _, expected in work:
        row = [(a, t) for (n, _, _, _), (a, t) in zip(pairs, answers) if n == name]
        for answer, _ in row:
            bad += answer not in (expected, "unknown")
            unknown += answer == "unknown"
        print(f"| {name} | {expected} | " + " | ".join(f"{a} ({t:.1f} s)" for a, t in row) + " |")
    print(f"\n{len(every)} of {len(listed.splitlines())} claims fit QF_NRA; {len(pairs)} answers, "
          f"{unknown} unknown, {bad} that contradict")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
