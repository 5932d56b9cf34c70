// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/base/document.hpp"

namespace jounce::spec_detail {

/// The error for [name] instead of [[name]], at its place.
InputError double_brackets(const Document& document, const std::string& name, Document::Place at);
/// The error for [[name]] instead of [name], at its place.
InputError single_brackets(const Document& document, const std::string& name, Document::Place at);

/// An error of the TOML parser at this place, with the key and the value of the line and with a
/// remedy. `description` is the parser's text.
InputError syntax_error(const Document& document, int line, int column,
                        const std::string& description);

}  // namespace jounce::spec_detail
