// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace jounce::web {

/// The live page, in three files that web/page/ holds as such: HTML with this title and, where there is one,
/// this warning; its script; its style, which is the report page's and a little more. They load nothing
/// from elsewhere.
std::string page(const std::string& title, const std::string& warning = {});
std::string_view script();
std::string style();

}  // namespace jounce::web
