// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace jounce::web {

/// The live page, from three files in web/page/: HTML with this title and, if not empty, this
/// warning; its script; its style, which extends that of the report page. They load nothing from
/// elsewhere.
std::string page(const std::string& title, const std::string& warning = {});
std::string_view script();
std::string style();

}  // namespace jounce::web
