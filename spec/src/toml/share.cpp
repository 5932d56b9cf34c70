// SPDX-License-Identifier: Apache-2.0
#include "jounce/spec/detail/share.hpp"

#include <string>

#include "jounce/base/units.hpp"

namespace jounce::spec_detail {

std::optional<double> optional_share(TomlReader& table, const char* key) {
  if (table.is_faulty(key) || !table.is_text(key)) return table.optional_number(key, "1");
  const std::string given = table.text(key);
  const std::size_t sign = given.find('%');
  try {
    if (sign != given.npos && given.find_first_not_of(" \t", sign + 1) == given.npos)
      return quantity(given.substr(0, sign), "1") / 100;
  } catch (const InputError&) {  // the error below shows the form of a share
  }
  table.fail(key, '"' + given + '"', "must be a share such as \"5 %\" or 0.05");
}

}  // namespace jounce::spec_detail
