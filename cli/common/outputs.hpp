// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <initializer_list>
#include <string>

#include "jounce/plot/picture_file.hpp"

/// Files that a verb writes. Check them before the long work whose result they will hold.
namespace jounce::cli {

/// An output option with its path: {"--table", "t.csv"}. An empty path is an option that was not given; "-" is standard
/// output.
struct AskedOutput {
  const char* option;
  const std::string& path;
};

/// Throws InputError if the folder of an output is missing, or the output is itself a folder.
void require_folders(std::initializer_list<AskedOutput> outputs);

/// Throws InputError if both are the same file: an output must not replace its input.
void require_other_file(const std::string& input, const std::string& output,
                        const std::string& option = "--output");

/// The file of one axis: feeder.csv; for several axes feeder-x.csv, feeder-y.csv. Throws InputError under `option` for
/// standard output, which cannot have several.
std::string file_of_axis(const std::string& option, const std::string& path,
                         const std::string& axis, std::size_t axes);

/// Calls write_figure(); errors name --output.
void write_picture(const std::string& path, const Figure& figure, const SvgOptions& options = {});

/// The stream for the summary of a verb: standard error if one of its files is standard output.
std::FILE* text_stream(std::initializer_list<std::string> files);

}  // namespace jounce::cli
