"""Whether all tools gave the same answers: enclosures must overlap, plain numbers lie near them, all else be equal."""
import numpy


def ends(path):
    lower, upper = numpy.fromfile(path).reshape(2, -1)
    return lower, upper


def faults(job, results):
    """One line for each disagreement, and for each tool that broke down."""
    found = [f"{r['tool']}: {r['end']}" for r in results if r["end"] != "done"]
    reference = results[0]
    for other in results[1:]:
        for case, answer in other["answers"].items():
            expected = reference["answers"].get(case)
            # Where Carom has no answer, the next tool that has one is asked.
            if expected is None:
                expected = next((r["answers"][case] for r in results if case in r["answers"]), answer)
            if not (near(expected, answer) if answer.endswith(".ends") else expected == answer):
                found.append(f"{case}: {reference['tool']} says {expected}, {other['tool']} {answer}")
    for result in results:
        # The paths of ends say nothing to a reader.
        result["answers"] = {c: a for c, a in result["answers"].items() if not a.endswith(".ends")}
    return found


def near(reference, other):
    """All enclosures overlap; a plain number may miss an enclosure by 1e-12 of it."""
    (low, high), (a, b) = ends(reference), ends(other)
    count = min(len(low), len(a))
    low, high, a, b = low[:count], high[:count], a[:count], b[:count]
    slack = numpy.where(a == b, 1e-12 * numpy.abs(high) + 1e-300, 0)
    ordered = numpy.all(low <= high) and numpy.all(a <= b)
    return bool(ordered and numpy.all(a <= high + slack) and numpy.all(b >= low - slack))
