// SPDX-License-Identifier: Apache-2.0
// A cam through points: splines, boundaries left free, points with a tolerance, B-splines, Bezier.
#include <cmath>
#include <cstdio>
#include <vector>

#include "jounce/cam/design/boundaries.hpp"
#include "jounce/cam/laws/b_spline.hpp"
#include "jounce/cam/laws/smoothing_spline.hpp"
#include "jounce/profiles/curve/extrema.hpp"

using namespace jounce;

int main() {
  SplineSpec table{.points = {{0, 0}, {60, 12}, {150, 40}, {240, 25}, {360, 0}}};
  table.ends = SplineEnds::periodic;
  for (const auto& [name, segments] :
       {std::pair{"cubic", cubic_spline(table)}, std::pair{"quintic", quintic_spline(table)}}) {
    const Cam cam(segments, 0, Extrapolation::wrap);
    std::printf("%s: peak acceleration %.6f mm/deg^2, jerk jumps by %.6f mm/deg^3\n", name,
                extrema(cam, 2).peak().value, std::abs(largest_jump(cam, 3).step));
  }

  // A pusher: dwell, out over 20 and 55 to 60 mm, back over 25 mm. The velocities at these points are free.
  CamSpec spec{.start = {0, 0, {}, {}},
               .segments = {{Law::dwell, {60, 0, {}, {}}, ""},
                            {Law::quintic, {120, 20, {}, {}}, ""},
                            {Law::quintic, {180, 55, {}, {}}, ""},
                            {Law::quintic, {230, 60, {}, {}}, ""},
                            {Law::quintic, {300, 25, {}, {}}, ""},
                            {Law::quintic, {360, 0, {}, {}}, ""}},
               .periodic = true};
  for (const Fill fill : {Fill::rest, Fill::minimum_jerk})
    std::printf("%s: peak acceleration %.5f mm/deg^2\n", name(fill),
                std::abs(extrema(design(filled(spec, fill)).cam, 2).peak().value));

  // The same rise, measured to 0.2 mm at 37 places.
  SplineSpec measured;
  measured.start = measured.end = {.geo_velocity = 0, .geo_acceleration = 0};
  for (int i = 0; i <= 36; ++i) {
    const double z = i / 36.0;
    const double rise = 40 * z * z * z * (10 - 15 * z + 6 * z * z);
    const bool end = i == 0 || i == 36;
    measured.points.push_back(
        {10.0 * i, end ? rise : rise + (i % 2 ? 0.15 : -0.15), end ? 0 : 0.2});
  }
  const SmoothingSpline smooth = smoothing_spline(measured);
  std::printf("within 0.2 mm: %zu segments, certified to %.0f %%\n", smooth.segments.size(),
              100 * smooth.gap / smooth.square_jerk);

  const std::vector<Segment> seventh = b_spline(interpolating_b_spline(
      {{0, 0}, {40, 1}, {90, 5}, {130, 9}, {200, 12}, {240, 11}, {300, 4}, {360, 0}}, 7));
  std::printf("degree 7 through 8 points: %zu segment\n", seventh.size());
  const Cam rise({bezier(120, std::vector<double>{0, 0, 0, 40, 40, 40})});
  std::printf("Bezier 0 0 0 40 40 40: Cv %.3f\n", extrema(rise, 1).max.value * 120 / 40);
}

// > cubic: peak acceleration -0.008713 mm/deg^2, jerk jumps by 0.000227 mm/deg^3
// > quintic: peak acceleration -0.007427 mm/deg^2, jerk jumps by 0.000000 mm/deg^3
// > rest: peak acceleration 0.05613 mm/deg^2
// > minimum_jerk: peak acceleration 0.02001 mm/deg^2
// > within 0.2 mm: 1 segments, certified to 0 %
// > degree 7 through 8 points: 1 segment
// > Bezier 0 0 0 40 40 40: Cv 1.875
