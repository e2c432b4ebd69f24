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
from .table import separated, table_text
from .tools import (
    catalogue,
    check,
    explain,
    export,
    format_claims,
    plot,
    referee,
    referee_answers,
    repair,
    replay,
    worksheet,
    worksheet_pdf,
)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m carom",
        description="Audit claims and compute with collisions, exactly.",
        epilog="Exit codes: 0 as expected, 1 not as expected, 2 bad input, 3 a stated limit. The program `carom` does "
        "more: reports as folders, proofs for Coq, tables on all cores with certificates (`cargo install --path .`).",
    )
    parser.add_argument("--version", action="version", version=f"carom {__version__}")
    commands = parser.add_subparsers(dest="command", required=True)
    add = commands.add_parser("audit", help="judge claims")
    add.add_argument("files", nargs="*", type=Path, help="claim files or papers; if none, the built-in catalogue")
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
    add.add_argument("--format", default="text", choices=["text", "markdown", "latex", "html", "pdf"])
    add.add_argument("--sheet", default="both", choices=["blank", "key", "both"])
    add.add_argument("--versions", type=int, default=0, metavar="N")
    add.add_argument("--seed", type=int, default=1)
    add.add_argument("-o", "--output", type=Path, help="a file; needed for PDF")
    add = commands.add_parser("table", help="print a table of certified numbers")
    add.add_argument("--ratio", required=True)
    add.add_argument("-e")
    add.add_argument("-n")
    add.add_argument("--want", default="eta", choices=["eta", "threshold", "best-n"])
    add.add_argument("--digits", type=int, default=6)
    add.add_argument("--places", type=int)
    add.add_argument("--round", default="nearest", choices=["nearest", "up", "down", "zero", "away"])
    add.add_argument("--format", default="text", choices=_TABLES)
    add = commands.add_parser("plot", help="draw a picture as SVG")
    add.add_argument("picture", choices=["eta-n", "eta-x", "threshold", "map", "velocities"])
    add.add_argument("scene", nargs="?", type=Path, help="for velocities")
    add.add_argument("--ratio", default="", help="one or two numbers with a comma")
    add.add_argument("-e", default="")
    add.add_argument("-n", default="")
    add.add_argument("--title")
    add.add_argument("--grey", action="store_true")
    add = commands.add_parser("list", help="list the built-in catalogue")
    add = commands.add_parser("check", help="have the kernel check certificates of the claims of a file")
    add.add_argument("file", type=Path)
    add.add_argument("certificate", type=Path)
    add = commands.add_parser("repair", help="find the hypothesis that a refuted claim lacks")
    add.add_argument("id")
    add.add_argument("file", nargs="?", type=Path)
    add = commands.add_parser("fmt", help="print claims in the one style")
    add.add_argument("file", type=Path)
    add = commands.add_parser("referee", help="judge a simulator's results by exact scenes")
    add.add_argument("file", nargs="?", type=Path, help="a CSV file; without it the right answers are printed")
    add.add_argument("--digits", type=int, default=9)
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


_TABLES = ["text", "csv", "spreadsheet", "spreadsheet-comma", "json", "markdown", "latex"]
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


def _worksheet(arguments: argparse.Namespace) -> None:
    asked = {"sheet": arguments.sheet, "versions": arguments.versions, "seed": arguments.seed}
    if arguments.format == "pdf":
        if arguments.output is None:
            raise ValueError("--format pdf: give a file, as in -o sheet.pdf")
        arguments.output.write_bytes(worksheet_pdf(arguments.scene, **asked))
        return
    text = worksheet(arguments.scene, form=arguments.format, **asked)
    if arguments.output is None:
        print(text, end="")
    else:
        arguments.output.write_text(text, encoding="utf-8")


def _plot(arguments: argparse.Namespace) -> str:
    axes = {name: separated(getattr(arguments, name), name) for name in ("ratio", "e", "n")}
    parts = {name: [part for part in axis.split(",") if part] for name, axis in axes.items()}
    if not all(part.strip().isdecimal() for part in parts["n"]):
        raise ValueError(f"-n: numbers of bodies are needed, not {arguments.n}")
    numbers = [int(part) for part in parts["n"]]
    title, grey = arguments.title, arguments.grey
    return plot(
        arguments.picture, ratio=parts["ratio"], e=parts["e"], n=numbers, scene=arguments.scene, title=title, grey=grey
    )


def _run(arguments: argparse.Namespace) -> int:
    command = arguments.command
    if command == "audit":
        audits = [audit(file, only=arguments.only) for file in arguments.files] or [audit(only=arguments.only)]
        print("\n\n".join(map(str, audits)))
        if any(one.unread for one in audits):
            return 2
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
        _worksheet(arguments)
    elif command == "table":
        ratio, e, n, want, form = arguments.ratio, arguments.e, arguments.n, arguments.want, arguments.format
        digits, places, rounding = arguments.digits, arguments.places, arguments.round
        shown = table_text(ratio=ratio, e=e, n=n, want=want, digits=digits, places=places, rounding=rounding, form=form)
        print(shown, end="")
    elif command == "plot":
        print(_plot(arguments), end="")
    elif command == "list":
        for one in catalogue():
            print(f"{one.id:<24} {one.title}")
    elif command == "check":
        text = arguments.file.read_text(encoding="utf-8")
        print(check(text, arguments.certificate.read_text(encoding="utf-8")))
    elif command == "repair":
        found_repair = repair(arguments.id, arguments.file)
        print(f"{arguments.id} {found_repair}\n\n{found_repair.claim}", end="")
    elif command == "fmt":
        print(format_claims(arguments.file), end="")
    elif command == "referee":
        if arguments.file is None:
            print(referee_answers(), end="")
            return 0
        judgement = referee(arguments.file, digits=arguments.digits)
        print(judgement)
        return 0 if judgement else 1
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
