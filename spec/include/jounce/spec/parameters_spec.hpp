// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/optimize/search.hpp"

/// Section [optimize] with [[optimize.parameter]]: numbers of the spec that `jounce optimize` may
/// change.

namespace jounce {

/// A number of the spec that may change.
struct SpecParameter {
  std::string key = {};  ///< full key, as in error messages: "segment[2].end.master"
  /// unit of the bounds: the unit of the number in the spec; "1" for a pure number
  std::string unit = {};
  double lower = 0;  ///< least permitted value
  double upper = 0;  ///< greatest permitted value
};

/// Bounds for a key figure (jounce/design/key_figures.hpp): [[optimize.require]]. The bounds are
/// stored as written ("400", "40 cm"), because the unit of the figure is known only when the design
/// exists.
struct FigureBound {
  std::string figure = {};  ///< name of the key figure
  std::optional<std::string> at_least = {};
  std::optional<std::string> at_most = {};
};

/// Input of an optimization of parameters.
struct ParametersSpec {
  std::vector<SpecParameter> parameters = {};
  std::string figure = {};                ///< name of the key figure that is minimized or maximized
  bool maximize = false;                  ///< true: maximize; false: minimize
  std::vector<FigureBound> require = {};  ///< key figures with bounds
  OptimizeOptions options = {};
  bool refine = false;  ///< true: for a path, the timing law is refined afterwards
};

}  // namespace jounce
