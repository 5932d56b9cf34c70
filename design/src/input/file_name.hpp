// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/design/input.hpp"

namespace jounce::design_detail {

/// Returns the name of the file of a motion, for messages; Input::name is the name of its spec.
inline std::string file_name(const Input& input) {
  return input.spec ? input.spec->document.name : input.name;
}

}  // namespace jounce::design_detail
