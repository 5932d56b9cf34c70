// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "plot/src/figure/curve_figure.hpp"

namespace jounce {

/// The cam of PMC600 manual, Fig. 6.14.
inline Cam pmc600_cam() {
  const auto knot = [](double master, double slave, double v) {
    return CamKnot{master, slave, v, 0.0};
  };
  return design({.start = knot(0, 0, 0),
                 .segments = {{Law::quintic, knot(75, 100, 1), ""},
                              {Law::quintic, knot(200, 225, 1), ""},
                              {Law::quintic, knot(280, 100, 0.01739120485), ""},
                              {Law::quintic, knot(360, 0, 0), ""}},
                 .periodic = true})
      .cam;
}

/// Its look: limits that its third segment breaks, and the synchronous stretch.
inline CurveLook pmc600_look() {
  CurveLook look;
  look.title = "PMC600 Fig. 6.14";
  look.axis_unit = "pulse";
  look.unit = "pulse";
  look.limits.velocity = 3;
  look.limits.acceleration = 0.15;
  look.shades = {{75, 200, "synchronous"}};
  return look;
}

/// Accelerates at 20 for 0.5 s, runs at 10 until 5.125 s, brakes at 40 until 5.375 s.
inline Trajectory trapezoid_move() {
  return trapezoid({.to = 50, .velocity = 10, .acceleration = 20, .deceleration = 40}).curve();
}

}  // namespace jounce
