// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/spec/detail/toml_reader.hpp"

namespace jounce::spec_detail {

/// Returns a share, which is a number such as 0.05 or a text such as "5 %"; nullopt if the key is
/// missing. Throws InputError, with its place, for any other value.
std::optional<double> optional_share(TomlReader& table, const char* key);

}  // namespace jounce::spec_detail
