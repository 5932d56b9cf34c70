// SPDX-License-Identifier: Apache-2.0
// cam_pictures FOLDER: draws the pictures of docs/cam and docs/gear that no verb draws; the tests compare.
#include <cmath>
#include <fstream>
#include <string>
#include <utility>

#include "jounce/cam/algebra/algebra.hpp"
#include "jounce/cam/algebra/inverse.hpp"
#include "jounce/cam/design/design.hpp"
#include "jounce/gear/gear_in_pos.hpp"
#include "jounce/plot/figure.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

using namespace jounce;

namespace {

/// A signal as a line, its value or a derivative, from both sides at every break.
template <class S>
Series series(const std::string& label, const S& f, std::size_t order, double clip) {
  Series line{.label = label};
  const auto add = [&](double x, Side side) {
    line.x.push_back(x);
    const double y = f.jet(x, side)[order];
    line.y.push_back(std::abs(y) <= clip ? y : std::nan(""));  // a gap
  };
  for (std::size_t i = 0; i + 1 < f.breaks().size(); ++i) {
    const double a = f.breaks()[i];
    const double b = f.breaks()[i + 1];
    add(a, Side::right);
    for (int n = 1; n < 400; ++n)
      add(a + (b - a) * (1 - std::cos(n * 3.14159265 / 400)) / 2, Side::right);
    add(b, Side::left);
  }
  return line;
}

Cam pusher() {
  CamSpec spec;
  spec.segments = {{Law::modified_sine, {100, 30, {}, {}}, ""},
                   {Law::dwell, {160, 30, {}, {}}, ""},
                   {Law::modified_sine, {220, 50, {}, {}}, ""},
                   {Law::poly345, {360, 0, {}, {}}, ""}};
  spec.periodic = true;
  return design(spec).cam;
}

Figure inverse() {
  const Cam cam = pusher();
  const Inversion all = inverted(cam);
  Figure figure{.title = "inverse of rise, dwell, rise, return", .x_label = "slave [mm]"};
  Panel master{.y_label = "master [deg]"};
  Panel slope{.y_label = "deg/mm"};
  const char* names[] = {"rise", "return"};
  for (std::size_t i = 0; i < all.branches.size(); ++i) {
    master.series.push_back(series(names[i], all.branches[i], 0, 1e9));
    slope.series.push_back(series(names[i], all.branches[i], 1, 15));
  }
  figure.panels = {std::move(master), std::move(slope)};
  figure.knots = {30};
  return figure;
}

Figure algebra() {
  const Cam cam = pusher();
  const Cam rise({quintic(120, 0, 0, 0, 4, 0, 0)});
  const Cam shake = with(concatenated(rise, reversed(rise)), Extrapolation::wrap);
  const Cam turns = repeated(cam, 2);
  Figure figure{.title = "phased and superposed", .x_label = "master [deg]", .degrees = true};
  figure.panels.push_back(
      {.y_label = "phased [mm]",
       .series = {series("cam", turns, 0, 1e9),
                  series("180 deg later", repeated(phased(cam, 180), 2), 0, 1e9)}});
  Series before = series("cam", turns, 0, 1e9);
  before.style = Style::under;
  figure.panels.push_back(
      {.y_label = "superposed [mm]",
       .series = {before, series("cam + shake", superimposed(cam, shake), 0, 1e9)}});
  return figure;
}

/// PMC600 manual 6.1, example 6.2 in a loop: the slave engages once, and stays in sync.
Figure engagement() {
  const GearInPos gear = gear_in_pos({.numerator = 1,
                                      .denominator = 2,
                                      .master_sync_position = 5000,
                                      .slave_sync_position = 2000,
                                      .master_start_distance = 4000});
  TrapezoidSpec travel{.to = 10000, .velocity = 10000, .acceleration = 40000};
  const Trajectory there = trapezoid(travel).curve();
  const Trajectory master = concatenated(there, reversed(there));
  const GearedInPos slave(gear, master);
  Figure figure{.title = "PMC600 6.2 over time, master there and back", .x_label = "time [s]"};
  figure.panels = {{.y_label = "position [pulse]",
                    .series = {series("master", master, 0, 1e9), series("slave", slave, 0, 1e9)}},
                   {.y_label = "velocity [pulse/s]",
                    .series = {series("master", master, 1, 1e9), series("slave", slave, 1, 1e9)}}};
  figure.knots = {*slave.in_sync()};
  return figure;
}

void write(const std::string& file, const Figure& figure) {
  std::ofstream(file) << svg(figure);
}

}  // namespace

int main(int, char** arguments) {
  const std::string folder = arguments[1];
  write(folder + "/cam_inverse.svg", inverse());
  write(folder + "/cam_algebra.svg", algebra());
  write(folder + "/gear-in-pos-time.svg", engagement());
}
