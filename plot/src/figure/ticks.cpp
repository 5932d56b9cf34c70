// SPDX-License-Identifier: Apache-2.0
#include "plot/src/figure/ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "jounce/profiles/detail/tolerances.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_root;

constexpr double tick_rounding = 1e-9;  ///< share of a step
constexpr double least_span = 1e-290;   ///< a step of a shorter axis is no normal number

/// mantissa * 10^exponent.
struct Step {
  double mantissa = 1;
  int exponent = 0;

  [[nodiscard]] double value() const { return mantissa * std::pow(10.0, exponent); }
};

/// The smallest 1-2-5 step that divides `span` into at most `most` intervals.
Step nice_step(double span, double most) {
  const double raw = span / most;
  const int exponent = static_cast<int>(std::floor(std::log10(raw)));
  for (const double mantissa : {1.0, 2.0, 5.0}) {
    const Step step{mantissa, exponent};
    if (step.value() >= raw * (1 - tick_rounding)) return step;
  }
  return {1, exponent + 1};
}

Step angle_step(double span, double most) {
  constexpr std::array steps{5.0, 10.0, 15.0, 30.0, 45.0, 60.0, 90.0, 180.0};
  for (const double step : steps)
    if (step * most >= span * (1 - tick_rounding)) return {step, 0};
  const Step turns = nice_step(span / 360, most);
  return {360 * std::max(1.0, turns.value()), 0};
}

/// Labels of large and small numbers share a power of a thousand, so that they stay short.
int shared_exponent(double largest) {
  if (largest < 1e5 && largest >= 1e-2) return 0;
  return 3 * static_cast<int>(std::floor(std::log10(largest) / 3));
}

std::string label(double value, int decimals) {
  if (value == 0) return "0";
  const std::string text = fmt::format("{:.{}f}", std::abs(value), decimals);
  return value < 0 ? "−" + text : text;
}

Ticks ticks_at(PlotRange axis, Step step) {
  const double width = step.value();
  const double first = std::ceil(axis.lo / width - tick_rounding);
  const double last = std::floor(axis.hi / width + tick_rounding);
  Ticks out;
  const double largest = std::max(std::abs(first), std::abs(last)) * width;
  out.exponent = largest > 0 ? shared_exponent(largest) : 0;
  const int exponent = step.exponent - out.exponent;
  const int count = static_cast<int>(last - first) + 1;  // 0 or less if no tick falls inside
  for (int k = 0; k < count; ++k) {
    const double i = first + k;
    out.at.push_back(i * width);
    out.labels.push_back(
        label(i * step.mantissa * std::pow(10.0, exponent), std::max(0, -exponent)));
  }
  return out;
}

/// The ticks of an axis of logarithms at every `stride`-th power of ten, times each of the mantissas.
Ticks ticks_of_decades(PlotRange axis, int stride, std::span<const double> mantissas) {
  Ticks out;
  const int first = static_cast<int>(std::floor(axis.lo / stride)) * stride;
  for (int decade = first; decade <= axis.hi; decade += stride)
    for (const double mantissa : mantissas) {
      const double at = decade + std::log10(mantissa);
      if (at < axis.lo - tick_rounding || at > axis.hi + tick_rounding) continue;
      out.at.push_back(at);
      out.labels.push_back(fmt::format("{:.10g}", mantissa * std::pow(10.0, decade)));
    }
  return out;
}

}  // namespace

void PlotRange::add(double value) {
  if (!drawable(value)) return;
  const bool first = empty();
  lo = first ? value : std::min(lo, value);
  hi = first ? value : std::max(hi, value);
}

bool drawable(double value) {
  return std::abs(value) <= 1e300;  // false for nan, too
}

PlotRange axis_extent(PlotRange data, double noise) {
  if (data.empty()) return {-1, 1};
  const double largest = std::max(std::abs(data.lo), std::abs(data.hi));
  // The last term: below it, a step of the axis would be no normal number.
  if (data.span() > std::max({noise, rounded_root * largest, least_span})) return data;
  const double middle = data.lo + data.span() / 2;
  if (std::abs(middle) <= std::max(noise, least_span)) return {-1, 1};
  return {middle - 0.1 * std::abs(middle), middle + 0.1 * std::abs(middle)};
}

Ticks ticks(PlotRange axis, int most) {
  return ticks_at(axis, nice_step(axis.span(), most));
}

Ticks angle_ticks(PlotRange axis, int most) {
  const bool wide = axis.span() >= 60 && axis.span() <= 1e6;
  return wide ? ticks_at(axis, angle_step(axis.span(), most)) : ticks(axis, most);
}

Ticks decade_ticks(PlotRange axis, int most) {
  constexpr std::array fine{1.0, 2.0, 5.0};
  const auto fits = [&](const Ticks& t) {
    return t.at.size() <= static_cast<std::size_t>(most) + 1;
  };
  Ticks found = ticks_of_decades(axis, 1, fine);
  for (int stride = 1; !fits(found) && stride < 700; ++stride)
    found = ticks_of_decades(axis, stride, std::span(fine).first(1));
  return found;
}

}  // namespace jounce
