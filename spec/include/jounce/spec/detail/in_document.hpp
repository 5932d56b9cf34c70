// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/profiles/error.hpp"

namespace jounce::spec_detail {

/// Returns the error with another key.
inline InputError renamed(const InputError& error, const std::string& key) {
  return {key, error.value(), error.rule()};
}

/// Calls make() and converts the keys of its InputError to keys of the document: fields of a
/// generator are in `table`, and limits of the slave in [limits.slave].
template <class Make>
auto in_document(const std::string& table, const Make& make) -> decltype(make()) {
  try {
    return make();
  } catch (const InputError& error) {
    const bool limit = error.key().starts_with("limits.");
    std::string rule = error.rule();
    if (const auto at = rule.rfind("limits."); at != std::string::npos)
      rule.insert(at + 7, "slave.");
    throw InputError(limit ? "limits.slave." + error.key().substr(7) : table + error.key(),
                     error.value(), rule);
  }
}

}  // namespace jounce::spec_detail
