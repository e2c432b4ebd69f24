"""Sweeps: partitions that workers write, one of which is killed, against a single process."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

import carom
from carom import sweep as sweeping

pyarrow = pytest.importorskip("pyarrow")
pytest.importorskip("pyarrow.parquet")
GRID = {"ratio": "2:121:1", "e": "0:1:0.05", "n": "0:19:1"}


def content(job, folder):
    import pyarrow.parquet

    return pyarrow.concat_tables(
        [pyarrow.parquet.read_table(Path(folder) / job.name(part)) for part in range(job.partitions)]
    ).unify_dictionaries()


@pytest.fixture(scope="module")
def single(tmp_path_factory):
    folder = tmp_path_factory.mktemp("single")
    job = sweeping.sweep(**GRID, batch=1_000)
    assert sweeping.run(job, str(folder)) == job.partitions == 51
    return job, folder


def test_partitions_are_the_table(single):
    job, folder = single
    table, whole = content(job, folder), carom.table(**GRID)
    assert table.num_rows == job.rows == len(whole) == sweeping.check(job, str(folder))
    assert (table["lo"].to_numpy() == whole.lo.ravel()).all() and (table["hi"].to_numpy() == whole.hi.ravel()).all()
    frame = whole.to_pandas()
    for name in ("ratio", "e", "n"):
        assert table[name].to_pylist() == list(frame[name])


def test_what_is_there_is_skipped_and_what_is_strange_is_refused(single, tmp_path):
    job, _ = single
    folder = str(tmp_path)
    assert sweeping.write(job, folder, 3) and not sweeping.write(job, folder, 3)
    assert sweeping.run(job, folder) == job.partitions - 1 and sweeping.run(job, folder) == 0
    assert not list(tmp_path.glob(".part*"))
    (tmp_path / job.name(7)).unlink()
    with pytest.raises(ValueError, match="is missing"):
        sweeping.check(job, folder)
    # A partition under another's name, then one of another table.
    (tmp_path / job.name(7)).write_bytes((tmp_path / job.name(8)).read_bytes())
    with pytest.raises(ValueError, match="another table"):
        sweeping.check(job, folder)
    other = sweeping.sweep(**{**GRID, "e": "0:1:0.050"}, batch=1_000)
    with pytest.raises(ValueError, match="another table"):
        sweeping.write(other, folder, 3)
    (tmp_path / job.name(7)).unlink()
    assert sweeping.run(job, folder) == 1 and sweeping.check(job, folder) == job.rows
    (tmp_path / "part-99-of-99.parquet").write_bytes(b"")
    with pytest.raises(ValueError, match="no partition"):
        sweeping.check(job, folder)


def test_a_worker_that_is_killed_costs_nothing_and_doubles_nothing(tmp_path):
    """Three worker processes; one of them is killed with SIGKILL in the middle."""
    distributed = pytest.importorskip("distributed")
    job = sweeping.sweep(ratio="2:601:1", e="0:1:0.01", n="0:19:1", batch=10_000)
    folder, reference = tmp_path / "cluster", tmp_path / "single"
    reference.mkdir()
    for part in range(job.partitions):
        sweeping.write(job, str(reference), part)
    with (
        distributed.LocalCluster(n_workers=3, threads_per_worker=1, processes=True, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        pids = list(client.run(os.getpid).values())
        assert len(set(pids)) == 3 and os.getpid() not in pids
        killer = subprocess.Popen([sys.executable, "-c", KILL, str(folder), str(pids[0])])
        made = sweeping.run(job, str(folder), client, ahead=12)
        assert killer.wait(60) == 0, "the worker was killed while partitions were missing"
        assert pids[0] not in client.run(os.getpid).values()
    # Partitions that were written and not reported are found by the second attempt: nothing is made twice. A worker
    # holds its reports until they are fetched, and no more than `ahead` are waited for at a time.
    assert job.partitions - 12 <= made <= job.partitions
    assert sweeping.check(job, str(folder)) == job.rows
    for part in range(job.partitions):
        assert (folder / job.name(part)).read_bytes() == (reference / job.name(part)).read_bytes()


KILL = f"""
import os, signal, sys, time
from pathlib import Path
folder, pid = Path(sys.argv[1]), int(sys.argv[2])
while len(list(folder.glob('part-*'))) < 5:
    time.sleep(0.01)
os.kill(pid, {int(signal.SIGKILL)})
there = len(list(folder.glob('part-*')))
sys.exit(0 if there < 100 else f'{{there}} partitions were there')
"""


def test_the_command_writes_checks_and_estimates(tmp_path):
    def command(*more):
        arguments = [sys.executable, "-m", "carom.sweep", "--ratio", "2:11:1", "-e", "0:1:0.1", "-n", "0:9:1", *more]
        return subprocess.run(arguments, capture_output=True, text=True, timeout=120)

    out = str(tmp_path / "out")
    found = command("--out", out, "--batch", "100")
    assert found.returncode == 0 and "11 partitions written, 11 are there" in found.stdout, found.stderr
    assert "0 partitions written, 11 are there" in command("--out", out, "--batch", "100").stdout
    assert "1100 rows in 11 partitions: all there, once" in command("--check", out, "--batch", "100").stdout
    strange = command("--out", out, "--batch", "100", "--want", "threshold")
    assert strange.returncode == 2 and "error: threshold does not depend on e" in strange.stderr
    assert "core hours" in command("--estimate", "--batch", "100").stdout
    begin = time.time()
    limit = [sys.executable, "-m", "carom.sweep", "--ratio", "0:1:1e-30", "-e", "1", "-n", "1", "--out", out]
    assert subprocess.run(limit, capture_output=True).returncode == 3 and time.time() - begin < 60
