// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "jounce/cam/laws/law.hpp"
#include "jounce/profiles/curve/curve.hpp"

namespace jounce::test {

inline Segment polynomial(std::vector<double> coefficients) {
  Segment f;
  f.degree = static_cast<int>(coefficients.size()) - 1;
  std::copy(coefficients.begin(), coefficients.end(), f.c.begin());
  return f;
}

/// The laws over z in [0, 1] from rest to rest, by their names in oracles.json.
inline std::map<std::string, Cam> laws() {
  std::map<std::string, Cam> all;
  const auto add = [&](const char* name, Law law) {
    all.emplace(name, Cam(normalized(law), 0, Extrapolation::hold));
  };
  add("quadratic_parabola", Law::parabola);
  add("simple_sine", Law::simple_sine);
  add("cubic_23", Law::cubic);
  add("inclined_sine", Law::inclined_sine);
  add("modified_sine", Law::modified_sine);
  add("modified_trapezoid", Law::modified_trapezoid);
  add("modified_constant_velocity_50", Law::modified_constant_velocity);
  add("poly_345", Law::poly345);
  add("poly_4567", Law::poly4567);
  add("poly_56789", Law::poly56789);
  add("gutman_13", Law::gutman13);
  add("freudenstein_13", Law::freudenstein13);
  add("freudenstein_135", Law::freudenstein135);
  add("minimum_peak_jerk", Law::minimum_peak_jerk);
  return all;
}

}  // namespace jounce::test
