// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/spec/detail/toml_reader.hpp"

namespace jounce::spec_detail {

/// A share: a number such as 0.05, or a text such as "5 %". Throws InputError, with its place, for
/// anything else.
std::optional<double> optional_share(TomlReader& table, const char* key);

}  // namespace jounce::spec_detail
