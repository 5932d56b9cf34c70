// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "jounce/web/server.hpp"

namespace jounce::web {

/// Returns the HTML of the live page. `title`: title of the page. `warning`: shown at the top; "":
/// none. The page, its script and its style come from three files in web/page/, and load nothing
/// else.
std::string page(const std::string& title, const std::string& warning = {});
/// Returns the JavaScript of the live page.
std::string_view script();
/// Returns the CSS of the live page, which extends the CSS of the report page.
std::string style();

/// The files of a live page.
std::vector<SiteFile> files_of(const std::string& page);

}  // namespace jounce::web
