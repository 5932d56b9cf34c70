// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/common/verb.hpp"

namespace jounce::cli {

/// `jounce page`.
void add_page(CommandLine& line);

}  // namespace jounce::cli
