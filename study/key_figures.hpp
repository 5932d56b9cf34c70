#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/io/make.hpp"

namespace jounce {

/// One number that says how good a design is: "duration", "peak velocity", "rms acceleration", "peak
/// geo_jerk", "peak torque", "residual", "margin" (the smallest of all checks) ...
struct KeyFigure {
  std::string name;
  double value = 0;
  std::string unit;
};

/// A design looked at as a whole.
struct Assessment {
  std::vector<KeyFigure> figures;
  Report report;  ///< every limit that the spec states: check, and the drive where it has one

  [[nodiscard]] std::optional<double> value(const std::string& name) const;
};

/// Makes the spec, checks it against its limits and, where it has a [drive], drives it. Only what
/// `names` asks for is computed where that saves the drive's integration; none: everything. Throws
/// InputError as make() does, and for a name that this spec has no figure for (with those it has).
Assessment assess(const Spec& spec, const std::vector<std::string>& names = {});

}  // namespace jounce
