// SPDX-License-Identifier: Apache-2.0
#include "jounce/about/program.hpp"

#include <algorithm>

namespace jounce {

const VerbInfo* ProgramInfo::verb(const std::string& verb_name) const {
  const auto found = std::ranges::find(verbs, verb_name, &VerbInfo::name);
  return found == verbs.end() ? nullptr : &*found;
}

}  // namespace jounce
