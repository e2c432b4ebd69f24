"""The energy that arrives, against the number of bodies between, with certified bounds. Needs matplotlib."""

import matplotlib

import carom

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

figure, axes = plt.subplots(figsize=(6, 4))
counts = range(0, 25)
for e in ("0.8", "0.9", "0.95 ± 0.005"):
    shares = [carom.eta(100, 1, e=e, n=n) for n in counts]
    axes.fill_between(counts, [x.lo for x in shares], [x.hi for x in shares], alpha=0.4)
    axes.plot(counts, [float(x.mid) for x in shares], marker=".", label=f"e = {e}")
best = carom.best_n(100, 1, e="0.9")
axes.axvline(int(best), linestyle=":", color="grey")
axes.set(xlabel="number n of inserted bodies", ylabel="share of the energy, η", title="m₁/m₂ = 100")
axes.legend()
figure.savefig("energy.png", dpi=150)
