// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace jounce {

/// True for a file of Jounce: a spec with `jounce = 1` before its first table, a table that Jounce
/// wrote, or a key file (.key) of 64 hexadecimal digits. Only the endings .toml, .csv, .json and .key are read. False
/// for a file that cannot be read.
bool is_jounce_file(const std::string& path);

/// The files that these names stand for, each once, in the order of the names:
///
/// - a folder: every is_jounce_file() in it and below, in the order of the alphabet. Folders whose name begins with a
///   dot, and links to folders, are left out;
/// - a name with `*`, `?` or `[...]` that does not exist: a pattern. `**` stands for any number of folders. Other
///   files than those of Jounce are left out as well;
/// - any other name: the file itself, of Jounce or not.
///
/// Files below the folder `except` are left out; "" excepts none.
std::vector<std::string> find_files(const std::vector<std::string>& names,
                                    const std::string& except = "");

/// True if the name is one file: neither a folder nor a pattern.
bool is_one_file(const std::string& name);

}  // namespace jounce
