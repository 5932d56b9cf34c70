// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/curve.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "jounce/profiles/curve/over_length.hpp"
#include "jounce/profiles/detail/common_pieces.hpp"
#include "jounce/profiles/detail/compensated_sum.hpp"
#include "jounce/profiles/detail/evaluate.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

/// True if no derivative up to the fourth can exceed a double: it is at most 11 * 10 * 9 * 8 magnitudes, divided by the
/// fourth power of the length. This takes a small share of the time of the derivatives.
bool is_moderate(const Segment& f) {
  constexpr double shortest = 1e-30;
  constexpr double greatest = 1e150;
  return f.sines == 0 && f.length >= shortest && magnitude(f) <= greatest;
}

bool is_finite(const Segment& f) {
  if (is_moderate(f)) return true;
  Segment g = f;
  for (int order = 0; order <= 4; ++order, g = derivative(g))
    if (!std::isfinite(magnitude(g))) return false;
  return true;
}

void require_valid(const Segment& f, std::size_t index) {
  const auto key = [&] { return "segment[" + std::to_string(index + 1) + "]"; };
  if (!std::isfinite(f.length) || !(f.length > 0))
    require_positive((key() + ".length").c_str(), f.length);
  if (f.degree < 0 || f.degree > Segment::max_degree)
    throw InputError(key() + ".degree", f.degree,
                     "must be from 0 to " + std::to_string(Segment::max_degree));
  if (f.sines < 0 || f.sines > Segment::max_sines)
    throw InputError(key() + ".sines", f.sines,
                     "must be from 0 to " + std::to_string(Segment::max_sines));
  if (!is_finite(f))
    throw InputError(
        key(), "",
        "value and derivatives must be finite: too short, too far or too steep for a double");
}

std::vector<double> running_sum(double start, const std::vector<Segment>& segments) {
  std::vector<double> breaks;
  breaks.reserve(segments.size() + 1);
  breaks.push_back(start);
  profiles_detail::CompensatedSum sum(start);
  for (const Segment& f : segments) {
    sum.add(f.length);
    breaks.push_back(sum.value());
  }
  return breaks;
}

/// Values at x of the segment that begins at `start`.
[[gnu::always_inline]] inline Jet inside(const Segment& f, double start, double x) {
  return profiles_detail::evaluate(f, std::clamp((x - start) / f.length, 0.0, 1.0));
}

}  // namespace

template <class Over>
Curve<Over>::Curve(std::vector<Segment> segments, double start, Extrapolation outside)
    : segments_(std::move(segments)), outside_(outside) {
  if (segments_.empty()) throw InputError("segments", "none", "a curve needs at least one segment");
  require_finite("start", start);
  for (std::size_t i = 0; i < segments_.size(); ++i) require_valid(segments_[i], i);
  breaks_ = running_sum(start, segments_);
  require_finite("end", breaks_.back());
  if (!(breaks_.back() > breaks_.front()))
    throw InputError("start", start, "is so large that rounding absorbs the length of the curve");
  index_ = BreakIndex(breaks_);
}

template <class Over>
Jet Curve<Over>::jet(double x, Side side) const {
  if (!(x >= start() && x < end())) [[unlikely]]
    return at_end_or_outside(x, side);
  const std::size_t i = index_.find(breaks_, x, side);
  return inside(segments_[i], breaks_[i], x);
}

template <class Over>
Jet Curve<Over>::at_end_or_outside(double x, Side side) const {
  if (profiles_detail::is_nowhere(x, outside_)) return profiles_detail::not_a_number;
  const auto within = [&](double at) {
    const std::size_t i = index_.find(breaks_, at, side);
    return inside(segments_[i], breaks_[i], at);
  };
  if (x == end() && !(side == Side::right && repeats(outside_))) return within(x);
  assert(outside_ != Extrapolation::refuse &&
         "query outside the range of a curve that rejects this");
  if (!repeats(outside_)) {
    const std::size_t i = x < start() ? 0 : segments_.size() - 1;
    return {inside(segments_[i], breaks_[i], x)[0], 0, 0, 0};
  }
  const auto [at, turns] = in_period(x, side, start(), end());
  Jet f = within(at);
  f[0] += turns * advance();
  return f;
}

template <class Over>
double Curve<Over>::advance() const {
  return outside_ == Extrapolation::advance
             ? value(segments_.back(), 1) - value(segments_.front(), 0)
             : 0;
}

template <class Over>
void Curve<Over>::sample(std::span<const double> x, std::span<Point> out) const {
  require_size("out", out.size(), x.size());
  std::size_t k = 0;  // segment of the previous query
  for (std::size_t i = 0; i < x.size(); ++i) {
    const bool near = x[i] >= breaks_[k] && x[i] < breaks_[k + 1];
    if (!near && !(x[i] >= start() && x[i] < end())) {
      out[i] = at(x[i]);
      continue;
    }
    if (!near)
      k = x[i] >= breaks_[k + 1] && k + 2 < breaks_.size() && x[i] < breaks_[k + 2]
              ? k + 1
              : index_.find(breaks_, x[i], Side::right);
    out[i] = point<Over>(inside(segments_[k], breaks_[k], x[i]));
  }
}

template class Curve<OverTime>;
template class Curve<OverMaster>;
template class Curve<OverLength>;

namespace {

/// The curve of the mapped segments, from `start` on.
template <class Over, class Map>
Curve<Over> mapped(const Curve<Over>& f, double start, Map map) {
  std::vector<Segment> segments;
  segments.reserve(f.segments().size());
  for (const auto& piece : f.segments()) segments.push_back(map(piece));
  return Curve<Over>(std::move(segments), start, f.outside());
}

}  // namespace

template <class Over>
Curve<Over> derivative(const Curve<Over>& f) {
  const auto slope = mapped(f, f.start(), [](const Segment& piece) { return derivative(piece); });
  return f.outside() == Extrapolation::advance ? with(slope, Extrapolation::wrap) : slope;
}

template <class Over>
Curve<Over> integral(const Curve<Over>& f, double start_value) {
  double at_break = start_value;
  return mapped(f, f.start(), [&](const Segment& piece) {
    const auto g = integral(piece, at_break);
    if (!g) throw InputError("degree", piece.degree, "the integral would pass degree 11");
    at_break = value(*g, 1);
    return *g;
  });
}

template <class Over>
Curve<Over> shifted(const Curve<Over>& f, double dx, double dy) {
  return mapped(f, f.start() + dx, [&](const Segment& piece) { return scaled(piece, 1, dy); });
}

template <class Over>
Curve<Over> scaled(const Curve<Over>& f, double factor, double stretch) {
  require_positive("stretch", stretch);
  return mapped(f, f.start() * stretch, [&](const Segment& piece) {
    Segment piece_scaled = scaled(piece, factor);
    piece_scaled.length *= stretch;
    return piece_scaled;
  });
}

template <class Over>
Curve<Over> reversed(const Curve<Over>& f) {
  std::vector<Segment> segments;
  segments.reserve(f.segments().size());
  for (auto it = f.segments().rbegin(); it != f.segments().rend(); ++it)
    segments.push_back(reversed(*it));
  return Curve<Over>(std::move(segments), f.start(), f.outside());
}

template <class Over>
Curve<Over> concatenated(const Curve<Over>& f, const Curve<Over>& g) {
  std::vector<Segment> segments(f.segments().begin(), f.segments().end());
  segments.insert(segments.end(), g.segments().begin(), g.segments().end());
  return Curve<Over>(std::move(segments), f.start(), f.outside());
}

template <class Over>
Curve<Over> repeated(const Curve<Over>& f, int times) {
  if (times < 1) throw InputError("times", times, "must be at least 1");
  std::vector<Segment> segments;
  segments.reserve(f.segments().size() * static_cast<std::size_t>(times));
  for (int i = 0; i < times; ++i)
    segments.insert(segments.end(), f.segments().begin(), f.segments().end());
  return Curve<Over>(std::move(segments), f.start(), f.outside());
}

template <class Over>
Curve<Over> sum(const Curve<Over>& f, const Curve<Over>& g) {
  const double scale = std::max(std::abs(f.start()), std::abs(f.end()));
  if (!profiles_detail::same_place(f.start(), g.start(), scale) ||
      !profiles_detail::same_place(f.end(), g.end(), scale))
    throw InputError("interval", number(g.start()) + " to " + number(g.end()),
                     "a sum needs equal intervals; the other curve has " + number(f.start()) +
                         " to " + number(f.end()));
  std::vector<Segment> segments;
  profiles_detail::for_common_pieces(
      f, g, [&](double x, const Segment& a, std::size_t, const Segment& b, std::size_t) {
        const auto added = sum(a, b);
        if (!added)
          throw InputError("sum", number(x), "needs more than three sines in one segment");
        segments.push_back(*added);
      });
  return Curve<Over>(std::move(segments), f.start(), f.outside());
}

template <class Over>
Curve<Over> with(const Curve<Over>& f, Extrapolation outside) {
  return Curve<Over>({f.segments().begin(), f.segments().end()}, f.start(), outside);
}

#define JOUNCE_INSTANTIATE(Over)                                             \
  template Curve<Over> derivative(const Curve<Over>&);                       \
  template Curve<Over> integral(const Curve<Over>&, double);                 \
  template Curve<Over> shifted(const Curve<Over>&, double, double);          \
  template Curve<Over> scaled(const Curve<Over>&, double, double);           \
  template Curve<Over> reversed(const Curve<Over>&);                         \
  template Curve<Over> concatenated(const Curve<Over>&, const Curve<Over>&); \
  template Curve<Over> repeated(const Curve<Over>&, int);                    \
  template Curve<Over> sum(const Curve<Over>&, const Curve<Over>&);          \
  template Curve<Over> with(const Curve<Over>&, Extrapolation);
JOUNCE_INSTANTIATE(OverTime)
JOUNCE_INSTANTIATE(OverMaster)
JOUNCE_INSTANTIATE(OverLength)
#undef JOUNCE_INSTANTIATE

}  // namespace jounce
