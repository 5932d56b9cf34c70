// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/coupling/followed.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/curve/roots.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_sum;
/// All master positions within [lo, hi] at which the cam, which may repeat, has a break.
std::vector<double> levels(const Cam& cam, double lo, double hi) {
  std::vector<double> found;
  const bool wraps = repeats(cam.outside());
  const double first = wraps ? std::floor((lo - cam.start()) / cam.length()) : 0;
  const double last = wraps ? std::floor((hi - cam.start()) / cam.length()) : 0;
  require_few_periods(first, last, cam.breaks().size());
  for (std::int64_t n = 0; n <= static_cast<std::int64_t>(last - first); ++n)
    for (const double x : cam.breaks()) {
      const double level = x + (first + static_cast<double>(n)) * cam.length();
      if (level >= lo && level <= hi) found.push_back(level);
    }
  return found;
}

}  // namespace

void require_few_periods(double first, double last, std::size_t breaks) {
  constexpr double farthest = 1e15;  // limit up to which neighboring periods are distinct
  constexpr double most = 2e6;
  if (!(std::abs(first) < farthest && std::abs(last) < farthest))
    throw InputError("master", first,
                     "is the number of a period of the cam, which must be below 1e15");
  if ((last - first + 1) * static_cast<double>(breaks) > most)
    throw InputError("master", last - first + 1,
                     "periods of a cam with " + std::to_string(breaks) +
                         " breaks: one motion passes at most 2e6 breaks. Shorten the master, or "
                         "simplify the cam");
}

Followed::Followed(Cam cam, Trajectory master) : cam_(std::move(cam)), master_(std::move(master)) {
  const Range travel = extrema(master_, 0);
  if (cam_.outside() == Extrapolation::refuse &&
      (travel.min.value < cam_.start() || travel.max.value > cam_.end()))
    throw InputError(
        "master", six_digits(travel.min.value) + " to " + six_digits(travel.max.value),
        "must stay within the cam, " + number(cam_.start()) + " to " + number(cam_.end()));
  breaks_.assign(master_.breaks().begin(), master_.breaks().end());
  for (const double level : levels(cam_, travel.min.value, travel.max.value)) {
    const auto times = crossings(master_, 0, level);
    breaks_.insert(breaks_.end(), times.begin(), times.end());
  }
  std::sort(breaks_.begin(), breaks_.end());
  const double apart = rounded_sum * master_.length();
  breaks_.erase(std::unique(breaks_.begin(), breaks_.end(),
                            [&](double a, double b) { return b - a <= apart; }),
                breaks_.end());
  breaks_.back() = master_.end();
}

Jet Followed::jet(double t, Side side) const {
  const Jet x = master_.jet(t, side);
  // Backwards time and a backwards master cancel: the cam's side is right if both agree. A master
  // within rounding of a break is on it, so that the requested side applies.
  const Side cam_side = (side == Side::left) == backwards(x, side) ? Side::right : Side::left;
  const bool periodic = repeats(cam_.outside());
  const double at = periodic ? wrapped(x[0], cam_.start(), cam_.length()) : x[0];
  const auto above = std::lower_bound(cam_.breaks().begin(), cam_.breaks().end(), at);
  double master = at;
  for (const auto near : {above, above == cam_.breaks().begin() ? above : above - 1})
    if (near != cam_.breaks().end() && std::abs(*near - at) <= rounded_sum * cam_.length())
      master = *near;
  if (periodic && cam_side == Side::left && master == cam_.start()) master = cam_.end();
  Jet f = cam_.jet(master, cam_side);
  f[0] += std::round((x[0] - master) / cam_.length()) * cam_.advance();
  // Beyond the ends of a cam that holds, the slave is at rest: on that side of the ends, too.
  const bool leaves = (master <= cam_.start() && cam_side == Side::left) ||
                      (master >= cam_.end() && cam_side == Side::right);
  if (cam_.outside() == Extrapolation::hold && leaves) f = {f[0], 0, 0, 0};
  return chained(f, x);
}

}  // namespace jounce
