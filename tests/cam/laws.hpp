#pragma once

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "jounce/cam/law.hpp"
#include "jounce/profiles/curve.hpp"

/// Laws over z in [0, 1] from 0 to 1, by their names in oracles.json, written down independently of
/// cam/law.cpp where that has them not.
namespace jounce::testing {

inline Segment polynomial(std::vector<double> coefficients) {
  Segment f;
  f.degree = static_cast<int>(coefficients.size()) - 1;
  std::copy(coefficients.begin(), coefficients.end(), f.c.begin());
  return f;
}

/// z - sum of amplitude[i] sin(2 pi k z) / (2 pi), k = 1, 3, 5.
inline Segment harmonics(std::vector<double> amplitudes) {
  Segment f = polynomial({0, 1});
  for (std::size_t i = 0; i < amplitudes.size(); ++i) {
    const double turn = 2 * std::numbers::pi;
    f.sine[i] = {-amplitudes[i] / turn, turn * static_cast<double>(2 * i + 1), 0};
    ++f.sines;
  }
  return f;
}

/// f''' = +-32 with switches at 1/4 and 3/4.
inline Cam perfect_spline() {
  Segment up = polynomial({32});
  up.length = 0.25;
  Segment down = polynomial({-32});
  down.length = 0.5;
  return integral(integral(integral(Cam({up, down, up}))));
}

inline std::map<std::string, Cam> laws() {
  const auto cam = [](std::vector<Segment> f) { return Cam(std::move(f), 0, Outside::hold); };
  return {
      {"quadratic_parabola", cam(scca(0, 1, 0))},
      {"simple_sine", cam(scca(0, 0, 1))},
      {"cubic_23", cam({cubic(1, 0, 0, 1, 0)})},
      {"inclined_sine", cam(normalised(Law::inclined_sine))},
      {"modified_sine", cam(normalised(Law::modified_sine))},
      {"modified_trapezoid", cam(normalised(Law::modified_trapezoid))},
      {"poly_345", cam({quintic(1, 0, 0, 0, 1, 0, 0)})},
      {"poly_4567", cam({polynomial({0, 0, 0, 0, 35, -84, 70, -20})})},
      {"poly_56789", cam({polynomial({0, 0, 0, 0, 0, 126, -420, 540, -315, 70})})},
      {"gutman_13", cam({harmonics({15.0 / 16, 1.0 / 48})})},
      {"freudenstein_13", cam({harmonics({27.0 / 28, 1.0 / 84})})},
      {"freudenstein_135",
       cam({harmonics({1125.0 / 1192, 1125.0 / 1192 / 54, 1125.0 / 1192 / 1250})})},
      {"minimum_peak_jerk", with(perfect_spline(), Outside::hold)},
  };
}

}  // namespace jounce::testing
