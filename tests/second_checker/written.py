#!/usr/bin/env python3
"""Random claims in the language of authors: every construct that a reader writes out, in any combination.

    written.py OUT COUNT [SEED]      writes COUNT claim files to the folder OUT, one claim in each

The claims need not be true, and some are refused by a reader. tests/all/second_checker.rs compares the two readings of each.
"""
import os
import random
import sys

ANGLES = ("theta", "alpha", "phi")
NAMES = ("floor_1", "cos_theta", "sin_alpha", "x_from", "M_11", "k_up", "theta_over_2", "i", "j", "P_11", "cos_theta_over_2", "x1", "x_1")


class Maker:
    """Makes one claim; the names in scope are those that it has declared."""

    def __init__(self, chance):
        self.chance, self.lines, self.reals, self.naturals, self.angles = chance, [], [], [], []
        self.families, self.functions, self.matrices, self.labels = [], [], [], 0

    def one(self, *things):
        return self.chance.choice(things)

    def likely(self, p):
        return self.chance.random() < p

    # Expressions.
    def number(self):
        return self.one("0", "1", "2", "3", "1/2", "2.5")

    def turns(self):
        return self.one("0", "pi", "pi/2", "pi/3", "2*pi", "3*pi/2", "-pi/4", "pi/5", "5*pi/12", "pi/8", "-pi", "7*pi/6")

    def angle(self):
        if not self.angles:
            return self.turns()
        theta = self.one(*self.angles)
        part = self.one(theta, theta, f"arctan({theta})", f"arccos({self.atom()})", f"2*{theta}", f"{theta}/2", f"3*{theta}/2", f"-{theta}", f"{theta}/3")
        if self.likely(0.3):
            part += self.one(" + ", " - ") + self.one(self.turns().lstrip("-"), *self.angles)
        return part

    def atom(self):
        things = [self.number()]
        for names in (self.reals, self.reals, self.naturals):
            things += names[-3:] and [self.one(*names)]
        things += [f"{u}({self.index()})" for u in self.families[-1:]]
        things += [f"{f}({self.one(*self.reals, '2')})" for f in self.functions[-1:]]
        return self.one(*things)

    def index(self):
        return self.one("0", "1", *self.naturals, *(f"{n} + 1" for n in self.naturals))

    def matrix(self):
        if self.matrices and self.likely(0.7):
            return self.one(*self.matrices)
        rows = self.one(1, 2, 2, 2, 3)
        return "[" + "; ".join(", ".join(self.simple() for _ in range(rows)) for _ in range(rows)) + "]"

    def simple(self):
        return self.one("0", "1", "2", *self.reals, *self.reals)

    def matrices_of(self):
        m = self.matrix()
        m = self.one(m, m, f"transpose({m})", f"{m}*{self.matrix()}", f"(-{m})", f"({m} + {m})", f"2*{m}", f"{m}/3",
                     f"inverse({m})")
        return f"({m})^" + self.one("2", "0", "3", "(-1)", *self.naturals) if self.likely(0.4) else m

    def expr(self, depth):
        if depth == 0:
            return self.atom()
        e = lambda: self.expr(depth - 1)
        choice = self.chance.randrange(26)
        if choice < 4:
            return f"({e()} {self.one('+', '-')} {e()})"
        if choice < 7:
            return f"{e()}*{e()}"
        if choice == 7:
            return f"({e()})/({e()})"
        if choice == 8:
            return f"-({e()})"
        if choice == 9:
            return f"({e()})^{self.one('2', '3', '(-1)', 'n' if 'n' in self.naturals else '2')}"
        if choice in (10, 11, 12):
            return f"{self.one('sin', 'cos', 'sin', 'cos', 'tan')}({self.angle()})"
        if choice == 13:
            return self.one(f"|{self.atom()}|", f"abs({e()})")
        if choice == 14:
            return f"{self.one('max', 'min')}({', '.join(e() for _ in range(self.one(2, 2, 3)))})"
        if choice == 15:
            return self.one(*(f"{n}!" for n in self.naturals), "4!", f"factorial({self.index()})")
        if choice == 16:
            return f"binomial({e()}, {self.index()})"
        if choice in (17, 18):
            return f"{self.one('floor', 'ceil', 'floor', 'ceiling')}({self.one(e, self.atom, lambda: f'2*{self.atom()}')()})"
        if choice == 19:
            return f"{self.one('trace', 'det')}({self.matrices_of()})"
        if choice == 20:
            return f"{self.one('exp', 'sqrt', 'ln', 'cosh', 'arctan', 'arcsin', 'arccos')}({self.one(e, e, self.angle)()})"
        if choice == 21:
            i = self.one("i", "j", "k1")
            self.naturals.append(i)
            body = e()
            self.naturals.pop()
            return f"{self.one('sum', 'product')}({i} = {self.one('0', '1')}..{self.index()}, {body})"
        if choice in (22, 23) and self.angles:
            return f"derivative({e()}, {', '.join(self.one(*self.angles) for _ in range(self.one(1, 1, 2)))})"
        if choice == 24 and self.reals:
            return f"derivative({e()}, {self.one(*self.reals)})"
        return e()

    # Propositions.
    def comparison(self, depth=1):
        return f"{self.expr(depth)} {self.one('=', '<', '<=', '>', '>=', '!=')} {self.expr(depth)}"

    def bound(self, theta):
        low, high = self.one("0", "-pi", "-pi/2", "pi/6"), self.one("pi", "pi/2", "2*pi", "3*pi/2", "pi/3")
        return f"{theta} in {self.one('[', '(')}{low}, {high}{self.one(']', ')')}"

    def limit(self):
        v = self.one("t", "h", "z", "x" if "x" not in self.reals else "t")
        if any(v in names for names in (self.reals, self.naturals)):
            v = "t9"
        natural = self.one("", "", "", " natural", " real")
        self.reals.append(v)
        of = self.expr(2)
        self.reals.pop()
        if self.likely(0.6):
            aim = self.one("0", "1", "3", *self.reals, *(f"{x} + 1" for x in self.reals)) + self.one("", " from above", " from below")
            natural = ""
        else:
            aim = "infinity"
        return f"limit of {of} as {v}{natural} -> {aim} is {self.one('0', '1', 'infinity', '-infinity', *self.reals)}"

    def extremum(self):
        word, only = self.one("maximum", "minimum"), self.one("", " only")
        if self.likely(0.6):
            theta = self.one("beta", "omega")
            self.angles.append(theta)
            of = self.expr(2)
            self.angles.pop()
            if theta not in of:
                of += f" + cos({theta})"
            place = self.one(f"{only} at {theta} = {self.turns()} is 1", f"{only} at {theta} = pi/3 is 1/2", " is 1")
            return f"{word} of {of} over {self.bound(theta)}{place}"
        self.reals.append("w")
        of = self.expr(2)
        self.reals.pop()
        return f"{word} of {of} over w in [0, 2]" + self.one(f"{only} at w = 1 is 1", " is 2")

    def quantified(self):
        word = self.one("for all", "exists")
        if self.likely(0.6):
            theta = self.one("beta", "theta_over_2", "psi")
            if theta in self.reals:
                theta = "psi"
            self.angles.append(theta)
            body = self.prop(1)
            self.angles.pop()
            return f"({word} {self.one(self.bound(theta), theta + ' real')}: cos({theta}) <= 1 and {body})"
        self.reals.append("w")
        body = self.prop(1)
        self.reals.pop()
        return f"({word} w {self.one('real', '> 0')}: {body})"

    def prop(self, depth):
        choice = self.chance.randrange(10)
        if depth == 0 or choice < 3:
            return self.comparison(2)
        if choice == 3:
            return f"({self.prop(depth - 1)} {self.one('and', 'or', '=>', '<=>')} {self.prop(depth - 1)})"
        if choice in (4, 5):
            return f"({self.limit()})"
        if choice in (6, 7):
            return f"({self.extremum()})"
        return self.quantified()

    # Clauses.
    def declare(self):
        self.reals += ["x"]
        self.lines.append("given x " + self.one("real", "> 0", ">= 0", "real"))
        if self.likely(0.4):
            self.lines.append("given " + self.one("0 < a < b", "a > b > 0", "|a| <= b", "a^2 + b^2 = 1"))
            self.reals += ["a", "b"]
        if self.likely(0.6):
            self.lines.append("given n natural" + self.one("", " >= 1", "; m in 1..n"))
            self.naturals.append("n")
        if self.likely(0.3):
            self.lines.append("given k integer" + self.one("", " >= -2", " in [-3, 3]", " >= 0 and <= 7"))
            self.reals.append("k")
        for theta in self.chance.sample(ANGLES, self.one(0, 1, 1, 2)):
            self.lines.append("given " + self.one(self.bound(theta), self.bound(theta), f"{theta} real", f"0 < {theta} < pi"))
            self.lines.append(f"assume {self.one('sin', 'cos')}({theta}{self.one('', '/2', '/3')}) <= 1")
            self.angles.append(theta)
        if self.likely(0.2):
            name = self.one(*NAMES)
            self.lines.append(f"given {name} real")
            self.reals.append(name)
        if self.likely(0.25):
            self.lines.append(self.one("given mu(k2) > 0", "define mu by mu(0) = 1, mu(k2 + 1) = 2*mu(k2)",
                                       "define mu by mu(0) = x, mu(1) = 1, mu(k2 + 2) = mu(k2 + 1) + x*mu(k2)",
                                       "define mu, nu by mu(0) = x, nu(0) = 1, mu(k2 + 1) = nu(k2), nu(k2 + 1) = -mu(k2)"))
            self.families.append("mu")

    def define(self):
        if self.likely(0.4):
            self.lines.append(f"let g = {self.expr(2)}")
            self.reals.append("g")
        if self.likely(0.3):
            self.reals.append("s")
            self.lines.append(f"let f(s) = {self.one('sin(s)*x', 'cos(2*s)', self.expr(2), 's^2 + x', 'derivative(x*s, x)')}")
            self.reals.pop()
            self.functions.append("f")
        if self.likely(0.4):
            self.lines.append(f"let M = {self.one(f'[{self.simple()}, {self.simple()}; {self.simple()}, {self.simple()}]', self.matrix())}")
            self.matrices.append("M")
        if self.angles and self.likely(0.3):
            self.lines.append(f"let eps = {self.angle()}")
            self.angles.append("eps")

    def suppose(self):
        for _ in range(self.one(0, 1, 1, 2)):
            if len(self.angles) > 1 and self.likely(0.4):
                p = f"{self.angles[0]} + {self.angles[1]} = {self.one('pi', 'pi/2', '0', '2*pi')}"
            elif self.angles and self.likely(0.5):
                theta = self.one(*self.angles)
                p = self.one(f"{theta} < pi/2", f"{theta} >= pi/6", f"2*{theta} <= pi", f"0 <= {theta} < pi", f"sin({theta}) > 0",
                             f"x = cos({theta})")
            else:
                p = self.comparison()
            self.lines.append(f"assume {p}")

    def argument(self):
        if self.likely(0.8):
            return ""
        return " {\n  have l1: " + self.comparison(2) + " by algebra\n  case c1: " + self.comparison() + " { }\n}"

    def claim(self, name):
        self.declare()
        self.define()
        self.suppose()
        shared = self.chance.randrange(len(self.lines)) if self.likely(0.25) else 0
        lines = self.lines[:shared] + [f'claim {name} "a random claim"'] + self.lines[shared:]
        return "\n".join(lines + [f"prove {self.prop(2)}{self.argument()}"]) + "\n"


def main(out, count, seed="1"):
    os.makedirs(out, exist_ok=True)
    for k in range(int(count)):
        text = Maker(random.Random(f"{seed}/{k}")).claim(f"random-{k}")
        with open(os.path.join(out, f"random-{k}.claim"), "w", encoding="utf-8") as stream:
            stream.write(text)


if __name__ == "__main__":
    main(*sys.argv[1:])
