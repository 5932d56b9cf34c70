// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/design/input.hpp"

#include "plot/src/figure/curve_figure.hpp"

namespace jounce {

/// Returns the look of an input's curve: units, limits, sync zones, the segments of its spec.
CurveLook look_of(const Input& input);

/// Returns the curve of another input in the units of this one.
template <class Over>
Curve<Over> in_units_of(const Input& input, const Input& other, const Curve<Over>& curve);

/// Unit of a panel of curve_figure().
struct PanelUnit {
  std::string name;  ///< "mm/s", "m/s^2"
  double size = 1;   ///< the unit, in the unit of the curve: values of the panel are divided by it
};

/// Returns the unit of the panel of a derivative (order: 0 position to 3 jerk).
PanelUnit panel_unit(const CurveLook& look, int order);

}  // namespace jounce
