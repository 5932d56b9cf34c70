// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/base/document.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {

/// A key whose value differs between two specs.
struct KeyChange {
  std::string key = {};     ///< full name: "limits.slave.velocity", "segment[2].law"
  std::string before = {};  ///< value with its unit in the earlier spec; "": no such key
  std::string after = {};   ///< value with its unit in the later spec; "": no such key
  bool limit = false;       ///< true for a key of a table `limits`, and for one named `..._limit`
  Document::Place place = {};  ///< place of the key, or of its table, in the later spec
};

/// Returns all keys whose values differ, those of `after` in the order of the text, then the keys
/// that only `before` has. Numbers are equal if they are the same quantity in the units of the two
/// specs: "1 cm" and 10 with the unit mm. Comments and the order of the keys do not count. Files
/// that the specs name are not read.
std::vector<KeyChange> changed_keys(const Spec& before, const Spec& after);

}  // namespace jounce
