// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/live_compensation.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

/// Bound of the slope in one cell along one reference: the sum of the magnitudes of all terms that
/// depend on it. For a linear table of one reference, it is the slope itself.
double slope_in(const Compensation::Cell& cell, std::size_t own, std::size_t references) {
  std::size_t terms = 1;
  std::size_t stride = 1;
  for (std::size_t j = 0; j < references; ++j) terms *= cell.order;
  for (std::size_t j = 0; j < own; ++j) stride *= cell.order;
  double slope = 0;
  for (std::size_t i = 0; i < terms; ++i)
    slope += static_cast<double>(i / stride % cell.order) * std::abs(cell.k[i]);
  return slope * cell.per_interval[own];
}

/// Bound of the slope of the table along one reference.
double slope_along(const Compensation& table, std::size_t own) {
  const std::span<const GridAxis> axes = table.axes();
  std::size_t cells = 1;
  for (const GridAxis& axis : axes) cells *= axis.count - 1;
  double most = 0;
  for (std::size_t i = 0; i < cells; ++i) {
    std::array<double, Compensation::most_references> middle{};
    std::size_t rest = i;
    for (std::size_t j = 0; j < axes.size(); ++j) {
      const std::size_t n = axes[j].count - 1;
      middle[j] = axes[j].base + axes[j].interval * (static_cast<double>(rest % n) + 0.5);
      rest /= n;
    }
    most = std::max(most,
                    slope_in(table.cell(std::span(middle).first(axes.size())), own, axes.size()));
  }
  return most;
}

/// Throws InputError for a table that steps at the end of a turn.
void require_closed(const CompensationSpec& table, std::size_t own, double modulo) {
  const GridAxis& axis = table.axes[own];
  const std::string key = "reference[" + std::to_string(own + 1) + "]";
  if (axis.base < 0 || axis.end() > modulo)
    throw InputError(key, number(axis.base) + " to " + number(axis.end()),
                     "must be within one turn of the axis, 0 to " + number(modulo));
  std::size_t stride = 1;
  for (std::size_t j = 0; j < own; ++j) stride *= table.axes[j].count;
  for (std::size_t i = 0; i < table.values.size(); ++i) {
    if (i / stride % axis.count != 0) continue;
    const std::size_t last = i + stride * (axis.count - 1);
    if (table.values[i] != table.values[last])
      throw InputError("values[" + std::to_string(last + 1) + "]", table.values[last],
                       "must be " + number(table.values[i]) +
                           ", the value at the other end of the turn: otherwise the axis would "
                           "step there");
  }
}

}  // namespace

LiveCompensation::LiveCompensation(const AxisCompensation& spec, double modulo)
    : table_(spec.table), own_(spec.own), modulo_(modulo) {
  if (!own_) return;
  if (*own_ >= table_.references())
    throw InputError("own", std::to_string(*own_), "must be the index of a reference");
  if (const double slope = slope_along(table_, *own_); slope > most_slope)
    throw InputError("values", "",
                     "change by up to " + six_digits(slope) +
                         " times the distance of the points; at most " + six_digits(most_slope) +
                         " times is permitted: lower the values, or raise interval");
  if (modulo != 0) require_closed(spec.table, *own_, modulo);
}

Jet LiveCompensation::correction() const {
  if (!active_) return {};
  return table_.at(std::span<const Jet>(references_).first(table_.references()));
}

double LiveCompensation::at(double position) const {
  std::array<double, Compensation::most_references> places{};
  for (std::size_t j = 0; j < table_.references(); ++j) places[j] = references_[j][0];
  if (own_) places[*own_] = modulo_ != 0 ? wrapped(position, 0, modulo_) : position;
  return table_.at(std::span<const double>(places).first(table_.references()));
}

/// Fixed-point iteration: each step halves the error at least, because of most_slope.
double LiveCompensation::position_of(double drive) const {
  if (!active_ || !std::isfinite(drive)) return drive;
  constexpr int most_steps = 60;
  double position = drive - at(drive);
  for (int i = 0; i < most_steps; ++i) {
    const double next = drive - at(position);
    if (next == position) break;
    position = next;
  }
  return position;
}

}  // namespace jounce
