// SPDX-License-Identifier: Apache-2.0
#include "cli/common/option_names.hpp"

namespace jounce::cli {

std::string option_of(const std::string& key) {
  if (key == "x_step") return "--resolution";
  if (key == "p_step") return "--position-resolution";
  if (key == "v_step") return "--velocity-resolution";
  if (key == "format") return "--to";
  std::string option = "--" + key;
  std::replace(option.begin(), option.end(), '_', '-');
  return option;
}

}  // namespace jounce::cli
