// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/algebra/algebra.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_root;
using profiles_detail::rounded_sum;

using Segments = std::vector<Segment>;

constexpr int most_turns = 1000;
constexpr double most_segments = 1e6;

/// Tolerance for equal positions on the axes of these cams.
template <class... Places>
double axis_rounding(Places... x) {
  return rounded_root * std::max({std::abs(x)...});
}

std::string interval(const Cam& f) {
  return number(f.start()) + " to " + number(f.end());
}

/// Divides f at u, 0 < u < length. The sum of both lengths is exactly that of f: the greater length
/// leaves a difference without rounding (Sterbenz).
std::pair<Segment, Segment> split(const Segment& f, double u) {
  const double rest = f.length - u;
  const double first = f.length - rest;
  const double s = first / f.length;
  std::pair halves{part(f, 0, s), part(f, s, 1)};
  halves.first.length = first;
  halves.second.length = rest;
  return halves;
}

/// Appends the part of a segment over [a, b] that is between `from` and `to`.
void append(Segments& out, Segment f, double a, double b, double from, double to, double apart) {
  const bool starts_within = a >= from - apart;
  const bool ends_within = b <= to + apart;
  const bool misses_start = a < from && b <= from + apart;
  const bool misses_end = b > to && a >= to - apart;
  if (misses_start || misses_end) return;
  if (!ends_within) f = split(f, to - a).first;
  if (!starts_within) f = split(f, from - a).second;
  out.push_back(f);
}

Segment lifted(const Segment& f, double by) {
  return by == 0 ? f : scaled(f, 1, by);
}

/// Appends the segments of the n-th turn of f that are between `from` and `to`.
void append_turn(Segments& out, const Cam& f, double from, double to, double n, double apart) {
  const double turn = n * f.length();
  const double gone = n * f.advance();
  for (std::size_t i = 0; i < f.segments().size(); ++i) {
    const double a = f.breaks()[i] + turn;
    const double b = f.breaks()[i + 1] + turn;
    if (b > from && a < to) append(out, lifted(f.segments()[i], gone), a, b, from, to, apart);
  }
}

void append_rest(Segments& out, double from, double to, double apart, double slave) {
  if (to - from > apart) out.push_back(line(to - from, slave, slave));
}

/// The segments of f over [from, to], including its extrapolation; empty if the interval is only
/// rounding.
Segments cut(const Cam& f, double from, double to) {
  const double apart = axis_rounding(f.start(), f.end(), from, to);
  Segments out;
  if (!repeats(f.outside())) {
    append_rest(out, from, std::min(to, f.start()), apart, value(f.segments().front(), 0));
    append_turn(out, f, from, to, 0, apart);
    append_rest(out, std::max(from, f.end()), to, apart, value(f.segments().back(), 1));
    return out;
  }
  if ((to - from) / f.length() * static_cast<double>(f.segments().size()) > most_segments)
    throw InputError("to", to, "is more than 1e6 segments away from " + number(from));
  const double first = std::floor((from - f.start()) / f.length());
  for (double n = first; f.start() + n * f.length() < to - apart; ++n)
    append_turn(out, f, from, to, n, apart);
  return out;
}

void append(Segments& out, const Segments& more) {
  out.insert(out.end(), more.begin(), more.end());
}

Segments all(const Cam& f) {
  return {f.segments().begin(), f.segments().end()};
}

}  // namespace

std::size_t segment_at(const Cam& f, double master) {
  const double at = repeats(f.outside()) ? wrapped(master, f.start(), f.length()) : master;
  const auto breaks = f.breaks();
  const auto after = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, at);
  return static_cast<std::size_t>(after - breaks.begin()) - 1;
}

Cam part(const Cam& f, double from, double to) {
  require_finite("from", from);
  require_finite("to", to);
  if (!(from < to)) throw InputError("to", to, "must be greater than from = " + number(from));
  const double apart = axis_rounding(f.start(), f.end());
  if (f.outside() == Extrapolation::refuse && (from < f.start() - apart || to > f.end() + apart))
    throw InputError(from < f.start() - apart ? "from" : "to", from < f.start() - apart ? from : to,
                     "must lie within the cam, " + interval(f));
  Segments segments = cut(f, from, to);
  if (segments.empty())
    throw InputError("to", to,
                     "is so near to " + number(from) + " that no cam remains between them");
  return Cam(std::move(segments), from);
}

// Let phase = w + k L, 0 <= w < L: up to start + w it is the (k + 1)-th previous turn, then the
// k-th.
Cam phased(const Cam& f, double phase) {
  require_finite("phase", phase);
  if (!repeats(f.outside()))
    throw InputError("phase", phase, "needs a periodic cam: use `shifted` for others");
  const double within = wrapped(phase, 0, f.length());
  const double turns = std::round((phase - within) / f.length());
  const double from = f.end() - within;
  Segments segments;
  for (const Segment& piece : cut(f, from, f.end()))
    segments.push_back(lifted(piece, -(turns + 1) * f.advance()));
  for (const Segment& piece : cut(f, f.start(), from))
    segments.push_back(lifted(piece, -turns * f.advance()));
  return Cam(std::move(segments), f.start(), f.outside());
}

Cam mirrored_about_master(const Cam& f, double master) {
  require_finite("master", master);
  return Cam(all(reversed(f)), 2 * master - f.end(), f.outside());
}

Cam mirrored_about_slave(const Cam& f, double slave) {
  require_finite("slave", slave);
  return shifted(scaled(f, -1), 0, 2 * slave);
}

Cam replaced(const Cam& f, const Cam& g) {
  const double apart = axis_rounding(f.start(), f.end());
  if (g.start() < f.start() - apart || g.end() > f.end() + apart)
    throw InputError("interval", interval(g), "must lie within the cam, " + interval(f));
  Segments segments = cut(f, f.start(), std::max(f.start(), g.start()));
  append(segments, all(g));
  append(segments, cut(f, std::min(g.end(), f.end()), f.end()));
  return Cam(std::move(segments), f.start(), f.outside());
}

Cam inserted(const Cam& f, double at, const Cam& g) {
  require_finite("at", at);
  if (at < f.start() || at > f.end())
    throw InputError("at", at, "must lie within the cam, " + interval(f));
  Segments segments = cut(f, f.start(), at);
  append(segments, all(g));
  append(segments, cut(f, at, f.end()));
  return Cam(std::move(segments), f.start(), f.outside());
}

// ---- superposition ----------------------------------------------------------------------------

namespace {

/// Number of turns of each cam in the common period.
struct Turns {
  int f = 1;
  int g = 1;
};

Turns common_turns(const Cam& f, const Cam& g) {
  for (int n = 1; n <= most_turns; ++n) {
    const double whole = n * f.length();
    const double m = std::round(whole / g.length());
    if (m >= 1 && m <= most_turns && std::abs(whole - m * g.length()) <= rounded_sum * whole)
      return {n, static_cast<int>(m)};
  }
  throw InputError("period", number(f.length()) + " and " + number(g.length()),
                   "have no common period within 1000 turns: choose a ratio of whole numbers, or "
                   "cut out a part with `part`");
}

/// Two cams over one interval.
struct Pair {
  Cam f, g;
};

Cam over(const Cam& f, double from, double to, Extrapolation outside) {
  return with(part(f, from, to), outside);
}

Pair over_common_period(const Cam& f, const Cam& g) {
  const Turns turns = common_turns(f, g);
  const double from = f.start();
  const Cam beside = shifted(phased(g, g.start() - from), from - g.start());
  const Extrapolation outside = f.outside() == g.outside() ? f.outside() : Extrapolation::advance;
  return {over(f, from, from + turns.f * f.length(), outside),
          over(beside, from, from + turns.g * g.length(), outside)};
}

Pair over_one_interval(const Cam& f, const Cam& g) {
  const Extrapolation a = f.outside();
  const Extrapolation b = g.outside();
  if (a == Extrapolation::refuse && b == Extrapolation::refuse) return {f, g};
  if (a == Extrapolation::refuse) return {f, over(g, f.start(), f.end(), a)};
  if (b == Extrapolation::refuse) return {over(f, g.start(), g.end(), b), g};
  if (repeats(a) && repeats(b)) return over_common_period(f, g);
  if (a != b)
    throw InputError("period", number(repeats(a) ? f.length() : g.length()),
                     "belongs to one of the two cams only; the other holds, so the sum does not "
                     "repeat: cut one period out of the repeating cam with operator = \"part\"");
  const double from = std::min(f.start(), g.start());
  const double to = std::max(f.end(), g.end());
  return {over(f, from, to, a), over(g, from, to, a)};
}

}  // namespace

Cam superimposed(const Cam& f, const Cam& g) {
  const auto [a, b] = over_one_interval(f, g);
  return sum(a, b);
}

Fitted<OverMaster> superimposed(const Cam& f, const Cam& g, double tolerance) {
  require_positive("tolerance", tolerance);
  const auto [a, b] = over_one_interval(f, g);
  try {
    return {sum(a, b), {}};
  } catch (const InputError& error) {
    if (error.key() != "sum") throw;
  }
  const auto polynomial = polynomial_within(b, tolerance);
  return {sum(a, polynomial.curve), polynomial.error};
}

}  // namespace jounce
