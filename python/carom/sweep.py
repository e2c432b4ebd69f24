"""Certified sweeps larger than one machine: a table as Parquet partitions, made by Dask workers.

Contract. A partition is a batch of consecutive rows of the table, in a file whose name and rows follow from the
settings alone. A file is written under another name and renamed when it is whole, so that a partition is there
completely or not at all, whoever is killed; a run skips those that are there, and two workers that make the same one
write the same rows. :func:`check` reads all files and says what is missing, doubled or strange.

A file's metadata names the table and the rows. The columns are the axes (exact texts), ``lo`` and ``hi``: neighbouring
doubles around the certified value, or the same double twice.

``python -m carom.sweep --help`` runs it from a shell.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import tempfile
import time
import uuid
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Dict, Iterator, List, Optional, Sequence, Tuple

from . import _engine
from .number import LimitReached, count_of
from .table import Grid, ends, grid_of

ROWS = 1_000_000
"""Rows of a partition."""

_KEY = b"carom"


@dataclass(frozen=True)
class Sweep:
    """A table cut into partitions."""

    want: str
    ratio: str
    e: Optional[str]
    n: Optional[str]
    rows: int
    """Rows of the whole table."""
    batch: int
    """Rows of a partition, the last one perhaps excepted."""
    version: str

    @property
    def partitions(self) -> int:
        """How many partitions there are."""
        return -(-self.rows // self.batch)

    def range(self, part: int) -> Tuple[int, int]:
        """The rows of a partition, from 0, the last one excluded."""
        return part * self.batch, min(self.rows, (part + 1) * self.batch)

    def name(self, part: int) -> str:
        """The file of a partition."""
        width = len(str(self.partitions))
        return f"part-{part + 1:0{width}}-of-{self.partitions}.parquet"

    def facts(self, part: int) -> bytes:
        """What a file says of itself."""
        return json.dumps({**asdict(self), "part": part}, sort_keys=True).encode()

    def plan(self) -> _engine.Plan:
        """The engine's table."""
        return _engine.Plan(self.want, self.ratio, self.e, self.n)


def sweep(
    *, ratio: Grid, e: Optional[Grid] = None, n: Optional[Grid] = None, want: str = "eta", batch: int = ROWS
) -> Sweep:
    """Cuts a table into partitions; the arguments are those of :func:`carom.table`."""
    texts = [grid_of(ratio, "ratio") or "", grid_of(e, "e"), grid_of(n, "n")]
    size = count_of(batch, "batch")
    if size == 0:
        raise ValueError("batch: a partition has at least one row")
    rows = _engine.Plan(want, texts[0] or "", texts[1], texts[2]).rows()
    return Sweep(want, texts[0] or "", texts[1], texts[2], rows, size, _engine.__version__)


def columns(job: Sweep, start: int, stop: int) -> Dict[str, Any]:
    """The rows from one up to another as Arrow arrays."""
    import numpy
    import pyarrow

    plan = job.plan()
    shape = plan.shape()
    out: Dict[str, Any] = {}
    row = numpy.arange(start, stop, dtype=numpy.uint64)
    behind = 1
    for axis in reversed(range(len(shape))):
        name, length = shape[axis]
        place = row // numpy.uint64(behind) % numpy.uint64(length)
        # Only the values that occur are written down.
        used, codes = numpy.unique(place, return_inverse=True)
        texts = _labels(plan, axis, used)
        out[name] = pyarrow.DictionaryArray.from_arrays(
            codes.astype(numpy.int32), pyarrow.array(texts, pyarrow.string())
        )
        behind *= length
    out = dict(reversed(list(out.items())))
    out["lo"], out["hi"] = (pyarrow.array(x) for x in ends(plan, start, stop))
    return out


def _labels(plan: _engine.Plan, axis: int, places: Any) -> List[str]:
    """The texts of some places of an axis, asked for in runs."""
    texts: List[str] = []
    begin = 0
    for i in range(1, len(places) + 1):
        if i == len(places) or places[i] != places[i - 1] + 1:
            texts += plan.labels(axis, int(places[begin]), int(places[i - 1]) + 1)
            begin = i
    return texts


def write(job: Sweep, folder: str, part: int) -> bool:
    """Writes a partition unless it is there; whether there was anything to do.

    The work of one task: it depends on nothing but its arguments, and may be done again.
    """
    import pyarrow
    import pyarrow.parquet

    path = Path(folder) / job.name(part)
    if _is_there(job, path, part):
        return False
    found = pyarrow.table(columns(job, *job.range(part)))
    found = found.replace_schema_metadata({_KEY: job.facts(part)})
    temporary = Path(folder) / f".part-{uuid.uuid4().hex}.tmp"
    try:
        # With the rights of any new file.
        temporary.touch(exist_ok=False)
        axes = [name for name in found.column_names if name not in ("lo", "hi")]
        pyarrow.parquet.write_table(
            found, temporary, compression="zstd", use_dictionary=axes, use_byte_stream_split=["lo", "hi"]
        )
        with open(temporary, "rb") as file:
            os.fsync(file.fileno())
        os.replace(temporary, path)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise
    return True


def _is_there(job: Sweep, path: Path, part: int) -> bool:
    """Whether a partition is complete; a file of another table is a :class:`ValueError`."""
    import pyarrow.parquet

    if not path.exists():
        return False
    metadata = pyarrow.parquet.read_metadata(path)
    start, stop = job.range(part)
    if (metadata.metadata or {}).get(_KEY) != job.facts(part) or metadata.num_rows != stop - start:
        raise ValueError(f"{path} belongs to another table; choose another folder")
    return True


def _refuse_others(job: Sweep, folder: str) -> None:
    """A :class:`ValueError` where a folder has a partition of another table."""
    parts = {job.name(part): part for part in range(job.partitions)}
    for path in sorted(Path(folder).glob("part-*.parquet")):
        part = parts.get(path.name)
        if part is None:
            raise ValueError(f"{path} belongs to another table; choose another folder")
        _is_there(job, path, part)


def missing(job: Sweep, folder: str) -> Iterator[int]:
    """The partitions that are not there."""
    return (part for part in range(job.partitions) if not (Path(folder) / job.name(part)).exists())


def run(job: Sweep, folder: str, client: Any = None, *, ahead: int = 1_000) -> int:
    """Writes the partitions that are missing; how many there were.

    With a ``distributed.Client`` its workers do, at most ``ahead`` partitions at a time being handed out; the folder
    must be one that all of them see. A worker that is killed costs the partitions that it had under way, which others
    do again.
    """
    Path(folder).mkdir(parents=True, exist_ok=True)
    _refuse_others(job, folder)
    if client is None:
        return sum(write(job, folder, part) for part in missing(job, folder))
    from distributed import as_completed

    parts = missing(job, folder)
    hand_out = lambda part: client.submit(write, job, folder, part, pure=False, retries=10)  # noqa: E731
    running = as_completed([hand_out(part) for _, part in zip(range(ahead), parts)])
    made = 0
    for future in running:
        made += future.result()
        following = next(parts, None)
        if following is not None:
            running.add(hand_out(following))
    return made


def check(job: Sweep, folder: str) -> int:
    """Reads every partition and compares it with the settings; how many rows there are.

    Raises :class:`ValueError` for what is missing, doubled or strange. The values are not computed again.
    """
    import pyarrow.parquet

    wanted = {job.name(part) for part in range(job.partitions)}
    there = {path.name for path in Path(folder).glob("part-*.parquet")}
    for names, what in ((wanted - there, "is missing"), (there - wanted, "belongs to no partition")):
        if names:
            raise ValueError(f"{Path(folder) / min(names)} {what} ({len(names)} such)")
    rows = 0
    plan = job.plan()
    for part in range(job.partitions):
        path = Path(folder) / job.name(part)
        _is_there(job, path, part)
        found = pyarrow.parquet.read_table(path)
        start, stop = job.range(part)
        if found.num_rows != stop - start:
            raise ValueError(f"{path} has {found.num_rows} rows, not {stop - start}")
        for row, at in ((start, 0), (stop - 1, -1)):
            behind = 1
            for axis, (name, length) in reversed(list(enumerate(plan.shape()))):
                place = row // behind % length
                behind *= length
                if plan.labels(axis, place, place + 1) != [found[name][at].as_py()]:
                    raise ValueError(f"{path}: row {row + 1} is not where it belongs")
        rows += found.num_rows
    return rows


@dataclass(frozen=True)
class Estimate:
    """What a sweep costs, from a sample on this machine: one process, its own time."""

    cells: int
    """Cells that were computed and written."""
    compute: float
    """Seconds of the processor for the certified doubles alone."""
    total: float
    """Seconds of the processor for everything: computing, compressing, writing."""
    size: int
    """Bytes written."""

    def of(self, cells: float) -> Tuple[float, float]:
        """Hours of one core, and terabytes, for so many cells."""
        return self.total / self.cells * cells / 3600, self.size / self.cells * cells / 1e12


def estimate(job: Sweep, parts: int = 4) -> Estimate:
    """Measures some partitions, spread over the table."""
    chosen = sorted({part * (job.partitions - 1) // max(parts - 1, 1) for part in range(parts)})
    cells = sum(stop - start for start, stop in map(job.range, chosen))
    with tempfile.TemporaryDirectory() as folder:
        write(job, folder, chosen[0])  # Imports and first pages of memory are not counted.
        os.unlink(Path(folder) / job.name(chosen[0]))
        begin = time.process_time()
        for part in chosen:
            ends(job.plan(), *job.range(part))
        middle = time.process_time()
        for part in chosen:
            write(job, folder, part)
        end = time.process_time()
        size = sum(path.stat().st_size for path in Path(folder).iterdir())
    return Estimate(cells, middle - begin, end - middle, size)


def _main(arguments: Sequence[str]) -> int:
    parser = argparse.ArgumentParser(prog="python -m carom.sweep", description="A table as Parquet partitions.")
    parser.add_argument(
        "--ratio", required=True, help="mass ratios m1/m2: 1,2,10 or start:stop:step or start:stop:xFACTOR"
    )
    parser.add_argument("-e", help="coefficients of restitution, for eta and best-n")
    parser.add_argument("-n", help="numbers of inserted bodies, for eta and threshold")
    parser.add_argument("--want", default="eta", help="eta, threshold or best-n")
    parser.add_argument("--batch", type=int, default=ROWS, help="rows of a partition (%(default)s)")
    action = parser.add_mutually_exclusive_group(required=True)
    action.add_argument("--out", help="the folder to write to; partitions that are there are kept")
    action.add_argument("--check", metavar="OUT", help="read a folder and say whether it is the table")
    action.add_argument("--estimate", action="store_true", help="measure a sample, and say what all cells cost")
    workers = parser.add_mutually_exclusive_group()
    workers.add_argument("--workers", type=int, default=1, help="worker processes on this machine (%(default)s)")
    workers.add_argument("--scheduler", help="the address of a running Dask scheduler instead")
    flags = parser.parse_args(arguments)
    job = sweep(ratio=flags.ratio, e=flags.e, n=flags.n, want=flags.want, batch=flags.batch)
    if flags.check:
        print(f"{check(job, flags.check)} rows in {job.partitions} partitions: all there, once")
    elif flags.estimate:
        found = estimate(job)
        hours, terabytes = found.of(job.rows)
        print(f"sample: {found.cells} cells, {found.cells / found.compute:.3g} a second computed,")
        print(
            f"        {found.cells / found.total:.3g} a second computed and written,"
            f" {found.size / found.cells:.3g} bytes each"
        )
        print(f"table:  {job.rows} cells, {job.partitions} partitions, {hours:.3g} core hours, {terabytes:.3g} TB")
    elif flags.workers == 1 and not flags.scheduler:
        print(f"{run(job, flags.out)} partitions written, {job.partitions} are there")
    else:
        from distributed import Client, LocalCluster

        if flags.scheduler:
            cluster, client = None, Client(flags.scheduler)
        else:
            cluster = LocalCluster(n_workers=flags.workers, threads_per_worker=1, dashboard_address=None)
            client = Client(cluster)
        with client:
            print(f"{run(job, flags.out, client)} partitions written, {job.partitions} are there")
        if cluster is not None:
            cluster.close()
    return 0


if __name__ == "__main__":
    try:
        sys.exit(_main(sys.argv[1:]))
    except (LimitReached, ValueError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        sys.exit(3 if isinstance(error, LimitReached) else 2)
