// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/optimize/search.hpp"

/// [optimize] with [[optimize.parameter]]: numbers of the spec itself that `jounce optimize` chooses.
namespace jounce {

/// A number of the spec that may be chosen.
struct SpecParameter {
  std::string key;   ///< its place, as in error messages: "segment[2].end.master"
  std::string unit;  ///< in which the spec counts it, "1" for a pure number: of the two bounds
  double lower = 0;
  double upper = 0;
};

/// [[optimize.require]]: a key figure (jounce/design/key_figures.hpp) held within bounds. They are kept as
/// written, "400" or "40 cm": only the design gives the figure its unit.
struct FigureBound {
  std::string figure;
  std::optional<std::string> at_least = {};
  std::optional<std::string> at_most = {};
};

struct ParametersSpec {
  std::vector<SpecParameter> parameters = {};
  std::string figure = {};  ///< the key figure that it is all for
  bool maximize = false;
  std::vector<FigureBound> require = {};
  OptimizeOptions options = {};
};

}  // namespace jounce
