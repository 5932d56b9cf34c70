#pragma once

#include <optional>
#include <string>

#include "jounce/io/spec.hpp"

namespace jounce::cli {

struct ParameterOptions {
  std::string output;  ///< the spec with the numbers of the best; "": none
  std::string table;   ///< its table; "": none
  bool json = false;
  std::optional<double> seconds = {};  ///< over the spec's own
};

/// `jounce optimize` of a spec with [[optimize.parameter]]: searches, prints, writes; the exit status.
int optimize_parameters(Spec spec, const ParameterOptions& options);

}  // namespace jounce::cli
