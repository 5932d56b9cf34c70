// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/design/rise.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;
using profiles_detail::rounded_value;

constexpr double most_beyond = 0.1;  ///< share of the stroke by which a rise may pass its ends

using Jet5 = std::array<double, 5>;  // value and four derivatives

Jet5 jet5(const Segment& f, double s) {
  const Jet low = evaluate(f, s);
  return {low[0], low[1], low[2], low[3], evaluate(derivative(f), s)[3]};
}

/// The segments of a cam as a sequence that may continue beyond the cam's end.
class Row {
 public:
  explicit Row(const Cam& cam)
      : cam_(cam),
        cyclic_(repeats(cam.outside())),
        advance_(cam.segments().empty() ? 0 : end_value(cam) - value(cam.segments()[0], 0)) {}

  [[nodiscard]] bool cyclic() const { return cyclic_; }
  [[nodiscard]] std::size_t size() const { return cam_.segments().size(); }
  [[nodiscard]] const Segment& operator[](std::size_t i) const {
    return cam_.segments()[i % size()];
  }

  /// Segments first to last - 1, which may be beyond the end, as a cam. At the end of a period the
  /// slave's position continues, because a step there does not belong to the rise.
  [[nodiscard]] Cam part(std::size_t first, std::size_t last) const {
    std::vector<Segment> segments;
    segments.reserve(last - first);
    for (std::size_t i = first; i < last; ++i)
      segments.push_back(i < size() ? (*this)[i] : scaled((*this)[i], 1, advance_));
    return Cam(std::move(segments), cam_.breaks()[first]);
  }

  /// The derivatives just before the first segment and just after the one before `last`, if there
  /// is a neighbor.
  [[nodiscard]] const Segment* before(std::size_t first) const {
    if (first > 0) return &(*this)[first - 1];
    return cyclic_ ? &(*this)[size() - 1] : nullptr;
  }
  [[nodiscard]] const Segment* after(std::size_t last) const {
    return last < size() || cyclic_ ? &(*this)[last] : nullptr;
  }
  [[nodiscard]] bool rests_outside() const { return cam_.outside() == Extrapolation::hold; }

 private:
  static double end_value(const Cam& cam) { return value(cam.segments().back(), 1); }
  const Cam& cam_;
  bool cyclic_;
  double advance_;
};

/// The range of orders 0 to 4 over all segments.
std::array<Range, 5> ranges_of(const Cam& cam) {
  const Ranges low = extrema(cam);
  return {low[0], low[1], low[2], low[3], extrema(derivative(cam), 3)};
}

/// The greatest order k such that `zero` holds for 1 to k.
template <class Zero>
int highest(const Zero& zero) {
  int k = 0;
  while (k < 4 && zero(static_cast<std::size_t>(k) + 1)) ++k;
  return k;
}

/// Fills in smooth and continuous: compares the derivatives on both sides of every joint.
void classify(Rise& rise, const Row& row, std::size_t last) {
  Jet5 inside{};  // the greatest step by order
  Jet5 ends{};    // the greatest value at an end
  Jet5 edge{};    // the greatest step against a neighbor
  const auto widen = [](Jet5& most, const Jet5& a, const Jet5& b) {
    for (std::size_t k = 1; k < most.size(); ++k)
      most[k] = std::max(most[k], std::abs(a[k] - b[k]));
  };
  const auto pieces = rise.cam.segments();
  for (std::size_t i = 1; i < pieces.size(); ++i)
    widen(inside, jet5(pieces[i - 1], 1), jet5(pieces[i], 0));
  const Jet5 first = jet5(pieces.front(), 0);
  const Jet5 final = jet5(pieces.back(), 1);
  widen(ends, first, {});
  widen(ends, final, {});
  if (const Segment* f = row.before(rise.first))
    widen(edge, jet5(*f, 1), first);
  else if (row.rests_outside())
    widen(edge, {}, first);
  if (const Segment* f = row.after(last))
    widen(edge, final, jet5(*f, 0));
  else if (row.rests_outside())
    widen(edge, final, {});
  const auto scale = [&](std::size_t k) {
    return rounded_input * std::abs(rise.ranges[k].peak().value);
  };
  rise.smooth = highest([&](std::size_t k) { return std::max(inside[k], ends[k]) <= scale(k); });
  rise.continuous =
      highest([&](std::size_t k) { return std::max(inside[k], edge[k]) <= scale(k); });
}

Rise made(const Row& row, std::size_t first, std::size_t last) {
  Rise rise{row.part(first, last), first};
  rise.stroke = value(rise.cam.segments().back(), 1) - value(rise.cam.segments().front(), 0);
  rise.ranges = ranges_of(rise.cam);
  classify(rise, row, last);
  return rise;
}

/// True if the slave rests at the break before segment i: its velocity is zero on both sides.
bool rests(const Row& row, std::size_t i, double zero) {
  const Segment* before = row.before(i);
  const Segment* after = row.after(i);
  return (before == nullptr || std::abs(evaluate(*before, 1)[1]) <= zero) &&
         (after == nullptr || std::abs(evaluate(*after, 0)[1]) <= zero);
}

/// The breaks at which the slave rests, as indices of the segments that begin there, ascending. If
/// the sequence wraps, the first one is repeated at the end.
std::vector<std::size_t> resting(const Cam& cam, const Row& row) {
  const double zero = rounded_input * std::abs(extrema(cam, 1).peak().value);
  std::vector<std::size_t> breaks;
  for (std::size_t i = 0; i < row.size() + (row.cyclic() ? 0 : 1); ++i)
    if (rests(row, i, zero)) breaks.push_back(i);
  if (row.cyclic() && !breaks.empty()) breaks.push_back(breaks.front() + row.size());
  return breaks;
}

/// False for a part that leads away and back, such as a rise, a slow drift and half of a fall.
bool leads_to_its_end(const Rise& rise) {
  const Range& travel = rise.ranges[0];
  return travel.max.value - travel.min.value <= (1 + most_beyond) * std::abs(rise.stroke);
}

}  // namespace

std::vector<Rise> rises(const Cam& cam) {
  const Row row(cam);
  const Range travel = extrema(cam, 0);
  // A stroke within rounding does not count.
  const double still =
      std::max(rounded_input * (travel.max.value - travel.min.value),
               rounded_value * std::max(std::abs(travel.max.value), std::abs(travel.min.value)));
  const auto breaks = resting(cam, row);
  std::vector<Rise> all;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const Segment& begin = row[breaks[k]];
    const Segment& end = row[breaks[k + 1] - 1];
    const bool wraps = breaks[k + 1] > row.size();
    const double gained = wraps ? value(row[row.size() - 1], 1) - value(row[0], 0) : 0;
    if (std::abs(value(end, 1) + gained - value(begin, 0)) <= still) continue;
    Rise rise = made(row, breaks[k], breaks[k + 1]);
    if (leads_to_its_end(rise)) all.push_back(std::move(rise));
  }
  return all;
}

Rise as_rise(const Cam& law) {
  const Row row(law);
  const double stroke = value(row[row.size() - 1], 1) - value(row[0], 0);
  if (stroke == 0)
    throw InputError("stroke", stroke, "must not be 0: characteristic values are relative to it");
  return made(row, 0, row.size());
}

}  // namespace jounce
