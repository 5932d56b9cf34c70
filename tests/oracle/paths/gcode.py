# SPDX-License-Identifier: Apache-2.0
"""Programs as G-code, and their geometry as jobs for path_judge.py; feeds in mm/min, lengths in mm."""
import math
from decimal import Decimal

from paths.job import Arc, Line

FEED = 6000  # mm/min
LIMITS = {"acceleration": 1000.0, "jerk": 10000.0}


def line(to, **more):
    return {"type": "line", "to": [float(c) for c in to], **more}


def arc(to, center, clockwise=False, **more):
    return {"type": "arc", "to": [float(c) for c in to], "center": [float(c) for c in center],
            "clockwise": clockwise, **more}


def text_of(x):
    """A decimal without exponent, at most twelve places."""
    text = format(Decimal(repr(round(x, 12))), "f")
    return text.rstrip("0").rstrip(".") if "." in text else text


def words(letters, values):
    return " ".join(letter + text_of(v) for letter, v in zip(letters, values))


def gcode(start, pieces, deviation):
    """Text of a program, and its pieces with the line each is on. Deviation 0 stops at every corner."""
    rows = ["G21 G90 G17 G61" if deviation == 0 else f"G21 G90 G17 G64 P{text_of(deviation)}", "G0 " + words("XYZ", start)]
    at, numbered, feed = start, [], None
    for piece in pieces:
        wanted = piece.get("feed", FEED / 60) * 60
        mark = "" if wanted == feed else f" F{text_of(wanted)}"
        feed = wanted
        if piece["type"] == "line":
            rows.append(f"G1 {words('XYZ', piece['to'])}{mark}")
        else:
            offset = [c - p for c, p in zip(piece["center"], at)]
            rows.append(f"G{2 if piece['clockwise'] else 3} {words('XYZ', piece['to'])} {words('IJ', offset)}{mark}")
        at = piece["to"]
        numbered.append({**piece, "line": len(rows)})
    return "".join(f"N{i + 1} {row}\n" for i, row in enumerate(rows + ["M30"])), numbered


def passed(start, pieces):
    """For each piece: if G61, the exact path, passes the joint at its end (decision 0095).

    G61 passes a joint if the directions on both sides are equal to 1e-9. A line without length has no direction.
    """
    starts = [start, *(piece["to"] for piece in pieces)]
    shapes = [Line(a, p["to"]) if p["type"] == "line" else Arc(a, p["to"], p) for a, p in zip(starts, pieces)]
    result, ahead = [], None
    for shape in reversed(shapes):
        result.append(ahead is not None and (shape.length == 0 or math.dist(shape.ends, ahead.begins) < 1e-9))
        ahead = shape if shape.length > 0 else ahead
    return result[::-1]


def job(start, pieces, deviation, feed=FEED / 60):
    """The geometry and limits for path_judge.py; the curves of the axes are added by the test."""
    corners = [{**p, "deviation": float(deviation), "stop": i + 1 == len(pieces) or (deviation == 0 and not passes)}
               for i, (p, passes) in enumerate(zip(pieces, passed(start, pieces)))]
    names = "XYZUVW"[:len(start)]
    return {"jounce_path_job": 1, "axes": [{"name": n, **LIMITS} for n in names], "path": {"velocity": feed},
            "start": [float(c) for c in start], "pieces": corners}
