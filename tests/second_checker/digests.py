#!/usr/bin/env python3
"""Compares how two readers read claims.

    digests.py FILE      each line of FILE: the digest that Carom's reader gives to a claim, its name, the path of its claim file

Exit code 1 if this reader gives another digest to one of them. A claim that it does not read, or refuses, is only counted.
"""
import collections
import hashlib
import os
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "proofs", "certificates"))
import check  # noqa: E402


def main(path):
    counts, files = collections.Counter(), {}
    with open(path, encoding="utf-8") as stream:
        lines = [line.split(" ", 2) for line in stream.read().splitlines()]
    for expected, name, path in lines:
        if path not in files:
            files[path] = check.Claims([path])
        try:
            found = hashlib.sha256(files[path][name].text().encode()).hexdigest()
        except check.NotCovered as why:
            counts["not covered"] += 1
            print(f"not covered {name}: {why} ({path})")
            continue
        except check.Refused as why:
            counts["refused"] += 1
            print(f"refused {name}: {why} ({path})")
            continue
        kind = "alike" if found == expected else "differently"
        counts[kind] += 1
        if found != expected:
            print(f"{name} is read differently: {path}\n{files[path][name].text()}")
    print(f"{len(lines)} claims, {counts['alike']} read alike, {counts['differently']} differently, "
          f"{counts['refused']} refused by the second checker only, {counts['not covered']} not covered")
    return 1 if counts["differently"] or not counts["alike"] else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
