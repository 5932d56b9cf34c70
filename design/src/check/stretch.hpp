// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "jounce/base/units.hpp"
#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/report/report_text.hpp"

/// The segment of a spec in which a motion breaks a limit, and the numbers of its remedy.
namespace jounce::design_detail {

/// The least peak of the derivative of order k of any motion from rest to rest, for a stroke and a
/// length of 1. The least peak velocity is the mean velocity, so it holds for all motions.
constexpr std::array least_peaks{0.0, 1.0, 4.0, 32.0};

constexpr double rest = 1e-9;    ///< share of the peak: a smaller value at an end is 0
constexpr double beside = 1e-6;  ///< share of a piece: a peak that is so close to its end is there

/// The segment of the spec to which a piece belongs.
struct Stretch {
  double length = 0;
  double stroke = 0;    ///< signed
  bool rests = false;   ///< the derivatives below that of the limit are 0 at both ends
  bool still = false;   ///< velocity and acceleration are 0 at both ends: the shape scales
  bool at_end = false;  ///< the finding is at an end of its piece

  /// True if a longer segment has the same shape.
  [[nodiscard]] bool scales() const { return still && stroke != 0; }
};

/// The part of a motion from x0 to x1, to which the finding belongs.
template <class Over>
Stretch stretch_between(const Curve<Over>& f, double x0, double x1, const Finding& finding,
                        std::size_t order) {
  Stretch s;
  s.length = x1 - x0;
  const Jet begin = f.jet(x0, Side::right);
  const Jet end = f.jet(x1, Side::left);
  s.stroke = end[0] - begin[0];
  const auto is_still = [&](std::size_t below) {
    for (std::size_t k = 1; k < below; ++k) {
      const double scale =
          rest * least_peaks[k] * std::abs(s.stroke) / std::pow(s.length, static_cast<double>(k));
      if (std::abs(begin[k]) > scale || std::abs(end[k]) > scale) return false;
    }
    return true;
  };
  s.rests = is_still(order);
  s.still = is_still(3);
  const double near = beside * s.length;
  s.at_end = finding.where <= x0 + near || finding.where >= x1 - near;
  return s;
}

/// The same for all pieces of the segment of the spec to which the piece of the finding belongs.
template <class Over>
Stretch stretch_of(const Curve<Over>& f, const Labels& labels, const Finding& finding,
                   std::size_t order) {
  const std::size_t count = f.segments().size();
  const auto label = [&](std::size_t i) {
    return i < labels.segments.size() ? labels.segments[i] : std::to_string(i + 1);
  };
  const std::size_t piece = *finding.segment;
  std::size_t first = piece;
  std::size_t last = piece;
  while (first > 0 && label(first - 1) == label(piece)) --first;
  while (last + 1 < count && label(last + 1) == label(piece)) ++last;
  return stretch_between(f, f.breaks()[first], f.breaks()[last + 1], finding, order);
}

/// The order of the derivative of a broken limit with a segment; 0 for any other finding.
inline std::size_t order_of(const Finding& f, const std::array<const char*, 4>& names) {
  if (!f.broken || !f.segment || f.rule.family() != RuleFamily::limit || f.limit == 0) return 0;
  const auto name = std::find(names.begin() + 1, names.end(), std::string_view(f.quantity));
  return name == names.end() ? 0 : static_cast<std::size_t>(name - names.begin());
}

/// The length from which a segment that scales keeps the limit of a finding, with its shape.
inline double least_length(const Finding& f, std::size_t order, const Stretch& s) {
  return s.length * std::pow(std::abs(f.value / f.limit), 1.0 / static_cast<double>(order));
}

/// Numbers with the units of a motion.
struct Words {
  const Labels& labels;

  [[nodiscard]] std::string x(double value) const { return digits(value) + " " + labels.units.x; }
  /// A length, rounded up, so that the limit holds with it.
  [[nodiscard]] std::string at_least(double length) const { return x(rounded_up(length)); }
  [[nodiscard]] std::string of(double value, std::size_t order) const {
    return with_rate_unit(digits(value), order);
  }
  /// A limit, rounded towards 0, so that a number that a user copies keeps it.
  [[nodiscard]] std::string limit(double value, std::size_t order) const {
    return with_rate_unit((value < 0 ? "-" : "") + six_digits_down(std::abs(value)), order);
  }
  [[nodiscard]] std::string with_rate_unit(const std::string& text, std::size_t order) const {
    const std::string unit =
        rate_unit(labels.units.position, labels.units.x, static_cast<int>(order));
    return unit.empty() ? text : text + " " + unit;
  }
  /// Four digits; a large number as in the finding: 100000, not 1e+05.
  static std::string digits(double value) {
    const std::string text = fmt::format("{:.4g}", value);
    return text.find('e') == std::string::npos ? text : six_digits(std::stod(text));
  }
  /// Four digits of a positive number.
  static double rounded_up(double value) {
    const double unit = std::pow(10, std::floor(std::log10(value)) - 3);
    return std::ceil(value / unit) * unit;
  }
};

/// "the segment moves 50 mm in 120 deg: its mean geo_velocity is 0.4167 mm/deg, above the limit ...":
/// "" if a law may keep the limit. The clause ends with a full stop and a blank.
std::string impossibility(const Finding& f, std::size_t order, const Stretch& s, const Words& words,
                          const std::string& who);

}  // namespace jounce::design_detail
