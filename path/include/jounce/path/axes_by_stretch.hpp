// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "jounce/path/plan.hpp"

namespace jounce {

/// Makes the segments of to_axes() in parts: each call of next() makes the segments of one stretch
/// of the timing law. So a long plan needs little memory.
///
///     AxesByStretch stretches(motion);
///     while (stretches.next()) use(stretches.segments(0));   // the first axis
class AxesByStretch {
 public:
  /// `plan` must outlive the object. `tolerance`: as for to_axes().
  explicit AxesByStretch(const Plan& plan, double tolerance = 1e-9);

  /// Makes the segments of the next stretch. Returns false after the last one.
  bool next();
  /// The segments of one axis on the present stretch. They are valid until the next call of next().
  [[nodiscard]] std::span<const Segment> segments(std::size_t axis) const {
    return segments_[axis];
  }
  /// For each of these segments, the index of its piece of the path. The indices are valid until
  /// the next call of next().
  [[nodiscard]] std::span<const std::size_t> pieces(std::size_t axis) const {
    return piece_of_[axis];
  }
  /// For each axis, a bound of the error of its fit so far: u, u/s, u/s^2, u/s^3; 0: exact.
  [[nodiscard]] std::span<const Jet> error() const { return error_; }

  /// The law on one piece: its phases, the last one cut at the end of the piece.
  struct Cut {
    std::size_t piece = 0;
    std::vector<Segment> law = {};  ///< position on the piece, from 0 to its length
  };

 private:
  /// A place on a piece.
  struct Place {
    std::size_t piece = 0;
    double offset = 0;
  };

  [[nodiscard]] double offset_of(const LawInterval& stretch) const;

  const Plan& plan_;
  LawStretches::Iterator next_;  // the next stretch
  Place last_;                   // the end of the previous stretch
  std::vector<std::optional<double>>
      ends_;  // ends of the last fits on this piece, one for each axis
  std::vector<Jet> allowed_, error_;
  std::vector<Cut> cuts_;
  std::vector<Segment> pieces_;
  std::vector<std::vector<Segment>> segments_;
  std::vector<std::vector<std::size_t>> piece_of_;
};

}  // namespace jounce
