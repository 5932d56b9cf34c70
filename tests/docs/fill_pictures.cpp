// SPDX-License-Identifier: Apache-2.0
// fill_pictures FOLDER: draws docs/pictures/pvt_fill.svg, the ways to fill in velocities; the tests compare.
#include <fstream>
#include <string>
#include <utility>

#include "jounce/plot/figure.hpp"
#include "jounce/pvt/fill.hpp"

using namespace jounce;

namespace {

Series series(const std::string& label, const Trajectory& f, std::size_t order) {
  Series line{.label = label};
  for (std::size_t i = 0; i < f.segments().size(); ++i)
    for (int n = 0; n <= 60; ++n) {
      const double s = n / 60.0;
      line.x.push_back(f.breaks()[i] + s * f.segments()[i].length);
      line.y.push_back(evaluate(f.segments()[i], s)[order]);
    }
  return line;
}

/// The HMPL manual's example (5.2.8) without its velocities; at rest at both ends.
FillSpec hmpl(Filling filling) {
  FillSpec spec{.x = {0, 2, 3, 4, 6, 11},
                .p = {0, 153.333, 42.123, 161.21, 177, 83.333},
                .v = {0, {}, {}, {}, {}, 0},
                .filling = filling};
  spec.limits = {.velocity = 160};
  return spec;
}

Figure fillings() {
  Figure figure{.title = "one table, its velocities filled in", .x_label = "time [s]"};
  Panel position{.y_label = "position [mm]"};
  Panel velocity{.y_label = "velocity [mm/s]"};
  for (const Filling filling :
       {Filling::natural, Filling::monotone, Filling::shape_preserving, Filling::minimum_jerk}) {
    FillSpec spec = hmpl(filling);
    if (filling == Filling::minimum_jerk) spec.rule = Interpolation::quintic_hermite;
    const Trajectory f = filled(spec).table.curve<OverTime>();
    position.series.push_back(series(name(filling), f, 0));
    velocity.series.push_back(series(name(filling), f, 1));
  }
  figure.panels = {std::move(position), std::move(velocity)};
  figure.knots = {2, 3, 4, 6};
  return figure;
}

}  // namespace

int main(int, char** arguments) {
  std::ofstream(std::string(arguments[1]) + "/pvt_fill.svg") << svg(fillings());
}
