"""Exact numbers, enclosures and what can be done with both: one type, `carom.Number`."""

from fractions import Fraction

import carom

exact = carom.eta(64, 1, e="44/81", n=2)
share = carom.eta(10, 1, e="9/10", n=7)
measured = carom.eta(10, 1, e="0.90 ± 0.01", n=7)

for x in (exact, share, measured):
    print(f"{x.lo:.6f} to {x.hi:.6f}", "exactly" if x.exact is not None else "enclosed", x.radical or "")

print(share.digits(50))
print(f"{share:.4f} of the energy arrives, {100 * (1 - share):.1f} % is lost")
print(share > carom.eta(10, 1, e="9/10", n=6), share > Fraction(373, 1000))
try:
    print(measured > Fraction(373, 1000))
except carom.Undecided as reason:
    print("not decided:", reason)
