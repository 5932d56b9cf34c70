// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <string>

namespace jounce::cli {

/// An output option with its path: {"--table", "t.csv"}. An empty path is an option that was not given; "-" is standard
/// output.
struct AskedOutput {
  const char* option;
  const std::string& path;
};

/// Throws InputError if the folder of an output is missing, or the output is itself a folder. Call it
/// before the long work whose result the file will hold.
void require_folders(std::initializer_list<AskedOutput> outputs);

}  // namespace jounce::cli
