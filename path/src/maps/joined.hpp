// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/path/axis_map.hpp"
#include "jounce/path/plan.hpp"

#include "path/src/corners/rounding.hpp"

namespace jounce {

/// A rounded path with the joints as further axes, after the axes of the tool.
struct Jointed {
  Rounded rounded;
  /// Path of the tool with its corners, if the pieces of `rounded` are different.
  std::optional<Path> drawn;
  std::optional<MapFit> fit;
};

/// The joints of a plan, before and behind the rounding of its corners.
///
/// Joints that are linear in the axes are further axes of the route: exact on every piece. All
/// other joints are fitted to the rounded path by polynomials, which then are the path, so their
/// limits hold by exact extrema.
class Joined {
 public:
  /// Throws InputError for joints that do not fit the program or their map.
  Joined(const Program& program, const GroupLimits& limits, const std::optional<JointSpace>& joints,
         const std::atomic<bool>* canceled = nullptr);

  /// Limits of the axes of the tool, then of the joints.
  [[nodiscard]] const GroupLimits& limits() const { return limits_; }
  [[nodiscard]] const Rates& rates() const { return rates_; }

  /// True if the joints are fitted to the rounded path.
  [[nodiscard]] bool fitted() const { return joints_ && joints_->map->linear() == nullptr; }
  /// The route with its linear joints as further axes.
  [[nodiscard]] Route with_linear(Route route) const;
  /// Rates that determine the shape of the corners: the rates of the tool, reduced to the rates
  /// that the joints, which are fitted later, permit at some places of the route. This is only an
  /// estimate: with_fitted() makes sure that the limits hold.
  [[nodiscard]] Rates corner_rates(const Route& route) const;
  /// The path of a rounded `route` with its fitted joints. Throws InputError with the source line
  /// if the tool is out of reach or the map is singular.
  [[nodiscard]] Jointed with_fitted(Rounded rounded, const Route& route) const;

 private:
  const Program& program_;
  const std::optional<JointSpace>& joints_;
  GroupLimits limits_;
  Rates tool_, rates_;
};

}  // namespace jounce
