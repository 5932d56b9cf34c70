// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/base/document.hpp"

namespace jounce::spec_detail {

/// An error of the TOML parser at this place, with the key and the value of the line and with a
/// remedy. `description` is the parser's text.
InputError syntax_error(const Document& document, int line, int column,
                        const std::string& description);

}  // namespace jounce::spec_detail
