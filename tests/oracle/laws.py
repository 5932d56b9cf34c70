# SPDX-License-Identifier: Apache-2.0
"""Rest-to-rest motion laws (VDI 2143 names where it has one), normalized: f(0) = 0, f(1) = 1.

Every law is derived here, not copied: the trigonometric ones by integrating the shape of their acceleration twice
and scaling the stroke to 1, the polynomial ones by solving their boundary conditions. The published closed forms
and the six printed decimals of the usual coefficient table are then checked against the result, and a numerical
quadrature of the acceleration confirms the antiderivatives.
"""
from mpmath import mp, mpf

from exact import NOISE, ZERO, Piece, Piecewise, check_equal, check_printed, exact, hermite

PI = mp.pi


def harmonic(*terms):
    """f'' proportional to sum of amp * sin(2 pi k z)."""
    return [Piece(mpf(1), (), tuple((mpf(a), 2 * PI * k, ZERO) for k, a in terms))]


def rise(length):
    """Quarter sine 0 -> 1."""
    return Piece(length, (), ((mpf(1), PI / (2 * length), ZERO),))


def fall(length):
    """Quarter cosine 1 -> 0."""
    return Piece(length, (), ((mpf(1), PI / (2 * length), PI / 2),))


def hold(length, value=1):
    return Piece(length, (mpf(value),))


def symmetric(*half):
    return list(half) + [p.turned() for p in reversed(half)]


def from_acceleration(pieces):
    law = Piecewise(pieces).integral().integral()
    return law.scaled(1 / law(mpf(1)))


def from_rest_conditions(n):
    """The polynomial of degree 2n-1 whose derivatives 1..n-1 vanish at both ends."""
    rest = [ZERO] * (n - 1)
    return Piecewise([hermite(mpf(1), [ZERO] + rest, [mpf(1)] + rest)])


def q(n, d=1):
    return mpf(n) / d


def build():
    """name -> (law, closed forms, printed decimals); the printed ones are those of the usual coefficient table."""
    s3 = mp.sqrt(3)
    ca_ms = 4 * PI**2 / (4 + PI)
    ca_mt = 8 * PI / (2 + PI)
    cv_mcv = 8 * PI / (5 * PI + 4)
    return {
        "straight_line": (Piecewise([Piece(mpf(1), (ZERO, mpf(1)))]), {"cv": q(1)}, {"cv": "1"}),
        "quadratic_parabola": (
            from_acceleration(symmetric(hold(q(1, 2)))),
            {"cv": q(2), "ca": q(4), "cm": q(8), "rms_f2": q(4)}, {}),
        "simple_sine": (
            from_acceleration([Piece(mpf(1), (), ((mpf(1), PI, PI / 2),))]),
            {"cv": PI / 2, "ca": PI**2 / 2, "cm": PI**3 / 8, "cj_inside": PI**3 / 2},
            {"cv": "1.570796", "ca": "4.934802", "cm": "3.875785", "rms_f2": "3.489432", "cj_inside": "15.50314"}),
        "cubic_23": (
            from_rest_conditions(2),
            {"cv": q(3, 2), "ca": q(6), "cm": 2 * s3, "rms_f2": 2 * s3, "cj_inside": q(12)}, {"cm": "3.464102"}),
        "inclined_sine": (
            from_acceleration(harmonic((1, 1))),
            {"cv": q(2), "ca": 2 * PI, "cj": 4 * PI**2, "cm": 3 * s3 / 2 * PI},
            {"ca": "6.283185", "cj": "39.47842", "cm": "8.162097", "rms_f2": "4.442883"}),
        "modified_sine": (
            from_acceleration(symmetric(rise(q(1, 8)), fall(q(3, 8)))),
            {"cv": 4 * PI / (4 + PI), "ca": ca_ms, "cj": 16 * PI**3 / (4 + PI), "rms_f2": ca_ms / mp.sqrt(2)},
            {"cv": "1.759603", "ca": "5.527957", "cj": "69.46636", "cm": "5.457753", "rms_f2": "3.908856"}),
        "modified_trapezoid": (
            from_acceleration(symmetric(rise(q(1, 8)), hold(q(1, 4)), fall(q(1, 8)))),
            {"cv": q(2), "ca": ca_mt, "cj": 32 * PI**2 / (2 + PI), "rms_f2": ca_mt * s3 / 2},
            {"ca": "4.888124", "cj": "61.42597", "cm": "8.089981", "rms_f2": "4.233239"}),
        "poly_345": (
            from_rest_conditions(3),
            {"cv": q(15, 8), "ca": 10 / s3, "cj": q(60), "rms_f2": mp.sqrt(q(120, 7))},
            {"ca": "5.773503", "cm": "6.694269", "rms_f2": "4.140393"}),
        "poly_4567": (
            from_rest_conditions(4),
            {"cv": q(35, 16), "ca": 84 / (5 * mp.sqrt(5)), "cj": q(105, 2), "rms_f2": mp.sqrt(q(280, 11))},
            {"ca": "7.513188", "cm": "10.750226", "rms_f2": "5.045250"}),
        "poly_56789": (
            from_rest_conditions(5), {"cv": q(315, 128), "cj": q(315, 4)},
            {"ca": "9.371976", "cm": "15.435936", "rms_f2": "5.936729"}),
        "gutman_13": (
            from_acceleration(harmonic((1, 5), (3, 1))), {"cv": q(2), "cj": 6 * PI**2},
            {"ca": "5.130199", "cj": "59.21763", "cm": "8.124858", "rms_f2": "4.247690"}),
        "freudenstein_13": (
            from_acceleration(harmonic((1, 9), (3, 1))), {"cv": q(2), "ca": 12 * PI / 7, "cj": 36 * PI**2 / 7},
            {"ca": "5.385587", "cj": "50.75797", "cm": "7.917472", "rms_f2": "4.310573"}),
        "freudenstein_135": (
            from_acceleration(harmonic((1, 1), (3, q(1, 6)), (5, q(1, 50)))), {"cv": q(2)}, {}),
        "modified_constant_velocity_50": (
            from_acceleration(symmetric(rise(q(1, 16)), fall(q(3, 16)), hold(q(1, 4), 0))),
            {"cv": cv_mcv, "ca": 2 * PI * cv_mcv}, {"cv": "1.275258"}),
        "minimum_peak_jerk": (
            Piecewise([hold(q(1, 4)), hold(q(1, 2), -1), hold(q(1, 4))]).integral().integral().integral(),
            {"cv": q(2), "ca": q(8), "cj": q(32), "rms_f2": 8 / s3}, {"cm": "8.709297", "rms_f2": "4.618802"}),
    }


def normalized(law):
    return law.scaled(1 / law(mpf(1)))


def peak_product(f1, f2):
    """max |f' f''|: the ends and the zeros of f''^2 + f' f''' in every piece."""
    best = ZERO
    for v, a in zip(f1.pieces, f2.pieces):
        j = a.derivative()
        grid = [v.length * i / 240 for i in range(241)]
        values = [a(u) ** 2 + v(u) * j(u) for u in grid]
        points = list(grid)
        for i in range(240):
            if values[i] * values[i + 1] < 0:
                points.append(mp.findroot(lambda u: a(u) ** 2 + v(u) * j(u), (grid[i], grid[i + 1]),
                                          solver="anderson", tol=mpf(10) ** -100, verify=False))
        best = max([best] + [abs(v(u) * a(u)) for u in points])
    return best


def coefficients(f):
    f1, f2, f3 = f.derivative(1), f.derivative(2), f.derivative(3)
    smooth_velocity = f1.jumps() < NOISE
    smooth_acceleration = smooth_velocity and f2.jumps() < NOISE
    square = sum((mp.quad(lambda u, p=p: p(u) ** 2, [ZERO, p.length / 2, p.length]) for p in f2.pieces), ZERO)
    return {
        "cv": f1.peak()[1],
        "ca": f2.peak()[1] if smooth_velocity else None,
        "ca_inside": f2.peak()[1],
        "cj": f3.peak()[1] if smooth_acceleration else None,
        "cj_inside": f3.peak()[1],
        "cm": peak_product(f1, f2) if smooth_velocity else None,
        "rms_f2": mp.sqrt(square) if smooth_velocity else None,
        "z_of_cv": f1.peak()[0],
        "z_of_ca": f2.peak()[0],
    }


def sample_points():
    """i/40, and ten multiples of the golden ratio (mod 1), as doubles."""
    golden = (mp.sqrt(5) - 1) / 2
    return [float(i / 40) for i in range(41)] + [float(mp.frac(k * golden)) for k in range(1, 11)]


def witness(name, f):
    """Quadrature of f'' must return f' and f at a few points."""
    f1, f2 = f.derivative(1), f.derivative(2)
    start = f1(ZERO)
    for z in (q(1, 5), q(7, 11), mpf(1)):
        marks = [k for k in f2.knots if k < z] + [z]
        velocity = start + mp.quad(f2, marks)
        position = start * z + mp.quad(lambda x, z=z: (z - x) * f2(x), marks)
        check_equal(f"{name}: quadrature of f'' at {mp.nstr(z, 3)}", velocity, f1(z), mpf(10) ** -30)
        check_equal(f"{name}: double quadrature at {mp.nstr(z, 3)}", position, f(z), mpf(10) ** -30)


def make():
    points = sample_points()
    result = {"z": points, "laws": {}, "sum_seven_segment": {}}
    for name, (law, closed, printed) in build().items():
        f = normalized(law)
        values = coefficients(f)
        witness(name, f)
        for key, value in closed.items():
            check_equal(f"{name} {key} closed form", values[key], value)
        for key, digits in printed.items():
            check_printed(f"{name} {key}", digits, values[key])
        entry = dict(values, knots=[k for k in f.knots], printed=printed)
        for key, order in (("f", 0), ("f1", 1), ("f2", 2), ("f3", 3)):
            curve = f.derivative(order)
            entry[key] = [curve(exact(z)) for z in points]
        result["laws"][name] = entry
    check_equal("3-4-5 peak acceleration at", result["laws"]["poly_345"]["z_of_ca"], (3 - mp.sqrt(3)) / 6)
    result["sum_seven_segment"] = seven_segment_sums(result["laws"])
    return result


def seven_segment_sums(laws):
    """1/Cv + Cv/Ca + Ca/Cj: at most 1 for every law whose bound has all plateaus."""
    printed = {"modified_trapezoid": "0.9887", "inclined_sine": "0.9775", "modified_sine": "0.9662",
               "poly_345": "0.9543", "poly_4567": "0.8914"}
    sums = {}
    for name, digits in printed.items():
        c = laws[name]
        sums[name] = 1 / c["cv"] + c["cv"] / c["ca"] + c["ca"] / c["cj"]
        check_printed(f"seven-segment sum of {name}", digits, sums[name])
    parabola = laws["quadratic_parabola"]
    sums["quadratic_parabola"] = 1 / parabola["cv"] + parabola["cv"] / parabola["ca"]  # Cj infinite
    check_equal("seven-segment sum of the parabola", sums["quadratic_parabola"], mpf(1))
    return sums
