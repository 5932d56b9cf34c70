// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/document.hpp"

namespace jounce {

InputError Document::located(const InputError& error) const {
  if (!error.document().empty()) return error;
  for (std::string key = error.key();; key.erase(key.find_last_of(".["))) {
    if (const auto it = places.find(key); it != places.end())
      return error.at(name, it->second.line, it->second.column);
    if (key.find_last_of(".[") == std::string::npos) return error.at(name);
  }
}

InputError Document::naming(const std::string& key, const std::string& file,
                            const InputError& error) const {
  const bool unread = error.key().empty() && error.value().empty();
  return unread ? located(InputError(key, file, error.rule())) : error;
}

}  // namespace jounce
