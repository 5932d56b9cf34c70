// SPDX-License-Identifier: Apache-2.0
// A feed hold and a resume on the path, two axes along one clock; then a uniform retiming.
#include <cstdio>
#include <vector>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/profiles/sequences/override.hpp"
#include "jounce/profiles/sequences/retime.hpp"

using namespace jounce;

int main() {
  const Trajectory x = s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100}).curve();
  const std::vector axes{x, scaled(x, 0.5)};  // a straight line in x and y
  const std::vector<Limits> limits{{.velocity = 10, .acceleration = 20, .jerk = 100},
                                   {.velocity = 5, .acceleration = 10, .jerk = 50}};

  const Overridden played = overridden(axes, limits, {.requests = {{2, 0}, {4, 1}}});
  for (const FactorRamp& ramp : played.ramps)
    std::printf("factor %g from %.3g s, reached at %.3g s\n", ramp.factor, ramp.begin, ramp.end);
  const double held_x = played.axes[0].at(3).position;
  const double held_y = played.axes[1].at(3).position;
  std::printf("held at (%.4g, %.4g), arrives after %.4g s instead of %.4g s\n", held_x, held_y,
              played.clock.end(), x.end());
  std::printf("limits kept: %s, %s\n", check(played.axes[0], limits[0]).ok() ? "yes" : "no",
              check(played.axes[1], limits[1]).ok() ? "yes" : "no");

  const Limits slower{.velocity = 8, .acceleration = 5, .jerk = 100};
  std::printf("for %g, %g, %g it must take %.4g times as long\n", *slower.velocity,
              *slower.acceleration, *slower.jerk, least_stretch(x, slower));
}

// > factor 0 from 2 s, reached at 2.7 s
// > factor 1 from 4 s, reached at 4.7 s
// > held at (20, 10), arrives after 7.7 s instead of 5.7 s
// > limits kept: yes, yes
// > for 8, 5, 100 it must take 2 times as long
