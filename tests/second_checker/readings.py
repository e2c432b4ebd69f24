#!/usr/bin/env python3
"""Asks proofs/certificates/check.py for its verdict on claims as their authors write them, and on changes of these.

    readings.py      exit code 1 if a verdict is another than expected

readings.txt has a section for each claim: its text, `--`, its certificate, and lines `changed OLD => NEW`. The certificate is accepted.
For the claim with NEW in place of OLD, which is false or says something else, it is not: neither as it is, nor with the digest of
that claim. A section `misread: …` has a certificate of what a reader once took the claim for. It is not accepted in either form.
"""
import hashlib
import os
import re
import sys

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "proofs", "certificates"))
import check  # noqa: E402
from checker import reading  # noqa: E402


def sections(text):
    """(title, claim, certificate, changes)"""
    for section in re.split(r"^== ", text, flags=re.M)[1:]:
        title, rest = section.split("\n", 1)
        claim, rest = rest.split("--\n", 1)
        certificate, rest = rest.split("qed\n", 1)
        changes = [line.removeprefix("changed ").split(" => ") for line in rest.splitlines() if line]
        yield title, claim, certificate + "qed\n", changes


def verdicts(text, certificate):
    """What check.py says of a certificate for a claim, as it is and with the digest of that claim."""
    try:
        file = reading.File(text)
        (name,) = file.places
        claim = file.claim(name)
    except (check.Refused, check.NotCovered) as why:
        return [str(why)]
    out = []
    for source in (certificate, renewed(claim, certificate)):
        try:
            check.check(claim, source, {})
            out.append("accepted")
        except (check.Refused, check.NotCovered) as why:
            out.append(str(why))
    return out


def renewed(claim, certificate):
    """The certificate with the digest of what it would show of the claim."""
    try:
        shown, _ = check.stated(claim, certificate.split("\n")[3:])
    except check.Refused:
        shown = claim
    digest = hashlib.sha256(shown.text().encode()).hexdigest()
    return re.sub("sha256 [0-9a-f]{64}", f"sha256 {digest}", certificate)


def main(path):
    wrong = count = 0
    with open(path, encoding="utf-8") as stream:
        for title, claim, certificate, changes in sections(stream.read()):
            asked = [(claim, not title.startswith("misread: "))]
            for old, new in changes:
                assert old in claim, f"{title}: {old}"
                asked.append((claim.replace(old, new, 1), False))
            for text, expected in asked:
                count += 1
                found = verdicts(text, certificate)
                if ("accepted" in found) != expected:
                    wrong += 1
                    print(f"{title}: {'accepted is' if expected else 'not accepted is'} expected of\n{text}{found}")
    print(f"{count} readings, {wrong} wrong")
    return 1 if wrong or not count else 0


if __name__ == "__main__":
    sys.exit(main(os.path.join(HERE, "readings.txt")))
