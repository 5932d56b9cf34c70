// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "jounce/controllers/table_target.hpp"

#include "cli/common/verb.hpp"

namespace jounce::cli {

/// The options that ask for new knots, as few as do: the keys of [table], with units where wanted.
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

/// Returns what was added.
std::vector<Option> add_target_options(const Verb& verb, TargetOptions& options);

/// The rule that a controller's table has; nothing where none is named.
std::optional<Interpolation> rule_of(const TargetOptions& options);

/// Target of the options, in these units. Throws InputError that names the option.
Target target_of(const TargetOptions& options, Domain axis, Interpolation rule, const Units& units);

}  // namespace jounce::cli
