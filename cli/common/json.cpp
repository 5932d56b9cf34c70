// SPDX-License-Identifier: Apache-2.0
#include "cli/common/json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace jounce::cli {

void print_json(std::FILE* out, const std::string& text) {
  fmt::print(out, "{}\n", nlohmann::ordered_json::parse(text).dump(1));
}

}  // namespace jounce::cli
