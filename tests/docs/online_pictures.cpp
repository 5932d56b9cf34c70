// SPDX-License-Identifier: Apache-2.0
// online_pictures FOLDER: draws docs/pictures/online.svg, a limit lowered while an axis brakes; the tests
// compare.
#include <fstream>
#include <string>
#include <utility>

#include "jounce/plot/figure.hpp"
#include "jounce/profiles/online/online.hpp"

using namespace jounce;

namespace {

constexpr double cycle = 0.005;
constexpr int lowered = 215;
constexpr int shown = 420;
const Bounds before = within(2, 10, 100);
const Bounds after = within(2, 3, 100);

void add(Series& line, int k, double y) {
  line.x.push_back(k * cycle);
  line.y.push_back(y);
}

Figure lowered_while_braking() {
  Series target{.label = "target"};
  Series kept{.label = "OnlineGenerator"};
  Series bare{.label = "the lowered limit alone"};
  Series kept_velocity = kept, bare_velocity = bare, kept_rate = kept, bare_rate = bare;
  OnlineGenerator<1> axis;
  axis.set_bounds(0, before);
  axis.set_target(0, {.position = 2});
  Profile alone;
  for (int k = 0; k <= shown; ++k) {
    const Motion m = axis[0];
    if (k == lowered) {
      axis.set_bounds(0, after);
      alone = move_to({m.position, m.velocity, m.acceleration}, {2, 0, 0}, after).profile;
    }
    add(target, k, 2);
    add(kept, k, m.position);
    add(kept_velocity, k, m.velocity);
    add(kept_rate, k, m.acceleration);
    if (k >= lowered) {
      const Motion passed = alone.at((k - lowered) * cycle);
      add(bare, k, passed.position);
      add(bare_velocity, k, passed.velocity);
      add(bare_rate, k, passed.acceleration);
    }
    (void)axis.step(cycle);
  }
  Figure figure{.title = "the acceleration limit is lowered from 10 to 3 while the axis brakes",
                .x_label = "time [s]"};
  figure.panels = {{.y_label = "position [u]", .series = {kept, bare, target}},
                   {.y_label = "velocity [u/s]", .series = {kept_velocity, bare_velocity}},
                   {.y_label = "acceleration [u/s²]", .series = {kept_rate, bare_rate}}};
  figure.knots = {lowered * cycle};
  return figure;
}

}  // namespace

int main(int, char** arguments) {
  std::ofstream(std::string(arguments[1]) + "/online.svg") << svg(lowered_while_braking());
}
