"""10^6 cells as NumPy arrays against the same call in a program of Rust, in processor time, alternately.

`cargo build --release --example cells` at the root first, and the wheel installed. The program's start is not counted:
its time for one call is taken from that for many.
"""

import os
import resource
import statistics
import subprocess
import time
from pathlib import Path

import numpy

import carom

MANY = 11

target = Path(os.environ.get("CARGO_TARGET_DIR", Path(__file__).parent.parent / "target"))
program = target / "release" / "examples" / "cells"


def rust(times: int) -> float:
    """Seconds of the processor for so many calls in one process; the sums are compared."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    out = subprocess.run([program, str(times)], capture_output=True, text=True, check=True).stdout
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    assert numpy.isclose([float(x) for x in out.split()[1:]], sums, rtol=1e-12).all()
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def table() -> carom.Table:
    return carom.table(ratio="2:1001:1", e="0.0005:0.9995:0.001", n=7)


sums = [table().lo.sum(), table().hi.sum()]
pairs = []
for _ in range(9):
    program_of_rust = (rust(MANY) - rust(1)) / (MANY - 1)
    begin = time.process_time()
    for _ in range(MANY):
        table()
    pairs.append((program_of_rust, (time.process_time() - begin) / MANY))
ratios = sorted(python / program for program, python in pairs)
least = [min(pair[i] for pair in pairs) * 1000 for i in (0, 1)]
print(f"processor time, least: Rust {least[0]:.0f} ms, Python {least[1]:.0f} ms")
print(f"median ratio {statistics.median(ratios):.2f}; all:", " ".join(f"{ratio:.2f}" for ratio in ratios))
