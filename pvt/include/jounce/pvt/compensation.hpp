// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "jounce/profiles/curve/fitted.hpp"

namespace jounce {

/// Interpolation of a correction between the points of its grid.
enum class GridRule : std::uint8_t {
  linear,  ///< straight between neighbours (bilinear, trilinear): its slope steps at the grid lines
  cubic,   ///< natural spline (bicubic): slope and curvature continuous; one or two references
};

/// The points along one reference axis: base, base + interval, ..., count of them.
struct GridAxis {
  double base = 0;        ///< unit of the reference
  double interval = 1;    ///< > 0
  std::size_t count = 2;  ///< >= 2
  [[nodiscard]] double end() const { return base + interval * static_cast<double>(count - 1); }
};

/// A table of measured errors as HIWIN HIMC's SetupComp, SetupComp2D and SetupComp3D take it
/// (HMPL manual 14.1). The first reference runs fastest through the values.
struct CompensationSpec {
  std::vector<GridAxis> axes = {};  ///< one to three references
  std::vector<double> values = {};  ///< unit of the corrected position; one a grid point
  GridRule rule = GridRule::linear;
  double most = std::numeric_limits<double>::infinity();  ///< greatest |value|; HIMC: 1 mm (0x0802)
};

/// A correction of a position by the positions of one to three axes: y_out = y + c(x1, x2, x3).
///
///     const Compensation screw({.axes = {{-100, 200, 5}}, .values = {-0.2, 0.1, -0.3, 0.4, -0.1}});
///     double c = screw.at(std::array{450.0});                          // 0.225
///     Fitted<OverTime> out = compensated(move, screw, {{move}}, 1e-9);  // its own reference
///     Report report = check(out.curve, limits);                        // the correction included
///
/// **Edges.** Outside the grid the value of the nearest point of its edge is held (HMPL manual 14.1).
/// **Between** the points: GridRule. HMPL does not give the ends of its spline: natural here.
///
/// A correction does not go through the profile generator: with a linear table the velocity of the
/// output steps wherever a reference passes a grid line, by speed times change of slope. `check`
/// names it; the cubic rule avoids it (except for the edges).
///
/// at() does not allocate or throw. Throws InputError, counting from 1 ("values[3]"), for no or more than three
/// references, an interval that is not positive, fewer than two points, another number of values than grid points, a
/// value that is not finite or above `most`, and the cubic rule with three references.
class Compensation {
 public:
  static constexpr std::size_t most_references = 3;

  explicit Compensation(const CompensationSpec& spec);

  [[nodiscard]] std::size_t references() const { return axes_.size(); }
  [[nodiscard]] std::span<const GridAxis> axes() const { return axes_; }
  [[nodiscard]] GridRule rule() const { return rule_; }
  /// The greatest |value| of the grid.
  [[nodiscard]] double peak() const;

  /// The correction at the positions of the references; as many as references().
  [[nodiscard]] double at(std::span<const double> references) const;

  /// One cell of the grid: c = sum of k[i] s1^a s2^b s3^c with s = (x - start) / interval in [0, 1],
  /// a, b, c < order; i = a + order (b + order c). Outside the grid a cell has no extent there.
  struct Cell {
    static constexpr std::size_t most_terms = 16;
    std::size_t order = 2;  ///< 2 linear, 4 cubic
    std::array<double, most_references> start{};
    std::array<double, most_references> per_interval{};  ///< 1 / interval; 0 outside the grid
    std::array<double, most_terms> k{};
  };
  [[nodiscard]] Cell cell(std::span<const double> references) const;

 private:
  void fill(Cell& cell, const std::array<std::size_t, most_references>& interval) const;

  std::vector<GridAxis> axes_;
  GridRule rule_;
  std::vector<double> values_;
  std::array<std::vector<double>, 3> slopes_;  ///< cubic: by s1, by s2, by both
};

/// The motion as commanded: motion + c(references), all over the same interval; a reference may be
/// the motion itself. None may advance from period to period (Extrapolation::advance): the
/// correction of the next one would differ. Exact if the product of degrees fits a segment (a
/// linear table of one reference, up to degree 11; of two or three, the sum of their degrees), else
/// within `tolerance` > 0 with a certified error, as in fitted.hpp. Policy outside: the motion's.
/// Throws InputError if intervals differ by more than rounding, a number of references is wrong,
/// and as composed_within().
Fitted<OverTime> compensated(const Trajectory& motion, const Compensation& compensation,
                             std::span<const Trajectory> references, double tolerance);

}  // namespace jounce
