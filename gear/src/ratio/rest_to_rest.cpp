// SPDX-License-Identifier: Apache-2.0
#include "gear/src/ratio/rest_to_rest.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::gear_detail {
namespace {

using profiles_detail::rounded_input;
/// The peak of a derivative; infinite if the next lower derivative steps by more than rounding.
double peak(const Cam& law, const Ranges& ranges, int order) {
  const auto most = [&](int k) {
    return std::abs(ranges[static_cast<std::size_t>(k)].peak().value);
  };
  const double step = std::abs(largest_jump(law, order - 1).step);
  const bool steps = order > 1 && step > rounded_input * most(order - 1);
  return steps ? std::numeric_limits<double>::infinity() : most(order);
}

/// The law between two rests, so a step against them counts. If a derivative steps, all higher ones
/// are infinite.
Peaks peaks_of(Law law, const LawForm& form) {
  const Cam f(normalized(law, form), 0, Extrapolation::hold);
  const Ranges ranges = extrema(f);
  const double acceleration = peak(f, ranges, 2);
  return {peak(f, ranges, 1), acceleration,
          std::isfinite(acceleration) ? peak(f, ranges, 3) : acceleration};
}

}  // namespace

void require_rest_to_rest(const char* key, Law law, const LawForm& form) {
  const Ends ends = info(law).ends;
  if (!has_own_shape(law) || ends == Ends::straight || ends == Ends::standing || reverses(ends))
    throw InputError(key, name(law), "must be a law that goes from rest to rest");
  require_valid(law, form);
}

Peaks peaks(const char* key, Law law, const LawForm& form) {
  require_rest_to_rest(key, law, form);
  return peaks_of(law, form);
}

Peaks peaks_of_ramp(const char* key, Law law) {
  if (law != Law::line) require_rest_to_rest(key, law, {});
  return peaks_of(law, {});
}

double on_grid(double x, double cycle) {
  int exponent = 0;
  std::frexp(cycle, &exponent);
  const double digit = std::ldexp(1.0, exponent - 53);
  return std::round(x / digit) * digit;
}

std::vector<Segment> placed(Law law, const LawForm& form, double from, double length,
                            double cycle) {
  std::vector<Segment> pieces = normalized(law, form);
  double share = 0;
  double last = from;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    share += pieces[i].length;
    const bool end = i + 1 == pieces.size();
    const double next = end ? from + length : on_grid(from + share * length, cycle);
    pieces[i].length = next - std::exchange(last, next);
  }
  return pieces;
}

std::vector<Segment> moved(Law law, const LawForm& form, double from, double length, double cycle,
                           double u0, double u1) {
  std::vector<Segment> pieces = placed(law, form, from, length, cycle);
  for (Segment& piece : pieces) piece = scaled(piece, u1 - u0, u0);
  // Horner's last step adds c[0]; all steps before it do not depend on c[0].
  Segment& last = pieces.back();
  last.c[0] = 0;
  last.c[0] = u1 - value(last, 1);
  return pieces;
}

}  // namespace jounce::gear_detail
