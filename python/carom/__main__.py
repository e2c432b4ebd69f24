"""``python -m carom``: the main parts of the command line, for where only the Python package is installed.

The command ``carom`` does more: ``cargo install --path .`` in the repository installs it.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import List, Optional

from . import LimitReached, __version__, audit, check_table, language
from .bounces import restitution
from .chain import Chain
from .tools import explain, export, replay, worksheet


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m carom",
        description="Audit claims and compute with collisions, exactly.",
        epilog="Exit codes: 0 as expected, 1 not as expected, 2 bad input, 3 a stated limit. The program `carom` does "
        "more: tables, reports, PDF, certificates of tables (`cargo install --path .` in the repository).",
    )
    parser.add_argument("--version", action="version", version=f"carom {__version__}")
    commands = parser.add_subparsers(dest="command", required=True)
    add = commands.add_parser("audit", help="judge claims")
    add.add_argument("files", nargs="*", type=Path, help="claim files; the built-in catalogue if none is given")
    add.add_argument("--only", nargs="+", default=[], metavar="ID")
    add = commands.add_parser("explain", help="print the proof of one claim in words")
    add.add_argument("id")
    add.add_argument("file", nargs="?", type=Path)
    add = commands.add_parser("eval", help="compute with one chain")
    add.add_argument("--m1", required=True)
    add.add_argument("--m2", required=True)
    add.add_argument("-e")
    add.add_argument("-n", type=int)
    add.add_argument("--masses", nargs="+")
    add.add_argument("--want", default="eta", help="eta, threshold, helps, best_n, masses, velocities, recollides, …")
    add = commands.add_parser("replay", help="replay collisions one by one")
    add.add_argument("scene", type=Path)
    add.add_argument("--until")
    add.add_argument("--through-collapse", action="store_true")
    add.add_argument("--format", default="text", choices=["text", "csv", "svg", "html"])
    add = commands.add_parser("worksheet", help="make a worksheet of a scene and its key")
    add.add_argument("scene", type=Path)
    add.add_argument("--format", default="text", choices=["text", "markdown", "latex", "html"])
    add = commands.add_parser("check-table", help="judge somebody's table")
    add.add_argument("file", type=Path)
    add = commands.add_parser("restitution", help="the coefficient of restitution from measured bounces")
    add.add_argument("file", type=Path, help="a CSV file with a column height or time, or drop and bounce")
    add.add_argument("--within", metavar="U", help="the uncertainty of readings that have none of their own")
    add.add_argument("--digits", type=int, default=4)
    add = commands.add_parser("export", help="statements for Coq or SMT solvers")
    add.add_argument("language", choices=["coq", "smt2"])
    add.add_argument("file", type=Path)
    commands.add_parser("language", help="describe the claim language")
    return parser


_QUANTITIES = "eta threshold helps best_n masses velocities last_velocity losses recollides".split()


def _eval(arguments: argparse.Namespace) -> str:
    made = Chain(arguments.m1, arguments.m2, e=arguments.e, n=arguments.n, masses=arguments.masses)
    lines = []
    for name in arguments.want.replace("-", "_").split(","):
        if name not in _QUANTITIES:
            raise ValueError(f"--want: nothing is called {name!r}: {', '.join(_QUANTITIES)}")
        found = getattr(made, name)()
        shown = ", ".join(map(str, found)) if isinstance(found, (list, tuple)) else str(found)
        lines.append(f"{name:<14} {shown}")
    return "\n".join(lines)


def _run(arguments: argparse.Namespace) -> int:
    command = arguments.command
    if command == "audit":
        audits = [audit(file, only=arguments.only) for file in arguments.files] or [audit(only=arguments.only)]
        print("\n\n".join(map(str, audits)))
        return 0 if all(one.as_expected for one in audits) else 1
    if command == "explain":
        found = explain(arguments.file, arguments.id) if arguments.file else audit(only=arguments.id)[0].explanation
        print(found, end="")
    elif command == "eval":
        print(_eval(arguments))
    elif command == "replay":
        found_replay = replay(arguments.scene, until=arguments.until, through_collapse=arguments.through_collapse)
        forms = {"text": found_replay.__str__, "csv": found_replay.csv, "svg": found_replay.svg}
        print(forms.get(arguments.format, found_replay.html)(), end="")
        return 3 if found_replay.status == "limit" else 0
    elif command == "worksheet":
        print(worksheet(arguments.scene, form=arguments.format), end="")
    elif command == "check-table":
        cells = check_table(arguments.file)
        for cell in cells:
            print(f"line {cell.line}  {cell.quantity}  {cell.written}  certified {cell.certified}  {cell.judgement}")
        return 0 if all(cell.right for cell in cells) else 1
    elif command == "restitution":
        bounces = restitution(arguments.file, within=arguments.within, digits=arguments.digits)
        print(bounces)
        return 0 if bounces else 1
    elif command == "export":
        print(export(arguments.file, arguments.language), end="")
    else:
        print(language(), end="")
    return 0


def main(arguments: Optional[List[str]] = None) -> int:
    """Runs a command; the exit code."""
    try:
        return _run(_parser().parse_args(arguments))
    except (ValueError, OSError) as error:
        print(f"error: {error}".replace("error: error: ", "error: "), file=sys.stderr)
        return 2
    except LimitReached as error:
        print(f"error: {error}", file=sys.stderr)
        return 3


if __name__ == "__main__":
    sys.exit(main())
