// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <sstream>
#include <string>

#include "jounce/cam/design/design.hpp"
#include "jounce/cam/disc/disc.hpp"
#include "jounce/profiles/error.hpp"

#include "support/draw_until.hpp"
#include "support/random.hpp"

namespace jounce::test {

/// Rise to 120, dwell to 180, return to 300, dwell to 360 deg.
inline Cam rise_dwell_return(Law law, double stroke) {
  CamSpec spec;
  spec.start = {0, 0, {}, {}};
  spec.periodic = true;
  spec.segments = {{law, {120, stroke, {}, {}}, ""},
                   {Law::dwell, {180, stroke, {}, {}}, ""},
                   {law, {300, 0, {}, {}}, ""},
                   {Law::dwell, {360, 0, {}, {}}, ""}};
  return design(spec).cam;
}

/// a (1 - cos t): one lobe, stroke 2a.
inline Cam harmonic(double a) {
  Segment f;
  f.length = 360;
  f.c[0] = a;
  f.sines = 1;
  f.sine[0] = {-a, 2 * std::numbers::pi, std::numbers::pi / 2};
  return Cam({f}, 0, Extrapolation::wrap);
}

struct RandomDisc {
  Disc disc;
  std::string text;
};

inline Cam random_cam(Random& random) {
  const int knots = 2 + random.below(5);
  CamSpec spec;
  spec.start = {0, 0, 0, random.uniform(-2e-3, 2e-3)};
  spec.periodic = true;
  double before = 0;
  for (int i = 1; i <= knots; ++i) {
    const double at = i == knots ? 360 : before + (360 - before) * random.uniform(0.2, 0.6);
    CamKnot knot{at, random.uniform(0, 12), random.uniform(-0.1, 0.1), random.uniform(-4e-3, 4e-3)};
    if (i == knots) knot = {360, 0, 0, spec.start.geo_acceleration};
    spec.segments.push_back({Law::quintic, knot, ""});
    before = at;
  }
  return design(spec).cam;
}

/// A random cam on random geometry of either kind; nullopt if such an arm does not reach.
inline std::optional<RandomDisc> random_disc_or_none(Random& random) {
  DiscSpec spec{.base_radius = random.log_uniform(3, 100),
                .roller_radius = random.log_uniform(1, 20)};
  if (random.below(2) == 0) {
    spec.offset = random.uniform(-1, 1) * spec.base_radius;
  } else {
    spec.follower = Follower::oscillating;
    spec.arm_length = random.log_uniform(20, 200);
    spec.center_distance = random.log_uniform(20, 200);
  }
  if (random.below(2) == 0) spec.rotation = Rotation::clockwise;
  const Cam cam = random_cam(random);
  std::ostringstream text;
  text.precision(17);
  text << "base " << spec.base_radius << " roller " << spec.roller_radius << " offset "
       << spec.offset << " arm " << spec.arm_length << " distance " << spec.center_distance
       << (spec.rotation == Rotation::clockwise ? " clockwise" : "") << " knots";
  for (std::size_t i = 0; i < cam.breaks().size(); ++i) {
    const Transfer p = cam.at(cam.breaks()[i]);
    text << " (" << cam.breaks()[i] << ", " << p.position << ", " << p.geo_velocity << ", "
         << p.geo_acceleration << ")";
  }
  try {
    return RandomDisc{Disc(cam, spec), text.str()};
  } catch (const InputError&) {
    return std::nullopt;
  }
}

inline RandomDisc random_disc(Random& random) {
  return *draw_until([&random] { return random_disc_or_none(random); },
                     [](const std::optional<RandomDisc>& drawn) { return drawn.has_value(); });
}

}  // namespace jounce::test
