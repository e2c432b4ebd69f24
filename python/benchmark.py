"""10^6 cells as NumPy arrays against the same call in a program of Rust, alternately, least of all runs.

`cargo build --release --example cells` at the root first, and the wheel installed.
"""

import os
import subprocess
import time
from pathlib import Path

import numpy

import carom

target = Path(os.environ.get("CARGO_TARGET_DIR", Path(__file__).parent.parent / "target"))
program = target / "release" / "examples" / "cells"
python, rust = [], []
for _ in range(7):
    for _ in range(5):
        begin = time.perf_counter()
        table = carom.table(ratio="2:1001:1", e="0.0005:0.9995:0.001", n=7)
        python.append(time.perf_counter() - begin)
    seconds, *sums = map(float, subprocess.run([program], capture_output=True, text=True, check=True).stdout.split())
    rust.append(seconds)
    assert numpy.isclose(sums, [table.lo.sum(), table.hi.sum()], rtol=1e-12).all()
print(f"Rust {min(rust) * 1000:.1f} ms, Python {min(python) * 1000:.1f} ms: {min(python) / min(rust):.3f} times")
