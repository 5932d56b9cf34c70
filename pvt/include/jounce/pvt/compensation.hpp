// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "jounce/profiles/curve/fitted.hpp"
#include "jounce/profiles/curve/jet.hpp"

namespace jounce {

/// Interpolation of the correction between the points of the grid.
enum class GridRule : std::uint8_t {
  linear,  ///< straight lines (bilinear, trilinear): the slope steps at the grid lines
  /// Natural spline (bicubic): slope and curvature are continuous; for one or two references.
  cubic,
};

/// The grid points along one reference axis: `count` points at base, base + interval, ...
struct GridAxis {
  double base = 0;        ///< in the unit of the reference
  double interval = 1;    ///< > 0, in the unit of the reference
  std::size_t count = 2;  ///< >= 2
  /// Position of the last point.
  [[nodiscard]] double end() const { return base + interval * static_cast<double>(count - 1); }
};

/// A table of measured errors, as SetupComp, SetupComp2D and SetupComp3D of HIWIN HIMC use it (HMPL
/// manual 14.1).
struct CompensationSpec {
  std::vector<GridAxis> axes = {};  ///< one to three references
  /// Correction at each grid point, in the unit of the corrected position. The index of the first
  /// reference varies fastest.
  std::vector<double> values = {};
  GridRule rule = GridRule::linear;  ///< interpolation between the points
  /// Greatest permitted |value|; default: no limit. HIMC: 1 mm (error 0x0802).
  double most = std::numeric_limits<double>::infinity();
};

/// A correction of a position that depends on the positions x1, x2, x3 of one to three axes
/// (*references*): y_out = y + c(x1, x2, x3).
///
///     const Compensation screw({.axes = {{-100, 200, 5}}, .values = {-0.2, 0.1, -0.3, 0.4, -0.1}});
///     double c = screw.at(std::array{450.0});                          // 0.225
///     Fitted<OverTime> out = compensated(move, screw, {{move}}, 1e-9);  // reference: move itself
///     Report report = check(out.curve, limits);                        // including the correction
///
/// **Outside the grid**, the value at the nearest point of its edge applies (HMPL manual 14.1).
/// **Between the points**, GridRule applies. The HMPL manual does not define the ends of its
/// spline; the ends of this spline are natural.
///
/// A correction is added after the profile generator. With a linear table, the velocity of the
/// output steps whenever a reference passes a grid line, by the reference's speed times the change
/// of slope; check() reports these steps. The cubic rule avoids them, except at the edges of the
/// grid.
///
/// at() and cell() do not allocate, and throw InputError only for a wrong number of references. The
/// constructor throws InputError, with keys that count from 1
/// ("values[3]"), in these cases: no or more than three references; an interval that is not
/// positive; fewer than two points; a number of values that differs from the number of grid points;
/// a value that is not finite, or whose magnitude is above `most`; the cubic rule with three
/// references.
class Compensation {
 public:
  static constexpr std::size_t most_references = 3;  ///< greatest number of references

  explicit Compensation(const CompensationSpec& spec);

  [[nodiscard]] std::size_t references() const { return axes_.size(); }  ///< number of references
  [[nodiscard]] std::span<const GridAxis> axes() const { return axes_; }
  [[nodiscard]] GridRule rule() const { return rule_; }
  /// The greatest |value| of the grid, in the unit of the corrected position.
  [[nodiscard]] double peak() const;

  /// Returns the correction at the positions of the references; `references` has references()
  /// entries.
  [[nodiscard]] double at(std::span<const double> references) const;
  /// Returns the correction and its first two derivatives with respect to time, for references that
  /// move as their jets state. The third derivative is 0. At a grid line, the cell that begins
  /// there gives the derivatives.
  [[nodiscard]] Jet at(std::span<const Jet> references) const;

  /// One cell of the grid. With s = (x - start) / interval in [0, 1] for each reference, the
  /// correction in the cell is the sum of k[i] s1^a s2^b s3^c over a, b, c < order, where i = a +
  /// order (b + order c). If a reference is outside the grid, the cell has no extent along this
  /// reference.
  struct Cell {
    static constexpr std::size_t most_terms = 16;        ///< greatest number of coefficients
    std::size_t order = 2;                               ///< 2: linear, 4: cubic
    std::array<double, most_references> start{};         ///< start of the cell, for each reference
    std::array<double, most_references> per_interval{};  ///< 1 / interval; 0 outside the grid
    std::array<double, most_terms> k{};                  ///< coefficients k
  };
  /// Returns the cell that contains the positions of the references.
  [[nodiscard]] Cell cell(std::span<const double> references) const;

 private:
  void fill(Cell& cell, const std::array<std::size_t, most_references>& interval) const;

  std::vector<GridAxis> axes_;
  GridRule rule_;
  std::vector<double> values_;
  /// For the cubic rule: derivatives at the grid points with respect to s1, to s2, and to both.
  std::array<std::vector<double>, 3> slopes_;
};

/// Returns the corrected motion, motion + c(references). Requires that all curves cover the same
/// interval; a reference may be the motion itself. No curve may have the policy
/// Extrapolation::advance, because the correction would differ from period to period.
///
/// The result is exact if it fits a segment. With a linear table of one reference, it fits up to
/// degree 11; with two or three references, if the sum of their degrees is at most 11. Otherwise
/// the result is within `tolerance` > 0 (unit of the motion), with a certified error (see
/// fitted.hpp). Outside, it has the policy of the motion. Throws InputError if the intervals differ
/// by more than rounding, if the number of references is wrong, and like composed_within()
/// (composed.hpp).
Fitted<OverTime> compensated(const Trajectory& motion, const Compensation& compensation,
                             std::span<const Trajectory> references, double tolerance);

}  // namespace jounce
