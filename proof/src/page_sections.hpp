// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/design/input.hpp"
#include "jounce/plot/page.hpp"

/// Sections of the page of `jounce report`.
namespace jounce {

/// The path of an input with a plan: its picture in the plane of its first two axes, its duration,
/// and the places that cost most.
Section path_section(const Input& input);

/// The plate of a cam with [disc]. Requires a spec with [disc].
Section disc_section(const Input& input);

/// The text of the spec, with the findings at their lines. Requires a spec.
Section spec_section(const Input& input, const Report& findings);

/// The result of the optimizer: gain and bound of each objective, active limits, prices of the
/// limits. `json`: the output of `jounce optimize --json`; `name`: its file, for messages. Throws
/// InputError for another text.
Section optimum_section(const std::string& json, const std::string& name, const Labels& labels);

}  // namespace jounce
