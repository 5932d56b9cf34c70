// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/spec/detail/toml_reader.hpp"

namespace jounce::spec_detail {

/// A share of something: 0.05, or "5 %". Throws InputError, placed, for anything else.
std::optional<double> optional_share(TomlReader& table, const char* key);

}  // namespace jounce::spec_detail
