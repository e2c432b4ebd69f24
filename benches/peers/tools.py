"""Who runs which job, by which command, and what its answers are worth."""
from collections import namedtuple
from pathlib import Path

HERE = Path(__file__).resolve().parent
Tool = namedtuple("Tool", "name guarantee command")

# What an answer is worth.
PROOF = "proof"
EXACT = "exact"
CERTIFIED = "certified enclosure"
PLAIN = "uncertified"

TITLES = {
    "J1": "The catalogue's 19 identities",
    "J2a": "eta in one of 10⁵ scattered cells",
    "J2b": "eta in one of 10⁶ cells of a grid",
    "J3": "eta and L_7 to so many digits",
    "J4": "The sign of e − L_n",
    "J5": "L_(n+1) ≥ L_n for all masses",
    "J6": "Exact velocities in a chain of so many bodies",
    "J7": "The best number of bodies n*",
    "J8": "Cold process to first answer",
    "J9": "One collision in a line of so many bodies",
    "J10": "eta asked for from Python",
}
# Seconds for one case. More time buys the solvers one or two further n.
LIMITS = {"J4": 10, "J5": 10}
LIMIT = 60


class Place:
    """Where programs and inputs lie."""

    def __init__(self, work, python, carom):
        self.work, self.python, self.carom = work, python, carom

    def rust(self, job):
        return lambda cases: [self.carom / "examples" / "peers", job, self.work, *cases]

    def py(self, program, job):
        return lambda cases: [self.python, HERE / f"{program}.py", job, self.work, *cases]

    def c(self, program, job):
        return lambda cases: [self.work / program, job, self.work, *cases]

    def gp(self, job):
        def command(cases):
            prelude = self.work / f"{job}.gp"
            quoted = ", ".join(f'"{case}"' for case in cases)
            # What follows a change of the stack's size on its line is lost: it comes last.
            prelude.write_text(f'job = "{job}"; work = "{self.work}"; cases = [{quoted}]; default(parisizemax, "4G");\n')
            return ["gp", "-q", "-f", prelude, HERE / "pari.gp"]

        return command

    def maxima(self):
        batch = f'batchload("{HERE / "maxima.mac"}")$'
        return lambda cases: ["maxima", "--very-quiet", f"--batch-string={batch}"]

    def jobs(self):
        return {
            "J1": [
                Tool("Carom, audit of the claim files", PROOF, self.rust("J1")),
                Tool("SymPy, simplify", EXACT, self.py("sympy_peer", "J1-simplify")),
                Tool("SymPy, sparse fields", EXACT, self.py("sympy_peer", "J1")),
                Tool("python-flint, fmpz_mpoly", EXACT, self.py("flint_peer", "J1")),
                Tool("python-flint, fmpq_mpoly", EXACT, self.py("flint_peer", "J1-fmpq")),
                Tool("PARI", EXACT, self.gp("J1")),
                Tool("Maxima, rat", EXACT, self.maxima()),
            ],
            "J2a": [
                Tool("Carom", CERTIFIED, self.rust("J2a")),
                Tool("C loop, libm", PLAIN, self.c("loop", "J2a")),
                Tool("numpy", PLAIN, self.py("numpy_peer", "J2a")),
                Tool("Arb from C", CERTIFIED, self.c("arb", "J2a")),
                Tool("Arb from python-flint", CERTIFIED, self.py("flint_peer", "J2a")),
                Tool("mpmath.iv", CERTIFIED, self.py("mpmath_peer", "J2a")),
            ],
            "J2b": [
                Tool("Carom", CERTIFIED, self.rust("J2b")),
                Tool("C loop, libm in each cell", PLAIN, self.c("loop", "J2b")),
                Tool("C loop, separable", PLAIN, self.c("loop", "J2b-separable")),
                Tool("numpy, outer product", PLAIN, self.py("numpy_peer", "J2b")),
                Tool("Arb from C, separable", CERTIFIED, self.c("arb", "J2b")),
                Tool("Arb from python-flint, separable", CERTIFIED, self.py("flint_peer", "J2b")),
            ],
            "J3": [
                Tool("Carom", CERTIFIED, self.rust("J3")),
                Tool("Arb from C", CERTIFIED, self.c("arb", "J3")),
                Tool("Arb from python-flint", CERTIFIED, self.py("flint_peer", "J3")),
                Tool("MPFR from C", PLAIN, self.c("mpfr", "J3")),
                Tool("PARI", PLAIN, self.gp("J3")),
                Tool("mpmath", PLAIN, self.py("mpmath_peer", "J3")),
            ],
            "J4": [
                Tool("Carom", EXACT, self.rust("J4")),
                Tool("Z3, nlsat", EXACT, self.py("z3_peer", "J4")),
                Tool("Z3, algebraic numbers", EXACT, self.py("z3_peer", "J4-numbers")),
                Tool("cvc5, coverings", EXACT, self.py("cvc5_peer", "J4")),
                Tool("SymPy, sign", PLAIN, self.py("sympy_peer", "J4")),
                Tool("FLINT qqbar from python-flint", EXACT, self.py("flint_peer", "J4-qqbar")),
                Tool("Arb and a power test, python-flint", EXACT, self.py("flint_peer", "J4")),
                Tool("PARI, 200 bits and a power test", PLAIN, self.gp("J4")),
            ],
            "J5": [
                Tool("Carom, claim text to verdict", PROOF, self.rust("J5")),
                Tool("Z3, nlsat", PROOF, self.py("z3_peer", "J5")),
                Tool("cvc5, coverings", PROOF, self.py("cvc5_peer", "J5")),
                Tool("PARI, polsturm", EXACT, self.gp("J5-sturm")),
                Tool("SymPy, count_roots", EXACT, self.py("sympy_peer", "J5-roots")),
                Tool("PARI, coefficients", EXACT, self.gp("J5")),
                Tool("SymPy, coefficients", EXACT, self.py("sympy_peer", "J5")),
                Tool("python-flint, coefficients", EXACT, self.py("flint_peer", "J5")),
            ],
            "J6": [
                Tool("Carom", EXACT, self.rust("J6")),
                Tool("python-flint, product tree", EXACT, self.py("flint_peer", "J6")),
                Tool("gmpy2, product tree", EXACT, self.py("rationals_peer", "J6-gmpy2")),
                Tool("PARI, vecprod", EXACT, self.gp("J6")),
                Tool("Python fractions, product tree", EXACT, self.py("rationals_peer", "J6-fractions")),
            ],
            "J7": [
                Tool("Carom", EXACT, self.rust("J7")),
                Tool("Arb from python-flint", CERTIFIED, self.py("flint_peer", "J7")),
                Tool("PARI, 192 bits", PLAIN, self.gp("J7")),
                Tool("mpmath, 160 bits", PLAIN, self.py("mpmath_peer", "J7")),
            ],
            "J8": self.cold(),
            "J9": [
                Tool("Carom", CERTIFIED, self.rust("J9")),
                Tool("Carom, with exact values", EXACT, self.rust("J9-exact")),
                Tool("C loop over all pairs, doubles", PLAIN, self.c("events", "J9")),
                Tool("C loop with a heap, doubles", PLAIN, self.c("events", "J9-heap")),
                Tool("Python loop with a heap, doubles", PLAIN, self.py("replay_peer", "J9-doubles")),
                Tool("Python loop with a heap, fractions", EXACT, self.py("replay_peer", "J9-fractions")),
            ],
            "J10": [
                Tool("Carom from Python", CERTIFIED, self.py("carom_peer", "J10")),
                Tool("Arb from python-flint", CERTIFIED, self.py("flint_peer", "J10")),
                Tool("mpmath.iv", CERTIFIED, self.py("mpmath_peer", "J10")),
            ],
        }

    def cold(self):
        """Whole processes: 15 digits of eta for m1 : m2 = 10, e = 9/10, n = 7."""
        python = lambda code: lambda cases: [self.python, "-c", code]
        words = "eval --m1 10 --m2 1 -e 9/10 -n 7 --want eta --digits 15".split()
        mp = "import mpmath as m; m.mp.dps = 25; t = m.root(10, 8); print(m.nstr((m.mpf(361)/100*t/(1 + t)**2)**8, 15))"
        arb = "from flint import arb, ctx; ctx.prec = 80; t = arb(10).root(8); print(((arb(361)/100)*t/(1 + t)**2)**8)"
        sp = "import sympy as s; t = s.root(10, 8); print(s.N((s.Rational(361, 100)*t/(1 + t)**2)**8, 15))"
        gp = 't = sqrtn(10, 8); printf("%.15g", (361/100*t/(1 + t)^2)^8)'
        maxima = "fpprec: 25$ t: bfloat(10)^(1/bfloat(8))$ print((361/100*t/(1 + t)^2)^8)$"
        return [
            Tool("Carom", CERTIFIED, lambda cases: [self.carom / "carom", *words]),
            Tool("C, libm", PLAIN, self.c("loop", "J8")),
            Tool("Arb from C", CERTIFIED, self.c("arb", "J8")),
            Tool("PARI", PLAIN, lambda cases: ["sh", "-c", f"echo '{gp}' | gp -q -f"]),
            Tool("python-flint", CERTIFIED, python(arb)),
            Tool("mpmath", PLAIN, python(mp)),
            Tool("SymPy", PLAIN, python(sp)),
            Tool("Maxima", PLAIN, lambda cases: ["maxima", "--very-quiet", f"--batch-string={maxima}"]),
        ]
