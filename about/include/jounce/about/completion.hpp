// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/about/program.hpp"

namespace jounce {

/// A word that can stand at the cursor.
struct Candidate {
  std::string word, help;
  bool operator==(const Candidate&) const = default;
};

struct Completion {
  std::vector<Candidate> candidates;
  bool files = false;  ///< file names can stand there, too
};

/// The words that can stand in place of the last of `words`, which are those of a command line after the name of the
/// program. The last one is not complete, and may be empty. The word "=" alone is the sign between an option and its
/// value: bash splits --format=json there.
Completion complete(const ProgramInfo& program, const std::vector<std::string>& words);

/// Lines for the script of a shell: "WORD<tab>HELP" for each candidate; ":files" if file names can stand there.
std::string completion_lines(const Completion& completion);

/// The shells that have a script: bash, fish, zsh.
std::vector<std::string> completion_shells();

/// The script that connects a shell with complete(), by the command `jounce __complete WORD...`; "" for another shell.
std::string completion_script(const std::string& shell);

}  // namespace jounce
