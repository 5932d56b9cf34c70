// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/cam/laws/spline.hpp"

#include "cam/src/design/least_energy.hpp"

namespace jounce::cam_detail {

/// Constraint that fixes a point of a table.
enum class Pin {
  none,
  lower,  ///< lower bound of the tolerance
  upper,  ///< upper bound of the tolerance
  exact,  ///< no tolerance
  held,   ///< held at its present value: too few others determine the curve
};

/// Least integral of geo_jerk^2 of all curves within the tolerances of a table.
class ToleranceProgram {
 public:
  /// The curve with some points pinned.
  struct Solution {
    std::vector<Pin> pins;
    std::vector<std::size_t> joints;  ///< points where segments meet, ends included
    std::vector<Segment> segments;
    std::vector<double> at;  ///< its value at every point
    std::vector<double>
        gradient;          ///< gradient of the integral by every pinned point's value, or zero
    int solutions = 0;     ///< linear systems solved on the way
    bool optimal = false;  ///< within all tolerances, and every pin satisfies (2)
  };

  explicit ToleranceProgram(const SplineSpec& spec);

  /// Descends from the table itself, never outside a tolerance. Always terminates.
  [[nodiscard]] Solution solve() const;

  /// Upper bound of the excess of the integral over the minimum.
  [[nodiscard]] double gap(const Solution& s) const;

 private:
  [[nodiscard]] Solution start() const;
  void minimum_of_face(Solution& s, const std::vector<double>& now) const;
  void hold(std::vector<Pin>& pins) const;
  void evaluate(Solution& s) const;
  [[nodiscard]] std::vector<EnergyKnot> knots_of(const Solution& s,
                                                 const std::vector<double>& now) const;
  [[nodiscard]] bool wrong(const Solution& s, std::size_t i) const;
  [[nodiscard]] bool release_wrong(Solution& s) const;
  [[nodiscard]] bool advance(Solution& s, std::vector<double>& now) const;
  [[nodiscard]] double excess(std::size_t i, double value) const;
  [[nodiscard]] double bound(std::size_t i, Pin pin) const;
  void set(Solution& s, std::size_t i, Pin pin) const;

  const SplineSpec& spec_;
  bool periodic_;
  double rounding_ = 0;      ///< rounding of the slave positions
  std::size_t determining_;  ///< points that determine a curve without jerk
};

}  // namespace jounce::cam_detail
