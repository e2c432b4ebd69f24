"""Exact and certified numbers for one-dimensional chain collisions, and an auditor of their algebra.

>>> import carom
>>> carom.eta(64, 1, e="44/81", n=2)
Fraction(15625000000, 282429536481)
>>> carom.eta(10, 1, e="9/10", n=7).digits(20)
'0.37313751177373857462'

A result is a :class:`fractions.Fraction` where it is rational, and an :class:`Enclosure` where it is not or where an
input is measured. Numbers go in exactly: integers, fractions, decimals, or texts such as ``"9/10"``, ``"0.9"``,
``"57.1 ± 0.1"`` and ``"[0.84, 0.90]"``. A float is refused, since it is seldom the number that is meant.

Bad input raises :class:`ValueError` with the program's message, a stated limit :class:`LimitReached`. Long work is done
without Python's global lock.
"""

from ._engine import LimitReached, __version__, language
from .audit import Audit, Broken, Claim, Line, Witness, audit
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
from .number import Enclosure
from .table import Table, table

__all__ = [
    "Audit",
    "BestN",
    "Broken",
    "Chain",
    "Claim",
    "EachHelps",
    "Enclosure",
    "Helps",
    "LimitReached",
    "Line",
    "Recollides",
    "Table",
    "Witness",
    "__version__",
    "audit",
    "best_n",
    "eta",
    "helps",
    "language",
    "last_velocity",
    "losses",
    "masses",
    "matrices",
    "recollides",
    "table",
    "threshold",
    "velocities",
]
