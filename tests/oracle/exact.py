# SPDX-License-Identifier: Apache-2.0
"""High-precision building blocks of the oracles: numbers, piecewise functions, exact extrema, JSON.

No motion law is built in. A `Piece` is a function of the local coordinate u in [0, length]:

    p(u) = sum_k poly[k] u^k + sum_i amp_i sin(omega_i u + phase_i)

and a `Piecewise` is a run of pieces. Both are closed under derivative and integral, so every oracle starts from
an acceleration (or from boundary values) and integrates. Work is done with 60 digits; 17 are written.
"""
import json
import sys
from bisect import bisect_right
from dataclasses import dataclass
from decimal import ROUND_DOWN, ROUND_HALF_UP, Decimal, localcontext

from mpmath import mp, mpf

mp.dps = 60
ZERO = mpf(0)
NOISE = mpf(10) ** -40  # results below this are rounding noise of a zero


def exact(x):
    """The exact value of the double nearest to x: what a reader of the JSON file gets as input."""
    return mpf(float(x))


# ---------------------------------------------------------------------------------------------- functions

@dataclass(frozen=True)
class Piece:
    length: mpf
    poly: tuple = ()
    sines: tuple = ()  # (amp, omega, phase)

    def __call__(self, u):
        value = mp.polyval(self.poly[::-1], u) if self.poly else ZERO
        return value + sum((a * mp.sin(w * u + p) for a, w, p in self.sines), ZERO)

    def derivative(self):
        return Piece(self.length, tuple(k * c for k, c in enumerate(self.poly))[1:],
                     tuple((a * w, w, p + mp.pi / 2) for a, w, p in self.sines))

    def integral(self, start):
        """The antiderivative that equals `start` at u = 0."""
        sines = tuple((-a / w, w, p + mp.pi / 2) for a, w, p in self.sines)
        constant = start - sum((a * mp.sin(p) for a, _, p in sines), ZERO)
        return Piece(self.length, (constant,) + tuple(c / (k + 1) for k, c in enumerate(self.poly)), sines)

    def scaled(self, factor):
        return Piece(self.length, tuple(factor * c for c in self.poly),
                     tuple((factor * a, w, p) for a, w, p in self.sines))

    def turned(self):
        """Point reflection: u -> -p(length - u), the second half of a symmetric acceleration."""
        shifted = [ZERO] * len(self.poly)
        for k, c in enumerate(self.poly):  # c (length - u)^k
            for i in range(k + 1):
                shifted[i] += c * mp.binomial(k, i) * self.length ** (k - i) * (-1) ** i
        return Piece(self.length, tuple(-c for c in shifted),
                     tuple((a, w, -w * self.length - p) for a, w, p in self.sines))

    def zeros(self):
        if not self.sines:
            return polynomial_zeros(list(self.poly), self.length)
        return bracketed_zeros(self, [self.length * i / 240 for i in range(241)])


class Piecewise:
    def __init__(self, pieces, start=ZERO):
        self.pieces = tuple(pieces)
        self.knots = [start]
        for piece in self.pieces:
            self.knots.append(self.knots[-1] + piece.length)

    def __call__(self, x, left=False):
        """Value at x: the right limit at a knot (the left limit at the end, or where asked for)."""
        i = bisect_right(self.knots, x) - 1
        if i >= len(self.pieces) or (left and i > 0 and x == self.knots[i]):
            i -= 1
        return self.pieces[i](x - self.knots[i])

    def derivative(self, order=1):
        result = self
        for _ in range(order):
            result = Piecewise([p.derivative() for p in result.pieces], result.knots[0])
        return result

    def integral(self, start=ZERO):
        pieces = []
        for piece in self.pieces:
            pieces.append(piece.integral(start))
            start = pieces[-1](piece.length)
        return Piecewise(pieces, self.knots[0])

    def scaled(self, factor):
        return Piecewise([p.scaled(factor) for p in self.pieces], self.knots[0])

    def jumps(self):
        """Largest |right limit - left limit|, the outside being zero."""
        inner = [abs(b(ZERO) - a(a.length)) for a, b in zip(self.pieces, self.pieces[1:])]
        return max(inner + [abs(self(self.knots[0])), abs(self(self.knots[-1]))])

    def candidates(self):
        """(x, value) at both ends and every critical point of every piece, one-sided at knots."""
        for knot, piece in zip(self.knots, self.pieces):
            for u in [ZERO, *piece.derivative().zeros(), piece.length]:
                yield knot + u, piece(u)

    def maximum(self):
        return first_best(self.candidates(), lambda value: value)

    def minimum(self):
        return first_best(self.candidates(), lambda value: -value)

    def peak(self):
        """(x, |value|) of the largest magnitude."""
        return first_best(((x, abs(v)) for x, v in self.candidates()), lambda value: value)


def first_best(candidates, key):
    """The leftmost of the best (x, value); a tie within 1e-40 does not count as better."""
    best = None
    for x, value in sorted(candidates, key=lambda c: c[0]):
        if best is None or key(value) > key(best[1]) + NOISE * max(1, abs(value)):
            best = (x, value)
    return best


def bisect(function, low, high):
    """Root of `function` in a bracket, to the last digits, by Ridders' method: each step at least halves the bracket."""
    f_low, f_high = function(low), function(high)
    if f_low == 0 or f_high == 0:
        return low if f_low == 0 else high
    assert (f_low < 0) != (f_high < 0), "no sign change"
    last = None
    for _ in range(1200):
        middle = (low + high) / 2
        small = mpf(10) ** -(mp.dps - 4) * abs(middle)
        f_middle = function(middle)
        if f_middle == 0:
            return middle
        x = middle + (middle - low) * (1 if f_low > f_high else -1) * f_middle / mp.sqrt(f_middle**2 - f_low * f_high)
        f_x = function(x)
        if f_x == 0 or last is not None and abs(x - last) <= small or abs(high - low) <= small:
            return x
        last = x
        inner = sorted([(low, f_low), (middle, f_middle), (x, f_x), (high, f_high)])
        (low, f_low), (high, f_high) = next(pair for pair in zip(inner, inner[1:]) if (pair[0][1] < 0) != (pair[1][1] < 0))
    return (low + high) / 2


def bracketed_zeros(function, grid):
    """Zeros of a function at its sign changes over a grid; a grid value that is rounding noise counts as zero."""
    values = [function(u) for u in grid]
    noise = NOISE * max(abs(v) for v in values)
    values = [ZERO if abs(v) < noise else v for v in values]
    found = [u for u, v in zip(grid, values) if v == 0]
    for a, b, fa, fb in zip(grid, grid[1:], values, values[1:]):
        if fa * fb < 0:
            found.append(bisect(function, a, b))
    return sorted(found)


def polynomial_zeros(coefficients, length):
    """All sign changes of a polynomial (low order first) in [0, length], isolated by its own critical points."""
    while coefficients and coefficients[-1] == 0:
        coefficients.pop()
    if len(coefficients) < 2:
        return []
    slopes = [k * c for k, c in enumerate(coefficients)][1:]
    grid = [ZERO, *polynomial_zeros(slopes, length), length]
    return bracketed_zeros(lambda u: mp.polyval(coefficients[::-1], u), grid)


def hermite(length, left, right):
    """The polynomial piece with the given value, first, second ... derivatives at both ends (linear solve)."""
    n = len(left)
    rows, rhs = [], []
    for derivatives, u in ((left, ZERO), (right, length)):
        for order, value in enumerate(derivatives):
            rows.append([mp.ff(k, order) * u ** (k - order) if k >= order else ZERO for k in range(2 * n)])
            rhs.append(value)
    solution = mp.lu_solve(mp.matrix(rows), mp.matrix(rhs))
    return Piece(length, tuple(solution))


# ------------------------------------------------------------------------------------------ printed digits

MISMATCHES = []  # disagreements, as text
CHECKS = [0]  # number of comparisons


def to_decimal(value):
    return Decimal(mp.nstr(value, 55, strip_zeros=False))


def digits_agree(printed, value):
    """'rounded', 'truncated', 'both' or None: how a printed decimal relates to the value."""
    with localcontext() as context:
        context.prec = 60
        last = Decimal(1).scaleb(Decimal(printed).as_tuple().exponent)
        ways = [name for name, rule in (("rounded", ROUND_HALF_UP), ("truncated", ROUND_DOWN))
                if to_decimal(value).quantize(last, rounding=rule) == Decimal(printed)]
    return "both" if len(ways) == 2 else (ways[0] if ways else None)


def check_printed(what, printed, value, allow_truncated=False):
    """Records a disagreement unless the printed digits are the value's, rounded (or, if allowed, cut off)."""
    CHECKS[0] += 1
    relation = digits_agree(printed, value)
    if relation is None or (relation == "truncated" and not allow_truncated):
        MISMATCHES.append(f"{what}: printed {printed}, computed {mp.nstr(value, 17)}")
    return relation


def check_equal(what, a, b, tolerance=mpf(10) ** -45):
    """Two derivations of one number must agree."""
    CHECKS[0] += 1
    if abs(a - b) > tolerance * max(1, abs(a), abs(b)):
        MISMATCHES.append(f"{what}: {mp.nstr(a, 20)} and {mp.nstr(b, 20)} should be equal")


# ------------------------------------------------------------------------------------------------- output

def number(x):
    if isinstance(x, float):  # an input: shortest text that reads back as the same double
        text = repr(x)
        return text[:-2] if text.endswith(".0") else text
    if abs(x) < NOISE:
        return "0"
    text = mp.nstr(x, 17, min_fixed=-5, max_fixed=18)
    mantissa, _, exponent = text.partition("e")
    if "." in mantissa:
        mantissa = mantissa.rstrip("0").rstrip(".")
    return mantissa + ("e" + exponent if exponent else "")


def to_json(value, indent=0):
    """JSON with sorted keys; lists of plain values stay on one line (wrapped)."""
    pad = " " * (indent + 1)
    if value is None or isinstance(value, bool):
        return {None: "null", True: "true", False: "false"}[value]
    if isinstance(value, str):
        return json.dumps(value)
    if isinstance(value, int):
        return str(value)
    if isinstance(value, dict):
        rows = [f"{pad}{json.dumps(k)}: {to_json(value[k], indent + 1)}" for k in sorted(value)]
        return "{\n" + ",\n".join(rows) + "\n" + " " * indent + "}"
    if isinstance(value, (list, tuple)):
        items = [to_json(v, indent + 1) for v in value]
        if not any(isinstance(v, (dict, list, tuple)) for v in value):
            return "[" + wrap(items, pad) + "]"
        return "[\n" + ",\n".join(pad + item for item in items) + "\n" + " " * indent + "]"
    return number(value)


def wrap(items, pad, width=110):
    lines, line = [], ""
    for item in items:
        if line and len(line) + len(item) + 2 > width:
            lines.append(line + ",")
            line = ""
        line += (", " if line else "") + item
    return f"\n{pad}".join(lines + [line])


def finish(target, result):
    """Writes `result` to the file, or compares it with the file if the option --check is given. The exit status."""
    if MISMATCHES:
        print("\n".join(["DISAGREEMENT:"] + MISMATCHES), file=sys.stderr)
        return 1
    text = to_json(result) + "\n"
    print(f"{CHECKS[0]} printed or doubly derived numbers agree")
    if "--check" in sys.argv[1:]:
        same = target.exists() and target.read_text(encoding="ascii") == text
        print(f"{target.name} is {'up to date' if same else 'OUT OF DATE'}")
        return 0 if same else 1
    target.write_text(text, encoding="ascii")
    print(f"{target.name}: {len(text)} bytes")
    return 0
