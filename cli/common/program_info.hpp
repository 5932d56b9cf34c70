// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "jounce/about/program.hpp"

#include "cli/common/verb.hpp"

namespace jounce::cli {

/// Lines of --help that are also in the manual page.
inline const std::string notes = "Name files as arguments; - is standard input or output.";
inline const std::vector<std::pair<int, std::string>> exit_statuses{
    {fine, "success"},
    {finding, "a broken rule or a rejection"},
    {bad_input, "bad input or usage"},
    {fault, "a fault at run time"}};

/// The visible verbs and options of the parser.
ProgramInfo program_info(const CLI::App& app, const WordsOfOptions& words);

}  // namespace jounce::cli
