// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "jounce/about/build_info.hpp"
#include "jounce/about/program.hpp"

namespace jounce {

/// The manual page of the program in roff, with the macros of man(7): jounce(1). `build` gives its
/// version and date.
std::string man_page(const ProgramInfo& program, const BuildInfo& build);

/// The manual page of one verb: jounce-check(1).
std::string man_page(const ProgramInfo& program, const VerbInfo& verb, const BuildInfo& build);

/// All pages by file name: the page of the program (jounce.1) and one page for each verb (such as
/// jounce-check.1).
std::map<std::string, std::string> man_pages(const ProgramInfo& program, const BuildInfo& build);

}  // namespace jounce
