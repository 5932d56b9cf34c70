// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "jounce/plot/figure.hpp"
#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Options for the figure of a curve. All are optional.
struct CurveLook {
  std::string title{};  ///< title above the plots
  std::string axis{};   ///< name of the x axis; "": "time" or "master"
  /// Unit of the x axis: "s", "deg", ...; "deg" and "°" give angular ticks.
  std::string axis_unit{};
  /// Unit of the position, "mm". With `axis_unit`, it determines the units of the derivatives.
  std::string unit{};
  std::array<std::string, 3>
      rate_units{};  ///< other units for velocity, acceleration, jerk; "": the units above
  std::string label = "curve";    ///< label of the curve in the legend
  std::string before = "before";  ///< label of the pale curve `before`
  Limits limits{};                ///< limits that are drawn
  /// Limits beyond which a point is marked as broken; nullopt: `limits`.
  std::optional<Limits> marked_limits{};
  std::string x_note{};                      ///< shown after the label of the x axis, see Figure
  std::vector<Shade> shades{};               ///< named ranges of the x axis
  std::vector<Shade> names{};                ///< names of ranges beside the shades, see Figure
  std::vector<std::vector<Shade>> strips{};  ///< rows of names above the plots, see Figure
  /// Thin vertical lines; nullopt: at all breaks of the curve.
  std::optional<std::vector<double>> knots{};
};

/// Returns the curve with its three derivatives, in panels above one another: position, velocity,
/// acceleration, jerk over time; or position, geo_velocity, geo_acceleration, geo_jerk over the
/// master.
///
/// At a width of 800 px, lines are accurate to half a pixel. The points have a fixed step and
/// include every critical point, so the curve is monotone between neighboring points. Jumps are
/// vertical. Marks show the exact least and greatest value of each panel, and the worst point of
/// each segment that breaks a limit (at most eight in a panel).
template <class Over>
Figure curve_figure(const Curve<Over>& f, const CurveLook& look);

/// Returns the curve over a pale curve `before`: the motion before an optimization, or another
/// version.
template <class Over>
Figure curve_figure(const Curve<Over>& f, const Curve<Over>& before, const CurveLook& look);

}  // namespace jounce
