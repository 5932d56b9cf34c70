// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <string>

namespace jounce::cli {

/// Prints a JSON text of the library with an indent of one space.
void print_json(std::FILE* out, const std::string& text);
inline void print_json(const std::string& text) {
  print_json(stdout, text);
}

}  // namespace jounce::cli
