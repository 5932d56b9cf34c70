// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace jounce {

/// True for a file of Jounce: a spec with `jounce = 1` before its first section, a table that
/// Jounce wrote, or a key file (.key) of 64 hexadecimal digits. Files with endings other than
/// .toml, .csv, .json and .key are not read. False for a file that cannot be read.
bool is_jounce_file(const std::string& path);

/// Returns the files for these names, each file once, in the order of the names:
///
/// - a folder: each is_jounce_file() in it and below it, in alphabetical order. Folders whose name
///   begins with a dot, and links to folders, are skipped;
/// - a name with `*`, `?` or `[...]` that does not exist as a file: a pattern. `**` stands for any
///   number of folders. Only files of Jounce are returned;
/// - any other name: the file itself, even if it is not a file of Jounce.
///
/// Files below the folder `except` are skipped; "": none.
std::vector<std::string> find_files(const std::vector<std::string>& names,
                                    const std::string& except = "");

/// Returns the files for controllers that Jounce wrote (their head names it), in and below the
/// folders among the names. find_files() does not return them.
std::vector<std::string> controller_files(const std::vector<std::string>& names);

/// Returns the G-code programs in and below the folders among the names: files with a usual ending
/// (.ngc, .nc, .cnc, .tap, .gcode, .din, .mpf, .spf) that begin as G-code. find_files() does not
/// return them.
std::vector<std::string> gcode_files(const std::vector<std::string>& names);

/// True if the name is neither a folder nor a pattern.
bool is_one_file(const std::string& name);

}  // namespace jounce
