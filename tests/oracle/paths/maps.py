# SPDX-License-Identifier: Apache-2.0
"""Joints of four machines along straight lines: position and three derivatives by the arc length of the line.

Each machine is its forward map or its geometric condition; the joints are solved from it at a point, and their
derivatives come from the Taylor coefficients of the solution (finite differences with 60 digits).
"""
from exact import check_equal, exact
from mpmath import acos, atan2, cos, mp, mpf, pi, sin, sqrt
from paths.shapes import minus, norm, plus, times, unit
from paths.study import given


def scara(p, l1, l2, elbow):
    """Joint angles in rad; the first from x, the second relative to the first; elbow: the sign of the second."""
    c = (p[0] ** 2 + p[1] ** 2 - l1**2 - l2**2) / (2 * l1 * l2)
    second = elbow * acos(c)
    return [atan2(p[1], p[0]) - atan2(l2 * sin(second), l1 + l2 * cos(second)), second]


def scara_forward(joints, l1, l2):
    a, b = joints
    return [l1 * cos(a) + l2 * cos(a + b), l1 * sin(a) + l2 * sin(a + b)]


def delta(p, outer, inner, rod, angles):
    """Heights of the carriages on three vertical rails at `outer` from the axis; the rods meet the plate at `inner`."""
    heights = []
    for degrees in angles:
        a = pi * mpf(degrees) / 180
        x, y = p[0] + (inner - outer) * cos(a), p[1] + (inner - outer) * sin(a)
        heights.append(p[2] + sqrt(rod**2 - x * x - y * y))
    return heights


def along(joints_of, start, direction, at):
    """Per joint: value and three derivatives at start + at * direction."""
    count = len(joints_of(start))
    place = lambda q: plus(start, times(q, direction))
    return [[mp.diff(lambda q, k=k: joints_of(place(q))[k], at, n) for n in range(4)] for k in range(count)]


def make_maps(rng):
    draw = lambda low, high: round(rng.uniform(low, high), 3)
    out = {"scara": [], "delta": [], "corexy": []}
    for i in range(12):
        l1, l2 = (1000.0, 1000.0) if i == 0 else (draw(100, 500), draw(100, 500))
        reach = lambda: [draw(0.2, 0.9) * (l1 + l2) * x for x in (1.0, 0.3 * rng.choice((-1, 1)))]
        start, end = reach(), reach()
        elbow = 1 if i % 2 else -1
        radii = [norm(given(start)), norm(given(end))]
        if min(radii) < 1.2 * abs(l1 - l2) or max(radii) > 0.97 * (l1 + l2) or start == end:
            continue
        direction, way = unit(minus(given(end), given(start))), norm(minus(given(end), given(start)))
        solve = lambda p: scara(p, mpf(l1), mpf(l2), elbow)
        joints = along(solve, given(start), direction, way / 3)
        back = scara_forward([j[0] for j in joints], mpf(l1), mpf(l2))
        for a, b in zip(back, plus(given(start), times(way / 3, direction))):
            check_equal("SCARA", a, b, mpf(10) ** -40)
        out["scara"].append({"arms": [l1, l2], "second_joint_sign": elbow, "from": start, "to": end, "joints_at_third": joints})
    check_equal("SCARA stretched", scara_forward([mpf(0), mpf(0)], mpf(1000), mpf(1000))[0], mpf(2000))
    for _ in range(8):
        outer, inner, rod = draw(150, 250), draw(30, 60), draw(260, 400)
        start, end = [[draw(-80, 80), draw(-80, 80), draw(-50, 50)] for _ in range(2)]
        angles = [90, 210, 330]
        solve = lambda p: delta(p, exact(outer), exact(inner), exact(rod), angles)
        direction, way = unit(minus(given(end), given(start))), norm(minus(given(end), given(start)))
        out["delta"].append({"outer_radius": outer, "inner_radius": inner, "rod": rod, "angles_deg": angles, "from": start,
                             "to": end, "joints_at_third": along(solve, given(start), direction, way / 3)})
    for start, end in (([0.0, 0.0], [30.0, 40.0]), ([10.0, -5.0], [10.0, 7.0])):
        direction = unit(minus(given(end), given(start)))
        x = plus(given(start), times(norm(minus(given(end), given(start))) / 3, direction))
        u = direction
        out["corexy"].append({"from": start, "to": end, "motors_at_third": [[x[0] + x[1], u[0] + u[1]], [x[0] - x[1], u[0] - u[1]]]})
    return out
