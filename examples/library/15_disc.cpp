// SPDX-License-Identifier: Apache-2.0
// A mechanical cam: how steep, how sharp, how small can it be, and its contour.
#include <cstdio>

#include "jounce/cam/design/design.hpp"
#include "jounce/cam/disc/disc_contour.hpp"

using namespace jounce;

int main() {
  constexpr double deg = std::numbers::pi / 180;
  CamSpec lift;
  lift.start = {0, 0, {}, {}};
  lift.segments = {{Law::modified_sine, {80, 9, {}, {}}, "open"},
                   {Law::dwell, {100, 9, {}, {}}, "hold"},
                   {Law::modified_sine, {180, 0, {}, {}}, "close"},
                   {Law::dwell, {360, 0, {}, {}}, "shut"}};
  lift.periodic = true;
  const Cam cam = design(lift).cam;

  const DiscSpec geometry{.base_radius = 18, .roller_radius = 8, .offset = 3};  // mm
  const Disc disc(cam, geometry);
  const DiscExtremes e = extremes(disc);
  std::printf("pressure angle %.4f deg at %.4f .. %.4f deg at %.4f\n",
              e.pressure_angle.min.value / deg, e.pressure_angle.min.where,
              e.pressure_angle.max.value / deg, e.pressure_angle.max.where);
  std::printf("profile radius %.4f mm at %.4f deg\n", 1 / e.pitch_curvature.max.value - 8,
              e.pitch_curvature.max.where);

  const auto base = least_base_radius(cam, geometry, {.pressure_angle = 30 * deg});
  std::printf("least base radius for 30 deg: %.6f mm\n", base.value_or(0));

  const Contour profile = contour(disc, -8, 0.001);
  std::printf("%zu arcs within 1 um, %zu lines would do\n", profile.size(),
              contour(disc, -8, 0.001, Pieces::lines).size());
}

// > pressure angle -25.6055 deg at 144.0301 .. 15.4933 deg at 37.6545
// > profile radius 11.8790 mm at 67.1549 deg
// > least base radius for 30 deg: 13.035951 mm
// > 53 arcs within 1 um, 553 lines would do
