// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce::io_detail {

/// The rule for a G number (41 of G41) or a letter that no program for Jounce may contain: its meaning, and a remedy.
std::string rule_of_unsupported(double g_number);
std::string rule_of_unsupported(const std::string& letters);

}  // namespace jounce::io_detail
