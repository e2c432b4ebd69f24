"""How many processes of others want a processor while a job is measured."""
import os
import threading
from pathlib import Path

# From so many on the figures are those of a loaded machine.
LOADED = 1.5


def state_and_parent(path):
    """What stands behind the name in parentheses, which may hold anything: the state, then the parent."""
    fields = path.read_text().rpartition(")")[2].split()
    return fields[0], int(fields[1])


def own_threads():
    """The threads of this process and its descendants that want a processor."""
    parents = {}
    for process in Path("/proc").glob("[0-9]*"):
        try:
            parents[int(process.name)] = state_and_parent(process / "stat")[1]
        except OSError:
            continue  # it has ended
    own = {os.getpid()}
    while more := {child for child, parent in parents.items() if parent in own} - own:
        own |= more
    count = 0
    for process in own:
        for thread in Path(f"/proc/{process}/task").glob("*/stat"):
            try:
                count += state_and_parent(thread)[0] == "R"
            except OSError:
                continue
    return count


def others_now():
    wanting = int(Path("/proc/loadavg").read_text().split()[3].split("/")[0])
    return max(0, wanting - own_threads())


class Others:
    """`with Others() as load: …`, then `load.average()`: looked at every few seconds; None where there is no /proc."""

    def __init__(self, seconds=2.0):
        self.seconds, self.seen, self.done = seconds, [], threading.Event()

    def __enter__(self):
        if Path("/proc/loadavg").exists():
            self.thread = threading.Thread(target=self.look, daemon=True)
            self.thread.start()
        return self

    def look(self):
        while not self.done.is_set():
            self.seen.append(others_now())
            self.done.wait(self.seconds)

    def __exit__(self, *_):
        self.done.set()

    def average(self):
        return round(sum(self.seen) / len(self.seen), 1) if self.seen else None
