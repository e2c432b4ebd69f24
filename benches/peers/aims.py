"""The figures that were aimed at, and what was measured: each line from the record alone."""


def time_of(record, job, tool, case):
    """The median of the first tool whose name begins so; None where it has none."""
    for result in record["jobs"].get(job, {}).get("results", []):
        if result["tool"].startswith(tool) and case in result["cases"]:
            return result["cases"][case]["median"]
    return None


def peers(record, job, case):
    return [r["cases"][case]["median"] for r in record["jobs"][job]["results"][1:] if case in r["cases"]]


def over_carom(record, job, tool, cases):
    """The smallest ratio of a peer's time to Carom's among these cases, over those that both finished."""
    pairs = [(time_of(record, job, tool, case), time_of(record, job, "Carom", case)) for case in cases]
    return min((theirs / ours for theirs, ours in pairs if theirs and ours), default=None)


def cases_of(record, job):
    return list(record["jobs"][job]["results"][0]["cases"])


def lines(record):
    """(job, aim, measured, reached) for every aim whose job was run."""
    found = []

    def ratio(job, aim, value, least):
        if value is not None:
            found.append((job, aim, f"{value:.2g} times" if value < 10 else f"{value:.0f} times", value >= least))

    has = lambda job: job in record["jobs"]
    one, cell, tile, cold = "19 identities", "one of 100000 cells", "one of 1000000 cells", "first answer"
    if has("J1"):
        ratio("J1", "100 times SymPy's speed (simplify)", over_carom(record, "J1", "SymPy, simplify", [one]), 100)
        flint = min(filter(None, (over_carom(record, "J1", f"python-flint, {k}", [one]) for k in ("fmpz", "fmpq"))))
        ratio("J1", "ahead of python-flint", flint, 1)
    if has("J2a"):
        ratio("J2a", "at least half the speed of the uncertified C loop", over_carom(record, "J2a", "C loop", [cell]), 0.5)
        ratio("J2a", "20 times Arb's speed from C", over_carom(record, "J2a", "Arb from C", [cell]), 20)
    if has("J2b"):
        ratio("J2b", "5 times the speed of the C loop", over_carom(record, "J2b", "C loop, libm", [tile]), 5)
        ratio("J2b", "half the speed of the separable C loop, uncertified", over_carom(record, "J2b", "C loop, separable", [tile]), 0.5)
    if has("J3"):
        def best(count):
            both = [f"{what}/{count}" for what in ("eta", "L_7")]
            own = lambda case: time_of(record, "J3", "Carom", case)
            return min((min(peers(record, "J3", c)) / own(c) for c in both if own(c) and peers(record, "J3", c)), default=None)

        ratio("J3", "ahead of every peer at 10² digits", best(100), 1)
        for count in (150, 200, 600, 1_000, 10_000):
            for what, least in (("eta", 1), ("L_7", 0.8)):
                case = f"{what}/{count}"
                both = [over_carom(record, "J3", f"Arb from {place}", [case]) for place in ("C", "python-flint")]
                ratio("J3", f"{what} against Arb at {count} digits", min(filter(None, both), default=None), least)
        ratio("J3", "twice the best peer's speed at 10⁵ digits", best(100_000), 2)
        ratio("J3", "twice the best peer's speed at 10⁶ digits", best(1_000_000), 2)
    if has("J4"):
        ratio("J4", "100 times Z3's speed, every case", over_carom(record, "J4", "Z3, nlsat", cases_of(record, "J4")), 100)
        numbers = over_carom(record, "J4", "Z3, algebraic", cases_of(record, "J4"))
        ratio("J4", "the same against Z3's algebraic numbers", numbers, 100)
        balls = over_carom(record, "J4", "Arb and a power test", cases_of(record, "J4"))
        ratio("J4", "1.5 times the speed of Arb with a power test, every case", balls, 1.5)
    if has("J5"):
        total = sum(time_of(record, "J5", "Carom", case) for case in cases_of(record, "J5"))
        last = len(cases_of(record, "J5"))
        text = f"{total * 1000:.0f} ms" + ("" if last == 24 else f" for n = 1 … {last}; greater n are not decided")
        found.append(("J5", "n = 1 … 24 in 0.1 s", text, last == 24 and total <= 0.1))
        for name in ("polsturm", "coefficients"):
            pairs = [(n, over_carom(record, "J5", f"PARI, {name}", [n])) for n in cases_of(record, "J5")]
            slower = [n for n, value in pairs if value is not None and value < 1]
            text = "each" if not slower else f"slower at n = {', '.join(slower)}"
            found.append(("J5", f"each n faster than PARI ({name})", text, not slower))
    if has("J6"):
        for case in cases_of(record, "J6"):
            ratio("J6", f"ahead of python-flint: {case}", over_carom(record, "J6", "python-flint", [case]), 1)
        for case in ("all/1000", "last/100", "last/1000"):
            ratio("J6", f"1.1 times gmpy2's speed: {case}", over_carom(record, "J6", "gmpy2", [case]), 1.1)
    if has("J7"):
        slowest = max(time_of(record, "J7", "Carom", case) for case in cases_of(record, "J7"))
        found.append(("J7", "50 µs", f"{slowest * 1e6:.0f} µs", slowest <= 50e-6))
    if has("J9"):
        for case in cases_of(record, "J9"):
            most = 10 if case == "10" else 20
            for kind in ("over all pairs", "with a heap"):
                value = over_carom(record, "J9", f"C loop {kind}", [case])
                text = None if value is None else f"{1 / value:.1f} times its time" if value > 0.1 else f"{1 / value:.0f} times its time"
                if text:
                    found.append(("J9", f"at most {most} times the C loop {kind}, {case} bodies", text, value * most >= 1))
            ratio("J9", f"30 times the speed of exact fractions in Python, {case} bodies",
                  over_carom(record, "J9", "Python loop with a heap, fractions", [case]), 30)
    if has("J10"):
        for case in cases_of(record, "J10"):
            ratio("J10", f"python-flint's speed: {case}", over_carom(record, "J10", "Arb from python-flint", [case]), 1)
    if has("J8"):
        mine = time_of(record, "J8", "Carom", cold)
        found.append(("J8", "2 ms", f"{mine * 1e3:.1f} ms", mine <= 2e-3))
    return found
