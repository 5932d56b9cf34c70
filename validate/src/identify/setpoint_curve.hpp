// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "jounce/profiles/curve/jet.hpp"
#include "jounce/validate/identify.hpp"

#include "validate/src/linear/stepped_reference.hpp"

namespace jounce::validate_detail {

/// The motion through setpoints, a signal: between two of them, the curve of SteppedReference.
/// Setpoints of a standstill are one piece.
class SetpointCurve {
 public:
  /// `setpoints`: two or more, ascending.
  explicit SetpointCurve(const std::vector<RecordedSetpoint>& setpoints);

  [[nodiscard]] double start() const { return breaks_.front(); }
  [[nodiscard]] double end() const { return breaks_.back(); }
  [[nodiscard]] std::span<const double> breaks() const { return breaks_; }
  [[nodiscard]] Jet jet(double t, Side side = Side::right) const;
  /// The setpoint at a break. Its velocity and acceleration can differ from those of a straight piece
  /// that begins or ends there.
  [[nodiscard]] const Jet& setpoint(std::size_t i) const { return setpoints_[i]; }
  /// The cycle of the setpoints, s: their least spacing. Some can be missing.
  [[nodiscard]] double cycle() const { return cycle_; }

 private:
  std::vector<double> breaks_ = {};
  std::vector<Jet> setpoints_ = {};  // at the breaks
  std::vector<SteppedReference> pieces_ = {};
  double cycle_;
};

/// A commanded motion.
struct Commanded {
  SignalView motion;
  const SetpointCurve* setpoints = nullptr;  ///< the same motion, if its setpoints are known
  const Trajectory* coarse = nullptr;  ///< the interpolation of half the samples, if it was sampled
};

}  // namespace jounce::validate_detail
