# SPDX-License-Identifier: Apache-2.0
"""Adversarial programs, each with the outcome that a planner must have: a plan, or an error that names the line."""
from paths import formulas
from paths.gcode import arc, gcode, job, line


def plan(name, start, pieces, why, deviation=0.05, like=None):
    """A program that must be planned. `like`: another program whose time it must have, to 1e-9."""
    text, numbered = gcode(start, pieces, deviation)
    return name, text, {"outcome": "plan", "why": why, **({"like": like} if like else {})}, job(start, numbered, deviation)


def planned_text(name, rows, why, like=None):
    return name, numbered_rows(rows), {"outcome": "plan", "why": why, **({"like": like} if like else {})}, None


def error(name, rows, at, why):
    """A program that must be refused; `at` is the line of the file, from 1."""
    return name, numbered_rows(rows), {"outcome": "error", "line": at, "why": why}, None


def either(name, rows, at, why):
    """A plan within the limits, or an error that names the line."""
    return name, numbered_rows(rows), {"outcome": "plan or error", "line": at, "why": why}, None


def numbered_rows(rows):
    return "".join(f"N{i + 1} {row}\n" for i, row in enumerate(rows))


HEAD = ["G21 G90 G17 G64 P0.05", "G0 X0 Y0"]


def moves(*rows):
    return [*HEAD, *rows, "M30"]


def polyline(*points):
    return [line(p) for p in points]


def adversaries():
    o, big, far = [0.0, 0.0], 1e9, 1e6
    corner = polyline([10, 0], [10, 10])
    noisy = [[i * 1e-9, (i % 2) * 1e-9] for i in range(1, 101)]
    return [
        # zero lengths and points that nearly coincide
        plan("plain_corner", o, corner, "the twin of the next ones"),
        plan("zero_first", o, polyline([0, 0], [10, 0], [10, 10]), "the first move has no length", like="plain_corner"),
        plan("zero_middle", o, polyline([10, 0], [10, 0], [10, 10]), "a move without length at the corner", like="plain_corner"),
        plan("zero_last", o, polyline([10, 0], [10, 10], [10, 10]), "the last move has no length", like="plain_corner"),
        plan("zero_ten_times", o, polyline([10, 0], *[[10, 0]] * 10, [10, 10]), "ten moves without length", like="plain_corner"),
        plan("apart_1e-9", o, polyline([10, 0], [10, 1e-9], [10, 10]), "two corners 1e-9 mm apart"),
        plan("apart_1e-12", o, polyline([10, 0], [10 + 1e-12, 0], [10, 10]), "two corners 1e-12 mm apart"),
        plan("hundred_1e-9_ahead", o, polyline(*[[i * 1e-9, 0] for i in range(1, 101)], [10, 0]), "100 pieces of 1e-9 mm, then a line"),
        plan("hundred_1e-9_zigzag", o, polyline(*noisy, [10, 0]), "100 corners within 1e-7 mm, then a line"),
        plan("hundred_1e-9_only", o, polyline(*noisy), "the whole path is 1e-7 mm long"),
        plan("whole_1e-12", o, polyline([1e-12, 0]), "the whole path is 1e-12 mm long"),
        plan("collinear", o, polyline([2, 0], [5, 0], [10, 0], [10, 3], [10, 10]), "points within the legs", like="plain_corner"),
        plan("nearly_collinear", o, polyline([5, 1e-12], [10, 0], [10, 10]), "a bend of 4e-13 rad"),
        either("no_motion", moves("G1 X0 Y0 F6000", "G1 X0 Y0"), 1, "all moves are without length"),
        either("empty", [], 1, "an empty file"),
        either("only_head", ["G21 G90", "M30"], 1, "no move at all"),
        planned_text("no_words", moves("G1 F6000", "X10", "Y10"), "G1 without axes, then modal moves", like="plain_corner"),
        # reversals
        plan("reversal", o, polyline([10, 0], [0, 0]), "180 degrees: the axis must stop at X10"),
        plan("reversal_20", o, polyline(*[[10 * (1 - i % 2), 0] for i in range(20)]), "20 reversals"),
        plan("reversal_short", o, polyline([10, 0], [9.999, 0], [20, 0]), "back by 1 um and on"),
        plan("reversal_space", [0.0, 0.0, 0.0], polyline([3, 4, 5], [0, 0, 0], [3, 4, 5]), "reversals along a diagonal"),
        plan("nearly_reversed", o, polyline([10, 0], [0, 1e-6]), "180 degrees less 1e-7 rad"),
        plan("hairpin", o, polyline([100, 0], [100, 0.001], [0, 0.001]), "two corners 1 um apart that turn back"),
        plan("cusp_of_arcs", o, [arc([10, 0], [5, 0], True), arc([0, 0], [5, 0], False)], "an arc and back along it"),
        # legs too short for the tolerance
        plan("no_room", o, polyline([0.01, 0], [0.01, 0.01], [0.02, 0.01]), "legs of 0.01 mm, tolerance 10 mm", 10),
        plan("long_short_long", o, polyline([100, 0], [100, 0.01], [200, 0.01]), "0.01 mm between two long legs", 5),
        plan("stairs_no_room", o, polyline(*[[(i + 1) // 2 * 0.1, i // 2 * 0.1] for i in range(1, 201)]), "200 legs of 0.1 mm", 1),
        plan("arc_no_room", o, [line([100, 0]), arc([100.002, 0], [100.001, 0], True), line([200, 0])], "an arc of 1 um radius", 1),
        plan("stops", o, corner, "tolerance 0 stops at the corner", 0),
        plan("tiny_tolerance", o, corner, "tolerance 1e-9 mm: no slower than stopping", 1e-9),
        error("negative_tolerance", ["G21 G90 G64 P-0.1", "G1 X10 F6000", "M30"], 1, "P below 0"),
        # arcs
        plan("full_circle", [50.0, 0.0], [arc([50, 0], [0, 0])], "start and end coincide"),
        plan("two_half_circles", [50.0, 0.0], [arc([-50, 0], [0, 0]), arc([50, 0], [0, 0])], "no stop between", like="full_circle"),
        plan("tangent_line", [50.0, -50.0], [line([50, 0]), arc([-50, 0], [0, 0]), line([-50, -50])], "only the curvature jumps"),
        plan("helix", [50.0, 0.0, 0.0], [arc([50, 0, 20], [0, 0])], "one turn of pitch 20"),
        plan("huge_radius", o, [arc([10, 0], [5, far])], "radius 1e6 mm, chord 10 mm"),
        planned_text("misfit_small", moves("G1 X50 Y0 F6000", "G3 X0 Y50.000001 I-50 J0"), "radii differ by 1e-6 mm"),
        error("misfit_large", moves("G1 X50 Y0 F6000", "G3 X0 Y51 I-50 J0"), 4, "radii 50 and 51 mm"),
        error("radius_below_half_chord", moves("G2 X10 Y0 R4.9 F6000"), 3, "chord 10 mm, radius 4.9 mm"),
        planned_text("radius_is_half_chord", moves("G2 X10 Y0 R5 F6000"), "a half circle by its radius"),
        planned_text("radius_rounded_half_chord", moves("G1 X3 Y0 F6000", "G2 X10 Y7 R4.949747"), "radius 4.68e-7 mm below half the chord"),
        error("radius_zero", moves("G2 X10 Y0 R0 F6000"), 3, "radius 0"),
        error("radius_full_circle", moves("G2 X0 Y0 R5 F6000"), 3, "a radius does not define a full circle"),
        error("center_is_start", moves("G2 X10 Y0 I0 J0 F6000"), 3, "the center is the start"),
        error("center_is_end", moves("G2 X10 Y0 I10 J0 F6000"), 3, "the center is the end"),
        error("arc_without_center", moves("G2 X10 Y0 F6000"), 3, "neither I, J nor R"),
        error("arc_both_forms", moves("G2 X10 Y0 I5 J0 R5 F6000"), 3, "I and R"),
        either("nearly_full_circle", moves("G1 X50 Y0 F6000", "G3 X50 Y0.000000001 I-50 J0"), 4, "1e-9 mm after the start"),
        either("tiny_circle", moves("G2 X0 Y0 I0.000000001 J0 F6000"), 3, "radius 1e-9 mm"),
        # numbers
        plan("far_detail", [big, big],
             polyline([big + 1e-6, big], [big + 1e-6, big + 1e-6], [big + 1, big + 1e-6]), "details of 1e-6 at 1e9"),
        plan("far_square", [big, big], [line([big + x, big + y]) for x, y in formulas.square()[1:]], "a square of 100 mm at 1e9"),
        plan("long_way", [-big, 0.0], polyline([big, 0], [big, 1e-6]), "2e9 mm, then 1e-6 mm"),
        either("beyond_doubles", moves("G1 X1" + "0" * 400 + " F6000"), 3, "a coordinate of 1e400"),
        error("not_a_number", moves("G1 Xnan F6000"), 3, "a coordinate without digits"),
        error("two_points", moves("G1 X1.2.3 F6000"), 3, "a number with two decimal points"),
        error("feed_zero", moves("G1 X10 F0"), 3, "feed 0"),
        error("feed_negative", moves("G1 X10 F-100"), 3, "feed below 0"),
        # words
        error("word_twice", moves("G1 X1 X2 F6000"), 3, "X twice"),
        error("two_motions", moves("G1 G2 X10 Y0 R5 F6000"), 3, "G1 and G2 in one line"),
        error("spline_code", moves("G1 X10 F6000", "G5 X20 Y0 I1 J1 P1 Q1"), 4, "G5 is not of the subset"),
        error("code_without_number", moves("G X10 F6000"), 3, "G without a number"),
        error("open_comment", moves("G1 X10 F6000", "G1 X20 (to the end"), 4, "a comment that does not end"),
        error("dwell_negative", moves("G1 X10 F6000", "G4 P-1", "G1 X20"), 4, "a dwell of -1"),
        planned_text("dwell_zero", moves("G1 X10 F6000", "G4 P0", "G1 X20"), "a dwell of 0"),
        planned_text("increments", [*HEAD, "G91", *["G1 X0.000000001 F6000"] * 50, "G1 X10", "M30"], "50 increments of 1e-9 mm"),
        planned_text("inches_and_back", ["G20 G90 G17 G64 P0.001", "G0 X0 Y0", "G1 X1 F200", "G21", "G1 X50.8 F6000", "M30"],
                     "inches, then mm"),
        planned_text("crlf", [row + "\r" for row in moves("G1 X10 Y0 F6000", "G1 X10 Y10")], "lines that end with CR LF",
                     like="plain_corner"),
        planned_text("long_comment", moves("G1 X10 Y0 F6000 (" + "x" * 10000 + ")", "G1 X10 Y10"), "a comment of 10000 characters",
                     like="plain_corner"),
    ]
