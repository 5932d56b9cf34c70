// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Text of a finding of check_sync, for the reports: the rules "knife/...", "shear/..." and
/// "gear/...".
bool is_sync_rule(const std::string& rule);
std::string sync_sentence(const Finding& finding, const std::string& where);

}  // namespace jounce
