"""J10: Carom's Python package, one chain and then columns of chains.

The package must be installed in the folder of the peers: `run` does so where it builds.
"""
import carom
import numpy

import peer


def j10(work):
    ends = lambda low, high: peer.ends(work, "J10-carom", low, high)
    yield "one call", lambda: carom.eta(10, 1, e="9/10", n=7), lambda x: ends([x.lo], [x.hi])
    one = lambda x: peer.ends(work, "J10-carom-ends", [x[0]], [x[1]])
    call = lambda: (lambda x: (x.lo, x.hi))(carom.eta(10, 1, e="9/10", n=7))
    yield "one call, two doubles", call, one
    e, r, n = numpy.fromfile(work / "J2a.bin").reshape(3, -1)
    bodies = n.astype("u8") - 1
    rows = lambda: carom.eta(r, 1, e=e, n=bodies, floats="exact")
    all_ends = lambda x: peer.ends(work, "J10-carom-rows", x.lo, x.hi)
    yield "one of 100000 rows", rows, all_ends, len(e)


if __name__ == "__main__":
    peer.run({"J10": j10})
