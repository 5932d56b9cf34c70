// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "jounce/spec/spec.hpp"

/// Options of `jounce optimize`, each kind of freedom in its own file.
namespace jounce::cli {

struct OptimizeArguments {
  std::string spec;
  std::string output;
  std::string table;
  std::string plot;
  std::string against;  ///< file of a drive
  bool json = false;
  std::optional<double> seconds = {};  ///< over the spec's own time budget
};

/// Free knots, free shapes and [[optimize.parameter]]: solved, printed, and written if they keep the
/// limits. Return the exit status.
int optimize_knots(const OptimizeArguments& options, const Spec& spec);
int optimize_shapes(const OptimizeArguments& options, const Spec& spec);
/// Free shapes through the drive of options.against.
int optimize_against(const OptimizeArguments& options, const Spec& spec);
int optimize_parameters(const OptimizeArguments& options, const Spec& spec);

/// Stream for the outcome: a spec, table or picture on standard output has that stream for itself.
std::FILE* text_stream(const OptimizeArguments& options);

/// Ends an optimization. `optimized` is the text of the optimized spec, if it keeps the limits.
/// With --json it prints `document` and adds "peaks", else the peaks for people (peaks.hpp). Then it writes
/// the spec, its table and the picture of both, all of them or none; none where `jounce check` finds a
/// fault in the spec: then the faults are printed. Returns the exit status.
int finish(const OptimizeArguments& options, const Spec& given, nlohmann::ordered_json document,
           const std::optional<std::string>& optimized);

}  // namespace jounce::cli
