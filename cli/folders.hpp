#pragma once

#include <initializer_list>
#include <string>

namespace jounce::cli {

/// An output as it was asked for: {"--table", "t.csv"}; empty where it was not, "-" is standard output.
struct AskedOutput {
  const char* option;
  const std::string& path;
};

/// Throws InputError where the folder of an output is missing, or the output is itself a folder: told
/// before the long work whose result it is to hold, not after.
void require_folders(std::initializer_list<AskedOutput> outputs);

}  // namespace jounce::cli
