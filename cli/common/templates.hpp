// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

namespace jounce::cli {

/// The commented starting spec of each kind.
const std::map<std::string, std::string>& templates();

}  // namespace jounce::cli
