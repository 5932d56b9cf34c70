// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/disc/disc_contour.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "cam/disc/disc_cams.hpp"

namespace jounce::disc_contour_test {
namespace {

using test::harmonic;
using test::random_disc;
using test::rise_dwell_return;

Place parallel(const Disc& disc, double master, double distance) {
  const DiscPoint p = disc.at(master);
  return {p.center.x + distance * p.normal.x, p.center.y + distance * p.normal.y};
}

/// Distance of a place from the path a -> b, which is a line or an arc: to the line, or to the
/// circle, from the bulge alone (sagitta = bulge * chord / 2).
double distance_to(const Vertex& a, const Vertex& b, Place p) {
  const double chord = std::hypot(b.x - a.x, b.y - a.y);
  const Place along{(b.x - a.x) / chord, (b.y - a.y) / chord};
  const Place from{p.x - a.x, p.y - a.y};
  const double side = along.x * from.y - along.y * from.x;  // > 0: on the left of the way
  if (a.bulge == 0) return std::abs(side);
  const double radius = chord * (1 + a.bulge * a.bulge) / (4 * std::abs(a.bulge));
  const double sagitta = std::abs(a.bulge) * chord / 2;
  const double left = std::copysign(radius - sagitta, a.bulge);  // ccw: the center is on the left
  const double x = along.x * from.x + along.y * from.y - chord / 2;
  return std::abs(std::hypot(x, side - left) - radius);
}

/// The worst distance of a fine sample, as a share of the tolerance; checks vertices and order.
double worst_share(const Disc& disc, double distance, double tolerance, Pieces pieces) {
  const Contour c = contour(disc, distance, tolerance, pieces);
  double worst = 0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Vertex& a = c[i];
    const Vertex& b = c[(i + 1) % c.size()];
    const double end = i + 1 < c.size() ? b.master : disc.lift().end();
    EXPECT_LT(a.master, end);
    const Place on = parallel(disc, a.master, distance);
    EXPECT_NEAR(std::hypot(on.x - a.x, on.y - a.y), 0, 1e-12 * (1 + std::abs(distance)) * 200);
    for (int k = 0; k <= 20; ++k) {
      const double x = a.master + (end - a.master) * k / 20;
      worst = std::max(worst, distance_to(a, b, parallel(disc, x, distance)) / tolerance);
    }
  }
  return worst;
}

TEST(Contour, StaysWithinTheToleranceAndUsesIt) {
  const Disc disc(rise_dwell_return(Law::modified_sine, 10),
                  {.base_radius = 20, .roller_radius = 8, .offset = 5});
  for (const double distance : {0.0, -8.0, 12.0})
    for (const double tolerance : {0.1, 1e-3, 1e-5}) {
      for (const auto pieces : {Pieces::lines, Pieces::arcs}) {
        SCOPED_TRACE(tolerance);
        const double share = worst_share(disc, distance, tolerance, pieces);
        EXPECT_LE(share, 1 + 1e-6);
        EXPECT_GT(share, 0.05) << "far more pieces than needed";
      }
    }
}

TEST(Contour, ArcsAreFewerThanLines) {
  const Disc disc(rise_dwell_return(Law::modified_sine, 10),
                  {.base_radius = 20, .roller_radius = 8});
  EXPECT_LT(5 * contour(disc, -8, 1e-3).size(), contour(disc, -8, 1e-3, Pieces::lines).size());
}

TEST(Contour, OfRandomCamsStaysWithinTheTolerance) {
  test::Random random(4711);
  for (int n = 0; n < 40; ++n) {
    const auto made = random_disc(random);
    SCOPED_TRACE(made.text);
    const double roller = made.disc.spec().roller_radius;
    for (const double distance : {-roller, 0.0, 2 * roller})
      EXPECT_LE(worst_share(made.disc, distance, 1e-3, n % 2 == 0 ? Pieces::arcs : Pieces::lines),
                1 + 1e-6);
  }
}

TEST(Contour, OfADwellIsItsCircle) {
  const Disc disc(Cam({line(360, 0, 0)}, 0, Extrapolation::wrap),
                  {.base_radius = 20, .roller_radius = 5});
  const Contour c = contour(disc, -5, 1e-6);
  EXPECT_LE(c.size(), 8U);
  double turned = 0;
  for (const Vertex& v : c) {
    EXPECT_NEAR(std::hypot(v.x, v.y), 20, 1e-13);
    turned += 4 * std::atan(v.bulge);
  }
  EXPECT_NEAR(turned, -2 * std::numbers::pi, 1e-9) << "the cam turns counterclockwise under it";
}

TEST(Contour, HasAVertexAtEveryBreak) {
  const Disc disc(rise_dwell_return(Law::modified_trapezoid, 10),
                  {.base_radius = 20, .roller_radius = 8});
  const Contour c = contour(disc, 0, 0.01);
  for (const double x : disc.lift().breaks().first(disc.lift().breaks().size() - 1))
    EXPECT_TRUE(std::any_of(c.begin(), c.end(), [&](const Vertex& v) { return v.master == x; }));
}

TEST(Contour, RejectsCornersAndTolerances) {
  const Disc disc(harmonic(5), {.base_radius = 20, .roller_radius = 8});
  EXPECT_THROW(contour(disc, 0, 0), InputError);
  EXPECT_THROW(contour(disc, 0, 1e-12), InputError);
  EXPECT_THROW(contour(disc, NAN, 1), InputError);
  const Cam heart({line(180, 0, 18), line(180, 18, 0)}, 0, Extrapolation::wrap);
  EXPECT_THROW(contour(Disc(heart, {.base_radius = 20}), 0, 0.1), InputError);
}

}  // namespace
}  // namespace jounce::disc_contour_test
