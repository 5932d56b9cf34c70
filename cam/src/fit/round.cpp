// SPDX-License-Identifier: Apache-2.0
#include "cam/src/fit/round.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "jounce/profiles/detail/tolerances.hpp"

namespace jounce::cam_detail {
namespace {

/// Sets every place of the parameter. A place that differs by a period keeps its difference.
void set(CamSpec& spec, const Parameter& parameter, double to) {
  change(spec, parameter, to - value(spec, parameter));
  const double reached = value(spec, parameter);
  for (const std::size_t at : parameter.at) {
    double& place = *field(spec, parameter.kind, at);
    if (place == reached) place = to;
  }
}

}  // namespace

double with_decimals(double value, int decimals) {
  const double power = std::pow(10, std::abs(decimals));
  const double rounded =
      decimals >= 0 ? std::round(value * power) / power : std::round(value / power) * power;
  return rounded == 0 ? 0 : rounded;  // not -0
}

int first_decimal(double scale) {
  return -static_cast<int>(std::floor(std::log10(scale)));
}

bool is_as_good(const Deviation& after, const Deviation& before) {
  constexpr double greater_rms = 1.02;  // by which the rms distance may increase
  constexpr double more_rms = 0.01;     // and a share of the tolerance, for points without noise
  return after.worst <= std::max(1.0, before.worst) &&
         after.rms <= greater_rms * before.rms + more_rms;
}

void round_values(CamSpec& spec, const std::vector<Parameter>& parameters,
                  const MeasuredCam& measured) {
  std::vector<std::size_t> points(measured.points.size());
  std::iota(points.begin(), points.end(), std::size_t{0});
  const Deviation before = deviation(spec, measured, points);
  for (const Parameter& parameter : parameters) {
    const double exact = value(spec, parameter);
    const int first = first_decimal(parameter.scale);
    for (int d = first; d <= first + most_decimals; ++d) {
      CamSpec trial = spec;
      set(trial, parameter, with_decimals(exact, d));
      if (!is_as_good(deviation(trial, measured, points), before)) continue;
      spec = std::move(trial);
      break;
    }
  }
}

}  // namespace jounce::cam_detail
