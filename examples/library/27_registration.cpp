// SPDX-License-Identifier: Apache-2.0
// Registration marks: the film stretches by 0.7 mm a product and begins 5 mm off; a roll follows.
#include <cstdio>
#include <vector>

#include "jounce/gear/registration.hpp"
#include "jounce/profiles/limits/limits.hpp"

using namespace jounce;

int main() {
  // A sealing roll: in step over 100 of 300 mm, then on to the next jaw.
  const Cam roll({line(100, 0, 100), quintic(200, 100, 1, 0, 360, 1, 0)}, 0,
                 Extrapolation::advance);
  Registration mark{.window_from = 120, .window_length = 150, .most = 50};
  const Limits limits{.velocity = 200, .acceleration = 350};  // mm/s, mm/s^2; line at 100 mm/s
  std::printf("at most %.3f mm a product within the limits\n",
              greatest_correction(roll, mark, limits, 100));

  mark.most = 2;
  RegistrationState state;
  std::vector<double> steps;
  for (int product = 0; product < 6; ++product) {
    const double measured = 5 + 0.7 * product - state.applied;
    const Registered now = corrected(mark, state, measured - state.outstanding);
    std::printf("product %d: off by %.1f, moved by %.1f, %.1f left\n", product + 1, measured,
                now.step, now.state.outstanding);
    steps.push_back(now.step);
    state = now.state;
  }
  const Cam all = registered(roll, mark, steps);
  std::printf("in step in product 6: slope %g, %.1f further\n", all.at(1550).geo_velocity,
              all.at(1550).position - (5 * 360 + 50));
}
// > at most 35.131 mm a product within the limits
// > product 1: off by 5.0, moved by 2.0, 3.0 left
// > product 2: off by 3.7, moved by 2.0, 1.7 left
// > product 3: off by 2.4, moved by 2.0, 0.4 left
// > product 4: off by 1.1, moved by 1.1, 0.0 left
// > product 5: off by 0.7, moved by 0.7, 0.0 left
// > product 6: off by 0.7, moved by 0.7, 0.0 left
// > in step in product 6: slope 1, 7.8 further
