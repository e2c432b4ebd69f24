#!/usr/bin/env python3
"""Damages certificates in many ways and writes down what proofs/certificates/check.py says of each.

    damage.py CLAIMS CERTIFICATES OUT COUNT

Writes COUNT damaged copies of each certificate to OUT, as NAME~K.cert, and their verdicts to OUT/verdicts.txt, one to
a line: file, accepted or rejected, kind of damage, and the line that was changed. The same arguments give the same
files.
"""
import os
import random
import re
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "proofs", "certificates"))
import check  # noqa: E402
from checker.claims import FUNCTIONS, RELATIONS, RESERVED  # noqa: E402

RULES = list(check.COUNTS)
WORDS = RESERVED | FUNCTIONS | set(RULES) | {"using", "term", "times", "from", "end", "qed"}


def one(text, pattern, change, chance):
    """The text with one match of a pattern changed, or None without a match."""
    found = list(re.finditer(pattern, text))
    if not found:
        return None
    place = chance.choice(found)
    return text[: place.start()] + change(place.group()) + text[place.end() :]


def other(things, chance):
    return lambda old: chance.choice([t for t in things if t != old] or [old])


def damaged(lines, kind, chance):
    """The lines with one damage of a kind, and the number of the line; None where there is no place for it."""
    lines = list(lines)
    at = chance.randrange(3, len(lines) - 1)
    line = lines[at]
    names = sorted({w for text in lines[3:] for w in re.findall(r"[A-Za-z]\w*'*", text) if w not in WORDS})
    labels = sorted({text.split()[0] for text in lines[3:] if text.split()[0][0].isdigit()}) + ["h1", "h2", "h3"]
    head, _, tail = line.partition(": ")
    if kind == "line dropped":
        del lines[at]
        return lines, at
    if kind == "lines exchanged":
        lines[at], lines[at - 1] = lines[max(at - 1, 3)], line
        return lines, at
    if kind == "rule":
        new = one(line, r"(?<= )(%s)(?=( from .*)?: )" % "|".join(RULES), other(RULES, chance), chance)
    elif kind == "label":
        if not re.search(r"\b(from|by|using|term|end)\b", line):
            return None
        part = line if line.lstrip().startswith(("| by", "| using", "end")) else head
        new = one(part, r"(?<=[ ])(h?\d+[sd]?\d*)(?=[ ]|$)", other(labels, chance), chance)
        new = new and new + (line[len(part) :])
    elif kind == "fact dropped":
        new = one(line, r" (h?\d+[sd]?\d*)(?=[ :]|$)", lambda old: "", chance)
    elif kind == "number":
        new = one(tail, r"(?<![\w'])\d+(?![\w'])", lambda old: str(int(old) + chance.choice((-1, 1, 2))).lstrip("-"), chance)
        new = new and f"{head}: {new}"
    elif kind == "relation":
        new = one(tail, r"(<=|>=|!=|=|<|>)(?!>)", other(RELATIONS, chance), chance)
        new = new and f"{head}: {new}"
    elif kind == "variable":
        new = one(tail, r"[A-Za-z]\w*'*", lambda old: old if old in WORDS else other(names, chance)(old), chance)
        new = new and f"{head}: {new}"
    elif kind == "operator":
        new = one(tail, r"[-+*/^]", other("+-*/^", chance), chance)
        new = new and f"{head}: {new}"
    elif kind == "connective":
        new = one(tail, r"\b(and|or)\b|<=>|=>|\bonly |\bexists\b|\bfor all\b|\bmaximum\b|\bminimum\b",
                  other(("and", "or", "<=>", "=>", "exists", "for all", "maximum", "minimum", ""), chance), chance)
        new = new and f"{head}: {new}"
    else:
        new = one(line, r"\b(natural|real|and|-?1)\b", other(("natural", "real", "0", "1", "2"), chance), chance)
    if new is None or new == line:
        return None
    lines[at] = new
    return lines, at


KINDS = ["line dropped", "lines exchanged", "rule", "label", "fact dropped", "number", "relation", "variable", "operator",
         "connective", "domain"]


def main(claims_folder, certificates, out, count):
    claims, texts = check.Claims([claims_folder]), {}
    for file, source in check.files([certificates], ".cert"):
        texts[os.path.basename(file)[: -len(".cert")]] = source
    # The certificates themselves are accepted: what they show may be cited.
    accepted = {name: (claims[name], set()) for name in texts}
    os.makedirs(out, exist_ok=True)
    tried, kept = {}, {}
    with open(os.path.join(out, "verdicts.txt"), "w", encoding="utf-8") as verdicts:
        for name in sorted(texts):
            chance, made, seen = random.Random(name), 0, {texts[name]}
            for _ in range(int(count) * 4):
                kind = chance.choice(KINDS)
                found = damaged(texts[name].rstrip("\n").split("\n"), kind, chance)
                source = found and "\n".join(found[0]) + "\n"
                if source is None or source in seen or made == int(count):
                    continue
                seen.add(source)
                made += 1
                try:
                    check.check(claims[name], source, accepted)
                    verdict = "accepted"
                except check.Refused:
                    verdict = "rejected"
                tried[kind] = tried.get(kind, 0) + 1
                kept[kind] = kept.get(kind, 0) + (verdict == "accepted")
                file = f"{name}~{made}.cert"
                with open(os.path.join(out, file), "w", encoding="utf-8") as stream:
                    stream.write(source)
                verdicts.write(f"{file} {verdict} {kind.replace(' ', '-')} {found[1] + 1}\n")
    for kind in KINDS:
        print(f"{kind}: {kept.get(kind, 0)} of {tried.get(kind, 0)} still accepted")
    print(f"{sum(kept.values())} of {sum(tried.values())} damaged certificates still accepted")


if __name__ == "__main__":
    main(*sys.argv[1:])
