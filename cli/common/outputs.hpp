// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <initializer_list>
#include <string>
#include <vector>

#include "jounce/plot/picture_file.hpp"

#include "cli/common/verb.hpp"

/// Files that a verb writes. Check them before the long work whose result they will hold.
namespace jounce::cli {

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
