// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <initializer_list>
#include <string>
#include <vector>

#include "jounce/profiles/error.hpp"

namespace jounce {

/// Selects what read_file() does with a zip archive, such as a workbook (.xlsx).
enum class Archive {
  rejected,  ///< throws InputError
  returned,  ///< returns its bytes
};

/// Returns the whole file as bytes, without a byte order mark. Text in UTF-16 with a byte order
/// mark is returned as UTF-8. "-" is standard input. Throws InputError, with the file's name as the
/// document, for a file that cannot be read, for broken UTF-16, and for a compressed file.
std::string read_file(const std::string& path, Archive archive = Archive::rejected);

/// Throws InputError, with `option` as its key, if `output` is one of the files `inputs`, under any
/// name: an output must not replace an input. A path of an input may end in # and the name of a
/// sheet or a layer.
void require_no_input(const std::vector<std::string>& inputs, const std::string& output,
                      const std::string& option = "output");

/// Returns the stream for the summary of a command: standard error if one of its files is standard
/// output ("-"). Throws InputError (key "--json") if the summary is JSON and a file is standard
/// output, because standard output can have only one of the two.
std::FILE* text_stream(bool json, std::initializer_list<std::string> files);

/// Throws InputError, with `option` as its key, if both paths lead to one file: an output must not
/// replace its input. "-" is no file.
void require_other_file(const std::string& input, const std::string& output,
                        const std::string& option);

/// A file to be written.
struct Output {
  std::string path = {};   ///< path of the file; "-" is standard output
  std::string bytes = {};  ///< the whole content
};

/// Writes all files or none: writes them under temporary names in their folders, then renames them.
/// An existing file that is not regular (a device, a pipe) is written directly. Throws
/// std::system_error if the system reports an error (no folder, no space), and InputError like
/// require_no_input(), for the files that the program has read.
void write_files(const std::vector<Output>& files, const std::vector<std::string>& inputs = {});
/// Like write_files(), for one file.
void write_file(const std::string& path, const std::string& bytes,
                const std::vector<std::string>& inputs = {});

}  // namespace jounce
