// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce::edit_detail {

/// The page of the editor, its script and its style.
std::string page();
std::string script();
std::string style();

}  // namespace jounce::edit_detail
