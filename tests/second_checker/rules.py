#!/usr/bin/env python3
"""Asks proofs/certificates/check.py for its verdict on every case of tests/rules and every example of the page about the
format, and compares it with what is expected.

    rules.py      exit code 1 if they differ
"""
import hashlib
import os
import sys

sys.dont_write_bytecode = True
ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
sys.path.insert(0, os.path.join(ROOT, "proofs", "certificates"))
import check  # noqa: E402


def cases(source):
    """("accepted", "refuted" or None, name, reason, claim, steps) of each case: see tests/all/kernel_rules.rs."""
    for section in source.split("== ")[1:]:
        head, rest = section.split("\n", 1)
        claim, steps = rest.split("--\n", 1)
        kind, name = head.split(" ", 1)
        name, _, reason = name.partition(": ")
        yield {"accept": "accepted", "refute": "refuted"}.get(kind), name, reason, 'claim t "t"\n' + claim, steps.rstrip() + "\n"


def verdict(claim, steps):
    try:
        claim = check.reading.File(claim).claim("t")
        shown, _ = check.stated(claim, steps.split("\n"))
        digest = hashlib.sha256(shown.text().encode()).hexdigest()
        _, refuted = check.check(claim, f"carom-certificate 2\nclaim t\nstatement sha256 {digest}\n{steps}qed\n", {})
    except (check.Refused, check.NotCovered) as why:
        return str(why)
    return "refuted" if refuted else "accepted"


def examples(page):
    """The examples on the page about the format, as cases."""
    for block in page.split("```certificate\n")[1:]:
        claim, steps = block.split("\n```", 1)[0].split("--\n", 1)
        yield "refuted" if steps.startswith("refutes") else "accepted", "example", "", 'claim t "t"\n' + claim, steps.rstrip() + "\n"


def main(folder, page):
    wrong = count = 0
    with open(page, encoding="utf-8") as stream:
        for expected, _, _, claim, steps in examples(stream.read()):
            count += 1
            found = verdict(claim, steps)
            if found != expected:
                wrong += 1
                print(f"example\n{steps}: {found}")
    for name in sorted(os.listdir(folder)):
        with open(os.path.join(folder, name), encoding="utf-8") as stream:
            for expected, case, reason, claim, steps in cases(stream.read()):
                count += 1
                found = verdict(claim, steps)
                if (found if found in ("accepted", "refuted") else None) != expected:
                    wrong += 1
                    print(f"{name}: {case}: expected {expected or reason}, found {found}")
    print(f"{count} cases, {wrong} wrong")
    return 1 if wrong or not count else 0


if __name__ == "__main__":
    sys.exit(main(os.path.join(ROOT, "tests", "rules"), os.path.join(ROOT, "docs", "certificates.md")))
