"""The times of docs/speed.md: whole processes, medians; SymPy for the same identities.

Usage: cargo build --release --locked && python3 benches/compare.py [path to carom]
Needs SymPy: pip install sympy.

Processor time does not depend on what else the machine does, as long as it does not swap; the clock does.
"""

import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).parent
ROOT = HERE.parent
CAROM = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "target/release/carom")
IDENTITIES = [f"eq{number:02}" for number in (5, 6, 7, 8, 9, 12, 13, 16, 22, 23, 24, 25)]
IDENTITIES += [f"u{number}" for number in (1, 2, 3, 4, 5, 6, 7)]
ETA = "eval --m1 10 --m2 1 -e 9/10 -n 7 --want eta --digits".split()


def one(command):
    """Seconds of the processor and of the clock."""
    begin = time.perf_counter()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=ROOT)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit code {process.returncode}")
    return usage.ru_utime + usage.ru_stime, time.perf_counter() - begin


def shown(seconds):
    return f"{seconds:.2f} s" if seconds >= 1 else f"{seconds * 1e3:.3g} ms"


def main(folder):
    jobs = [
        ("carom audit", 11, [CAROM, "audit"]),
        ("carom audit --only, nineteen identities", 21, [CAROM, "audit", "--only", *IDENTITIES]),
        ("carom audit --anew --only, the same", 5, [CAROM, "audit", "--anew", "--only", *IDENTITIES]),
        ("SymPy, the same", 5, [sys.executable, str(HERE / "sympy_identities.py")]),
        ("carom audit --anew --certificates DIR", 3, [CAROM, "audit", "--anew", "--certificates", folder]),
        ("carom check", 11, [CAROM, "check"]),
        ("carom eval, eta to 15 digits", 101, [CAROM, *ETA, "15"]),
        ("carom eval, eta to a million digits", 5, [CAROM, *ETA, "1000000"]),
        ("carom replay pi-million.toml", 5, [CAROM, "replay", "examples/replay/pi-million.toml", "--max-events", "4000000"]),
    ]
    print("| job | processor | clock |\n|---|---|---|")
    for name, runs, command in jobs:
        processor, clock = (statistics.median(times) for times in zip(*(one(command) for _ in range(runs))))
        print(f"| {name} | {shown(processor)} | {shown(clock)} |", flush=True)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        main(folder)
