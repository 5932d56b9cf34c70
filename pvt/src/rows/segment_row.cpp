// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/segment_row.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "pvt/src/table/piece.hpp"

// A row of degree 2 over the length T with the increment P is (1) of pt.cpp. With s = u / T,
//
//   (1)  f = f0 + c1 s + (P - c1) s^2,   c1 = T times the rate a at its start
//   (2)  a = 2 P / T - b  where the rate b at its end is given:  c1 = 2 P - b T
//   (3)  b = 2 P / T - a
//
// (2), without the quotient, lets a STOP (b = 0) begin with exactly 2 P, as pt() does.

namespace jounce {
namespace {

using profiles_detail::rounded_input;
using profiles_detail::rounded_jerk;

bool given(double rate) {
  return !std::isnan(rate);
}

/// True if the end rate determines a row of degree 2.
bool by_its_end(const SegmentRow& row) {
  return !given(row.v_start) && given(row.v_end);
}

/// (1) and (2)
Segment segment_of(const SegmentRow& row, const RowStart& from, double rate) {
  const double length = row.x_end - from.x;
  const double distance = row.p_end - from.position;
  if (row.degree == 3) return cubic(length, from.position, row.v_start, row.p_end, row.v_end);
  if (row.degree == 5)
    return quintic(length, from.position, row.v_start, row.a_start, row.p_end, row.v_end,
                   row.a_end);
  Segment f;
  f.length = length;
  f.c = {from.position, distance};
  if (row.degree == 2)
    f.c[1] = by_its_end(row) ? 2 * distance - row.v_end * length
                             : (given(row.v_start) ? row.v_start : rate) * length;
  f.c[2] = distance - f.c[1];
  f.degree = f.c[2] != 0 ? 2 : 1;
  return f;
}

template <int degree>
Jet hermite(const SegmentRow& row, const RowStart& from, double x) {
  const std::array<double, 2> at{from.x, row.x_end}, p{from.position, row.p_end},
      v{row.v_start, row.v_end}, a{row.a_start, row.a_end};
  const auto f = pvt_detail::piece<degree>({at.data(), p.data(), v.data(), a.data(), 2}, 0);
  const double s = pvt_detail::place(f, x, row.x_end);
  return {pvt_detail::position(f, s), pvt_detail::velocity(f, s), pvt_detail::acceleration(f, s),
          pvt_detail::jerk(f, s)};
}

int degree_of(Interpolation rule) {
  return pvt_detail::degree_of(rule);
}

}  // namespace

const char* name(RowRule rule) {
  constexpr std::array names{"none",          "full",          "not_finite", "no_degree",
                             "not_ascending", "rates_differ",  "velocity",   "acceleration",
                             "jerk",          "velocity_step", "after_last", "in_use",
                             "position"};
  return names[static_cast<std::size_t>(rule)];
}

const char* explain(RowRule rule) {
  constexpr std::array sentences{
      "The row is accepted.",
      "The FIFO is full: wait until it has space.",
      "A number or a derivative of the row is not finite.",
      "The row's degree is not 1, 2, 3 or 5.",
      "The row does not end after the row before.",
      "The two rates of the row do not lead from its start to its end: leave one of them open.",
      "The row exceeds the velocity limit of the axis.",
      "The row exceeds the acceleration limit of the axis.",
      "The row exceeds the jerk limit of the axis.",
      "The rate steps at the start of the row by more than the axis permits in one tick.",
      "The stream has ended: it accepts no more rows.",
      "The FIFO is played, and emptied at the switch: use the other FIFO.",
      "The row leaves the position range of the axis."};
  return sentences[static_cast<std::size_t>(rule)];
}

PtRate rates(const SegmentRow& row, const RowStart& from, double rate) {
  if (row.degree >= 3) return {row.v_start, row.v_end};
  const double mean = (row.p_end - from.position) / (row.x_end - from.x);
  if (row.degree == 1) return {mean, mean};
  if (by_its_end(row)) return {2 * mean - row.v_end, row.v_end};  // (2)
  const double start = given(row.v_start) ? row.v_start : rate;
  return {start, 2 * mean - start};  // (3)
}

Jet point(const SegmentRow& row, const RowStart& from, double rate, double x) {
  if (row.degree == 3) return hermite<3>(row, from, x);
  if (row.degree == 5) return hermite<5>(row, from, x);
  const Segment f = segment_of(row, from, rate);
  return evaluate(f, std::clamp((x - from.x) / f.length, 0.0, 1.0));
}

RowPeaks peaks(const SegmentRow& row, const RowStart& from, double rate) {
  const Segment f = segment_of(row, from, rate);
  const auto range = [&](int order) { return segment_range(f, 0, f.length, order); };
  const auto most = [&](int order) {
    return order > f.degree ? 0.0 : std::abs(range(order).peak().value);
  };
  const Range p = range(0);
  return {most(1),     most(2),    most(3), std::abs(rates(row, from, rate).start - rate),
          p.min.value, p.max.value};
}

RowRule check(const SegmentRow& row, const RowStart& from) {
  const auto finite = [](double v) { return std::isfinite(v); };
  const auto open_or_finite = [&](double v) { return !given(v) || finite(v); };
  if (row.degree != 1 && row.degree != 2 && row.degree != 3 && row.degree != 5)
    return RowRule::no_degree;
  bool numbers = finite(row.x_end) && finite(row.p_end);
  if (row.degree == 2)
    numbers = numbers && open_or_finite(row.v_start) && open_or_finite(row.v_end);
  if (row.degree >= 3) numbers = numbers && finite(row.v_start) && finite(row.v_end);
  if (row.degree == 5) numbers = numbers && finite(row.a_start) && finite(row.a_end);
  if (!numbers) return RowRule::not_finite;
  if (!(row.x_end > from.x)) return RowRule::not_ascending;
  if (row.degree == 2 && given(row.v_start) && given(row.v_end)) {
    const double end = rates(row, from, 0).end;
    const double scale = std::abs(row.v_start) + std::abs(end);
    if (!(std::abs(end - row.v_end) <= rounded_input * scale)) return RowRule::rates_differ;
  }
  return RowRule::none;
}

RowRule check(const RowPeaks& f, const RowLimits& limits) {
  constexpr double same = 1 + rounded_input;
  // Also without limits: a derivative may exceed the range of a double.
  for (const double peak : {f.velocity, f.acceleration, f.jerk})
    if (!std::isfinite(peak)) return RowRule::not_finite;
  const double stroke = f.position_max - f.position_min;
  const double near = rounded_input * stroke;
  if (!(f.position_min >= limits.position_min - near)) return RowRule::position;
  if (!(f.position_max <= limits.position_max + near)) return RowRule::position;
  if (!(f.velocity <= limits.velocity * same)) return RowRule::velocity;
  if (!(f.acceleration <= limits.acceleration * same)) return RowRule::acceleration;
  if (!(f.jerk <= limits.jerk * (1 + rounded_jerk))) return RowRule::jerk;
  // The rounding error of a chain of quotients is no step of the rate.
  if (!(f.velocity_step <= limits.velocity_step * same + rounded_input * f.velocity))
    return RowRule::velocity_step;
  return RowRule::none;
}

std::array<double, 8> columns_of(const SegmentRow& row) {
  return {row.x_end,
          row.p_end,
          row.v_start,
          row.v_end,
          row.a_start,
          row.a_end,
          static_cast<double>(row.degree),
          row.last ? 1.0 : 0.0};
}

SegmentRow row_of(const std::array<double, 8>& c) {
  const bool whole = c[6] >= 1 && c[6] <= 5 && c[6] == std::floor(c[6]);
  return {c[0], c[1], c[2], c[3], c[4], c[5], whole ? static_cast<int>(c[6]) : 0, c[7] != 0};
}

SegmentRow row_of(const PtPoint& point, bool first) {
  SegmentRow row{.x_end = point.x, .p_end = point.position};
  if (point.type == PtType::even) row.degree = 1;
  if (point.type == PtType::stop) row.v_end = 0;
  if (point.type == PtType::normal && first) row.v_start = 0;
  return row;
}

std::vector<SegmentRow> rows_of(std::span<const PtPoint> points) {
  std::vector<SegmentRow> rows;
  rows.reserve(points.size());
  for (const PtPoint& point : points) rows.push_back(row_of(point, rows.empty()));
  if (!rows.empty()) rows.back().last = true;
  return rows;
}

std::vector<SegmentRow> rows_of(const Table& table) {
  const auto& [x, p, v, a] = table.columns();
  const int degree = degree_of(table.rule());
  std::vector<SegmentRow> rows;
  rows.reserve(table.size() - 1);
  for (std::size_t i = 1; i < table.size(); ++i) {
    SegmentRow row{.x_end = x[i], .p_end = p[i], .degree = degree};
    if (degree >= 3) row.v_start = v[i - 1], row.v_end = v[i];
    if (degree == 5) row.a_start = a[i - 1], row.a_end = a[i];
    row.last = i + 1 == table.size();
    rows.push_back(row);
  }
  return rows;
}

RowStart start_of(const Table& table) {
  return {table.columns().x.front(), table.columns().p.front()};
}

}  // namespace jounce
