"""Exact and certified numbers for one-dimensional chain collisions, and an auditor of their algebra.

>>> import carom
>>> carom.eta(64, 1, e="44/81", n=2)
Fraction(15625000000, 282429536481)
>>> carom.eta(10, 1, e="9/10", n=7).digits(20)
'0.37313751177373857462'

A result is a :class:`Number`: a :class:`fractions.Fraction` as well where it is rational, and an :class:`Enclosure`
where it is not or where an input is measured. Numbers go in exactly: integers, fractions, decimals, or texts such as
``"9/10"``, ``"0.9"``, ``"57.1 ± 0.1"`` and ``"[0.84, 0.90]"``. A float is refused, since it is seldom the number
that is meant.

Bad input raises :class:`ValueError` with the program's message, a stated limit :class:`LimitReached`. Long work is done
without Python's global lock.
"""

import importlib
from typing import TYPE_CHECKING, Any

from ._engine import LimitReached, __version__, language
from .audit import Audit, Broken, Claim, Line, Unread, Witness, audit
from .bounces import Bounces, restitution
from .chain import (
    BestN,
    Chain,
    EachHelps,
    Helps,
    Recollides,
    best_n,
    eta,
    helps,
    last_velocity,
    losses,
    masses,
    matrices,
    recollides,
    threshold,
    velocities,
)
from .number import Enclosure, Number, Undecided, UndecidedWarning, WrongType, mean, stdev
from .rows import Cells
from .table import Table, table, table_text
from .tools import (
    CheckedCell,
    Collision,
    Judgement,
    Listed,
    Picture,
    Repair,
    Replay,
    catalogue,
    check,
    check_table,
    explain,
    export,
    format_claims,
    plot,
    referee,
    referee_answers,
    referee_scenes,
    repair,
    replay,
    report,
    scene_schema,
    worksheet,
    worksheet_pdf,
)

if TYPE_CHECKING:
    from . import laws
    from .laws import law


def __getattr__(name: str) -> Any:
    # Hypothesis is needed for laws only.
    if name in ("law", "laws"):
        laws = importlib.import_module(".laws", __name__)
        return laws.law if name == "law" else laws
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


__all__ = [
    "Audit",
    "BestN",
    "Bounces",
    "Broken",
    "Cells",
    "Chain",
    "CheckedCell",
    "Claim",
    "Collision",
    "EachHelps",
    "Enclosure",
    "Helps",
    "Judgement",
    "LimitReached",
    "Line",
    "Listed",
    "Number",
    "Picture",
    "Recollides",
    "Repair",
    "Replay",
    "Table",
    "Undecided",
    "UndecidedWarning",
    "Unread",
    "Witness",
    "WrongType",
    "__version__",
    "audit",
    "best_n",
    "catalogue",
    "check",
    "check_table",
    "eta",
    "explain",
    "export",
    "format_claims",
    "helps",
    "language",
    "last_velocity",
    "law",
    "laws",
    "losses",
    "masses",
    "matrices",
    "mean",
    "plot",
    "recollides",
    "referee",
    "referee_answers",
    "referee_scenes",
    "repair",
    "replay",
    "report",
    "restitution",
    "scene_schema",
    "stdev",
    "table",
    "table_text",
    "threshold",
    "velocities",
    "worksheet",
    "worksheet_pdf",
]
