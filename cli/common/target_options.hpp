// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "jounce/controllers/table_target.hpp"

#include "cli/common/verb.hpp"

namespace jounce::cli {

/// The options for a table of fewest knots: the keys of [table]. Units may be omitted.
struct TargetOptions {
  std::string controller;
  std::string tolerance;
  std::string velocity_tolerance;
  std::optional<std::size_t> most;
  std::string spacing;
  std::string resolution;
  std::string position_resolution;
  std::string velocity_resolution;

  [[nodiscard]] bool any() const;
};

/// Returns the options that it added.
std::vector<Option> add_target_options(const Verb& verb, TargetOptions& options);

/// The interpolation of the controller's tables; nullopt without --controller.
std::optional<Interpolation> rule_of(const TargetOptions& options);

/// Target of the options, in these units. Throws InputError that names the option.
Target target_of(const TargetOptions& options, Domain axis, Interpolation rule, const Units& units);

}  // namespace jounce::cli
