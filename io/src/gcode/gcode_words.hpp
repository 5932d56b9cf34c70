// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce::io_detail {

/// Returns the rule for a G number (41 for G41) or for letters that Jounce does not support: the
/// meaning, and a remedy.
std::string rule_of_unsupported(double g_number);
std::string rule_of_unsupported(const std::string& letters);

}  // namespace jounce::io_detail
