"""The five scenes and the margin in Arb, MPFR, mpmath and PARI: who computes what, at so many digits.

    tools.py TOOL SECONDS E

A line of JSON for each scene and number of digits: the ends of a ball, or the value, as [mantissa, exponent] in
hexadecimal with a base of two. Each tool works with the digits asked for and 40 bits more, as its user would. Where a call
takes longer than SECONDS, more digits are not tried.
"""
import json
import subprocess
import sys
import tempfile
import time
from fractions import Fraction

DIGITS = (15, 30, 100, 1_000, 10_000, 100_000, 1_000_000)
SPARE = 40


def scenes(near):
    """Name, quantity, ratio, restitution and n."""
    return [
        ("eta", "eta", 10, Fraction(9, 10), 7),
        ("L_7", "L", 10, None, 7),
        ("L_2, ratio 1e34", "L", 10**34, None, 2),
        ("eta, n = 1e6", "eta", 10, Fraction(9_999_999, 10_000_000), 10**6),
        ("L_n, n = 1e6", "L", 10, None, 10**6),
        ("e - L_7, e near", "margin", 10, near, 7),
    ]


def bits_of(digits):
    return int(digits * 3.3219280948873626) + SPARE


def formula(quantity, root, number):
    """The t-form of (25), and (19), for ratio r and 1."""
    def eta(r, e, n):
        t = root(number(r), n + 1)
        gain = number(1 + e)
        return (gain * gain * t / ((1 + t) * (1 + t))) ** (n + 1)

    def threshold(r, e, n):
        return (1 + root(number(r), n + 1)) ** (n + 1) / (1 + root(number(r), n)) ** n - 1

    def margin(r, e, n):
        return number(e) - threshold(r, None, n)

    return {"eta": eta, "L": threshold, "margin": margin}[quantity]


def measure(call):
    """The least time of a call, and its value: other programs on the machine only make it longer."""
    begin = time.perf_counter()
    value = call()
    least = once = time.perf_counter() - begin
    calls = max(1, min(1000, int(2e-4 / once)))
    for _ in range(0 if once > 1 else max(3, min(100, int(0.3 / (once * calls))))):
        begin = time.perf_counter()
        for _ in range(calls):
            call()
        least = min(least, (time.perf_counter() - begin) / calls)
    return least, value


def dyadic(mantissa, exponent):
    # Through gmpy2: Python's own conversion to hexadecimal is quick, that from other types may not be.
    return [format(int(mantissa), "x"), int(exponent)]


def arb():
    from flint import arb as ball, ctx, fmpq

    def number(x):
        return ball(fmpq(x.numerator, x.denominator)) if isinstance(x, Fraction) else ball(x)

    def precision(bits):
        ctx.prec = bits

    def answer(x):
        ends = (x.lower().man_exp(), x.upper().man_exp()) if x.is_finite() else (None, None)
        return {side: dyadic(*end) if end else None for side, end in zip(("lower", "upper"), ends)}

    return precision, lambda x, k: x.root(k), number, answer


def gmpy():
    import gmpy2

    def precision(bits):
        gmpy2.get_context().precision = bits

    def number(x):
        return gmpy2.mpfr(gmpy2.mpq(x.numerator, x.denominator)) if isinstance(x, Fraction) else gmpy2.mpfr(x)

    def answer(x):
        return {"value": dyadic(*x.as_mantissa_exp()) if gmpy2.is_finite(x) else None}

    return precision, gmpy2.root, number, answer


def mp():
    import mpmath

    def precision(bits):
        mpmath.mp.prec = bits

    def number(x):
        return mpmath.mpf(x.numerator) / x.denominator if isinstance(x, Fraction) else mpmath.mpf(x)

    def answer(x):
        sign, mantissa, exponent, _ = x._mpf_
        return {"value": dyadic(-mantissa if sign else mantissa, exponent)}

    return precision, mpmath.root, number, answer


def python(tool, seconds, near):
    precision, root, number, answer = {"Arb": arb, "MPFR": gmpy, "mpmath": mp}[tool]()
    for name, quantity, r, e, n in scenes(near):
        compute = formula(quantity, root, number)
        for digits in DIGITS:
            precision(bits_of(digits))
            try:
                spent, value = measure(lambda: compute(r, e, n))
            except (ValueError, OverflowError, ZeroDivisionError, MemoryError) as error:
                print(f"{tool}, {name}, {digits} digits: {error}", file=sys.stderr)
                break
            line = {"scene": name, "tool": tool, "digits": digits, "seconds": spent, **answer(value)}
            print(json.dumps(line), flush=True)
            if spent > seconds:
                break


PARI = """default(parisizemax, "3G");
share(r, e, n) = my(t = sqrtn(r*1., n + 1)); ((1 + e)^2*t/(1 + t)^2)^(n + 1);
thr(r, e, n) = (1 + sqrtn(r*1., n + 1))^(n + 1)/(1 + sqrtn(r*1., n))^n - 1;
margin(r, e, n) = e*1. - thr(r, e, n);
measure(f, r, e, n) =
{
  my(value, begin, spent, calls = 1, least = oo, rounds = 0);
  while(rounds < 5,
    begin = getwalltime(); for(i = 1, calls, value = f(r, e, n)); spent = getwalltime() - begin;
    if(spent < 15, calls *= 4, least = min(least, spent/calls); rounds += if(spent > 1000, 5, 1)));
  [least/1000., value];
}
/* The value as a whole number of units of 2^-shift. */
run(name, f, r, e, n) =
{
  my(all = DIGITS_LIST, found, places);
  for(i = 1, #all,
    default(realbitprecision, floor(all[i]*3.3219280948873626) + SPARE_BITS);
    found = measure(f, r, e, n);
    places = floor(all[i]*3.3219280948873626) + SPARE_BITS + 400;
    printf("{\\"scene\\": \\"%s\\", \\"tool\\": \\"PARI\\", \\"digits\\": %d, \\"seconds\\": %de-12, \\"decimal\\": [\\"%d\\", %d]}\\n",
      name, all[i], round(found[1]*1e12), truncate(shift(bitprecision(found[2], 2*places), places)), -places);
    if(found[1] > SECONDS, return));
}
"""


def pari(seconds, near):
    text = PARI.replace("DIGITS_LIST", "[" + ", ".join(map(str, DIGITS)) + "]")
    text = text.replace("SPARE_BITS", str(SPARE)).replace("SECONDS", str(seconds))
    functions = {"eta": "share", "L": "thr", "margin": "margin"}
    for name, quantity, r, e, n in scenes(near):
        text += f'run("{name}", {functions[quantity]}, {r}, {e if e is not None else 0}, {n});\n'
    with tempfile.NamedTemporaryFile("w", suffix=".gp") as file:
        file.write(text + "quit\n")
        file.flush()
        subprocess.run(["gp", "-q", "-f", file.name], check=True)


if __name__ == "__main__":
    sys.set_int_max_str_digits(0)
    _, tool, seconds, near = sys.argv
    if tool == "PARI":
        pari(float(seconds), Fraction(near))
    else:
        python(tool, float(seconds), Fraction(near))
