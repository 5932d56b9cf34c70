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

/// Options of the picture of a curve. All are optional.
struct CurveLook {
  std::string title{};
  std::string axis{};       ///< name of the x axis; by default "time" or "master"
  std::string axis_unit{};  ///< "s", "deg", ...; "deg" and "°" get angular ticks
  std::string unit{};       ///< unit of the position: "mm"; the rates' units follow from both
  std::array<std::string, 3>
      rate_units{};  ///< other units for velocity, acceleration, jerk; "" keeps the above
  std::string label = "curve";  ///< label of the curve and of the one before it, for the legend
  std::string before = "before";
  Limits limits{};
  std::vector<Shade> shades{};
  std::vector<std::vector<Shade>> strips{};    ///< rows of names above, as in a Figure
  std::optional<std::vector<double>> knots{};  ///< thin vertical lines; by default all breaks
};

/// The curve with its three derivatives, stacked: position, velocity, acceleration, jerk over time,
/// or position, geo_velocity, geo_acceleration, geo_jerk over the master.
///
/// Lines are true to half a pixel at 800 px: beside a fixed step, every critical point is among the
/// points, so that between neighbours the curve is monotone and at most half a pixel wide. Jumps
/// are vertical. The exact least and greatest value of each panel are marked, and so is the worst
/// point of the segments (at most eight a panel) that break a limit.
template <class Over>
Figure curve_figure(const Curve<Over>& f, const CurveLook& look);

/// The same over a paler curve: before and after an optimisation, or two versions of a cam.
template <class Over>
Figure curve_figure(const Curve<Over>& f, const Curve<Over>& before, const CurveLook& look);

}  // namespace jounce
