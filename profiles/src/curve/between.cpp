// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/between.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using Segments = std::vector<Segment>;
constexpr double most_segments = 1e6;

void append_rest(double value, double length, Segments& out) {
  if (length > 0) out.push_back(line(length, value, value));
}

/// Appends the pieces of f over [from, to], which is within the interval of f. Parts shorter than
/// the rounding of the axis are omitted.
template <class Over>
void append_inside(const Curve<Over>& f, double from, double to, Segments& out) {
  const auto breaks = f.breaks();
  const double rounding = 4e-16 * std::max(std::abs(from), std::abs(to));
  const auto first = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, from) - breaks.begin();
  for (auto i = static_cast<std::size_t>(first) - 1; i < f.segments().size() && breaks[i] < to;
       ++i) {
    const Segment& whole = f.segments()[i];
    const double dust = 1e-14 + rounding / whole.length;
    double s0 = std::clamp((from - breaks[i]) / whole.length, 0.0, 1.0);
    double s1 = std::clamp((to - breaks[i]) / whole.length, 0.0, 1.0);
    if (s0 <= dust) s0 = 0;
    if (s1 >= 1 - dust) s1 = 1;
    if (s1 - s0 > dust) out.push_back(s0 == 0 && s1 == 1 ? whole : part(whole, s0, s1));
  }
}

template <class Over>
void append_turns(const Curve<Over>& f, double from, double to, Segments& out) {
  const double turn = f.length();
  const double turns = (to - from) / turn;
  if (turns * static_cast<double>(f.segments().size()) > most_segments)
    throw InputError("interval", number(from) + " to " + number(to),
                     "is " + number(turns) + " turns, more than 1e6 segments");
  const double rounding = 4e-16 * std::max(std::abs(from), std::abs(to));
  for (double k = std::floor((from - f.start()) / turn); f.start() + k * turn < to; ++k) {
    const double offset = k * turn;
    const double a = std::max(f.start(), from - offset);
    const double b = std::min(f.end(), to - offset);
    const std::size_t before = out.size();
    if (b - a > rounding) append_inside(f, a, b, out);
    if (k * f.advance() == 0) continue;
    for (std::size_t i = before; i < out.size(); ++i) out[i] = scaled(out[i], 1, k * f.advance());
  }
}

}  // namespace

template <class Over>
Curve<Over> between(const Curve<Over>& f, double from, double to) {
  require_finite("from", from);
  require_finite("to", to);
  if (!(from < to)) throw InputError("to", to, "must be greater than from = " + number(from));
  const bool leaves = from < f.start() || to > f.end();
  if (leaves && f.outside() == Extrapolation::refuse)
    throw InputError("interval", number(from) + " to " + number(to),
                     "leaves the curve, which runs from " + number(f.start()) + " to " +
                         number(f.end()) + " and rejects queries outside");
  Segments pieces;
  if (repeats(f.outside())) {
    append_turns(f, from, to, pieces);
  } else {
    append_rest(value(f.segments().front(), 0), std::min(to, f.start()) - from, pieces);
    append_inside(f, std::max(from, f.start()), std::min(to, f.end()), pieces);
    append_rest(value(f.segments().back(), 1), to - std::max(from, f.end()), pieces);
  }
  if (pieces.empty()) append_rest(f.jet(from)[0], to - from, pieces);  // shorter than rounding
  const Extrapolation outside = repeats(f.outside()) ? Extrapolation::hold : f.outside();
  return Curve<Over>(std::move(pieces), from, outside);
}

template <class Over>
Curve<Over> delayed(const Curve<Over>& f, double delay, double late) {
  if (repeats(f.outside()))
    return with(shifted(between(f, f.start() - delay, f.end() - delay), delay), f.outside());
  const auto held = with(f, Extrapolation::hold);
  return shifted(between(held, f.start() - delay, f.end() + (late - delay)), delay);
}

template <class Over>
void require_resting_ends(const Curve<Over>& f) {
  if (repeats(f.outside())) return;
  const double rounding = 1e-9 * std::abs(extrema(f, 1).peak().value);
  const double begins = evaluate(f.segments().front(), 0)[1];
  const double ends = evaluate(f.segments().back(), 1)[1];
  if (std::abs(begins) > rounding)
    throw InputError("start.velocity", begins, "must be 0: the filter needs a curve from rest");
  if (std::abs(ends) > rounding)
    throw InputError("end.velocity", ends, "must be 0: the filter needs a curve to rest");
}

#define JOUNCE_INSTANTIATE(Over)                                    \
  template Curve<Over> between(const Curve<Over>&, double, double); \
  template Curve<Over> delayed(const Curve<Over>&, double, double); \
  template void require_resting_ends(const Curve<Over>&);
JOUNCE_INSTANTIATE(OverTime)
JOUNCE_INSTANTIATE(OverMaster)
#undef JOUNCE_INSTANTIATE

}  // namespace jounce
