"""`carom audit` beside SymPy: whole processes, medians of one run.

Usage: cargo build --release --locked && python3 benches/compare.py [path to carom]
Needs SymPy: pip install sympy.
"""

import statistics
import subprocess
import sys
import time
from pathlib import Path

RUNS = 21
HERE = Path(__file__).parent
CAROM = sys.argv[1] if len(sys.argv) > 1 else str(HERE.parent / "target/release/carom")


def seconds(command):
    begin = time.perf_counter()
    subprocess.run(command, stdout=subprocess.DEVNULL, check=True)
    return time.perf_counter() - begin


def median(command, times):
    return statistics.median(seconds(command) for _ in range(times))


if __name__ == "__main__":
    identities = [f"eq{number:02}" for number in (5, 6, 7, 8, 9, 12, 13, 16, 22, 23, 24, 25)]
    identities += [f"u{number}" for number in (1, 2, 3, 4, 5, 6, 7)]
    rows = [
        ("carom audit (whole catalogue)", median([CAROM, "audit"], RUNS)),
        (f"carom audit --only ({len(identities)} identities)", median([CAROM, "audit", "--only", *identities], RUNS)),
        ("SymPy, the same identities", median([sys.executable, str(HERE / "sympy_identities.py")], RUNS)),
    ]
    print(f"medians of {RUNS} processes each")
    for name, value in rows:
        print(f"{name:45} {value * 1000:9.1f} ms")
    print(f"SymPy / carom, same identities: {rows[2][1] / rows[1][1]:.0f}")
    print(f"SymPy / carom, whole catalogue: {rows[2][1] / rows[0][1]:.1f}")
