// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/about/program.hpp"

namespace jounce {

/// A word that can stand at the cursor.
struct Candidate {
  std::string word = {}, help = {};
  bool operator==(const Candidate&) const = default;
};

/// The candidates for a word.
struct Completion {
  std::vector<Candidate> candidates = {};
  bool files = false;  ///< file names can also stand at the cursor
};

/// Returns the candidates for the last of `words`. `words` are the words of a command line after
/// the name of the program; the last one is not complete, and may be empty. A word "=" separates an
/// option from its value, because bash splits --format=json at the sign.
Completion complete(const ProgramInfo& program, const std::vector<std::string>& words);

/// Lines for the script of a shell: "WORD<tab>HELP" for each candidate; ":files" if file names can
/// also stand at the cursor.
std::string completion_lines(const Completion& completion);

/// The shells that have a script: bash, fish, zsh.
std::vector<std::string> completion_shells();

/// The script that connects a shell with complete(), by the command `jounce __complete WORD...`; ""
/// for another shell.
std::string completion_script(const std::string& shell);

}  // namespace jounce
