// SPDX-License-Identifier: Apache-2.0
#include "gear/src/cut/shear_line.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

#include "gear/src/cut/line_bounds.hpp"

// If the line has the acceleration alpha, the acceleration of the carriage is s'' v^2 + s' alpha. A
// ramp whose length and travel are multiplied by the same factor keeps s', and has a lower s''. A
// longer return has both lower. So each of them has a least length.

namespace jounce::gear_detail {
namespace {

/// The segments of a motion with this name.
std::vector<Segment> named(const Cutter::Parts& parts, std::string_view name) {
  std::vector<Segment> all;
  for (std::size_t i = 0; i < parts.segments.size(); ++i)
    if (parts.names[i] == name) all.push_back(parts.segments[i]);
  return all;
}

constexpr const char* reserve =
    ": a shorter one leaves no reserve for the acceleration of the line in [master]";

/// Throws for a ramp: `key` and `length` if the length is given, otherwise safety.
void require_ramp(const std::vector<Segment>& ramp, const char* key,
                  const std::optional<double>& length, const FlyingShear& shear,
                  const CutLine& line) {
  const double factor =
      least_factor([&](double x) { return permits(stretched(ramp, x, x), line); });
  if (factor == 1) return;
  if (!std::isfinite(factor)) {
    const double slope = shear.ratio / std::cos(shear.angle);
    throw InputError("master.acceleration", line.rates.acceleration,
                     "must be less than " +
                         six_digits_down(line.slave.acceleration.value_or(0) / slope) +
                         ": in step, the slave accelerates with the line, and its limit is "
                         "limits.slave.acceleration");
  }
  if (length)
    throw InputError(key, *length, "must be at least " + six_digits_up(*length * factor) + reserve);
  throw InputError("safety", shear.safety,
                   "must be at least " + six_digits_up(shear.safety * factor) +
                       ": shorter ramps leave no reserve for the acceleration of the line in "
                       "[master]");
}

}  // namespace

void require_reserve(const FlyingShear& shear, const Cutter& cutter, const CutLine& line) {
  if (!(line.rates.acceleration > 0 || line.rates.jerk > 0)) return;
  Cutter::Parts way;
  cutter.add_approach(way, 0);
  cutter.add_retreat(way, 0);
  require_ramp(named(way, "accelerate"), "acceleration_length", shear.acceleration_length, shear,
               line);
  const auto& braking =
      shear.deceleration_length ? shear.deceleration_length : shear.acceleration_length;
  require_ramp(named(way, "decelerate"), "deceleration_length", braking, shear, line);
  if (!shear.return_length) return;
  const std::vector<Segment> back = named(way, "return");
  const double factor =
      least_factor([&](double x) { return permits(stretched(back, x, 1), line); });
  if (factor > 1 && std::isfinite(factor))
    throw InputError("return_length", *shear.return_length,
                     "must be at least " + six_digits_up(*shear.return_length * factor) + reserve);
}

}  // namespace jounce::gear_detail
