// SPDX-License-Identifier: Apache-2.0
#include "edit/src/page.hpp"

#include "jounce/plot/page.hpp"

#include "edit_files.hpp"

namespace jounce::edit_detail {

std::string page() {
  return std::string(edit_files::page_html);
}

std::string script() {
  return std::string(report_script()) + std::string(edit_files::page_script);
}

std::string style() {
  return page_style() + report_style() + std::string(edit_files::page_rules);
}

}  // namespace jounce::edit_detail
