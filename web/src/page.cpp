// SPDX-License-Identifier: Apache-2.0
#include "web/src/page.hpp"

#include "jounce/plot/page.hpp"

#include "web_files.hpp"

namespace jounce::web {
namespace {

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

}  // namespace

std::string page(const std::string& title, const std::string& warning) {
  std::string out(web_files::page_html);
  const auto fill_in = [&](std::string_view mark, const std::string& text) {
    for (std::size_t at = out.find(mark); at != std::string::npos;
         at = out.find(mark, at + text.size()))
      out.replace(at, mark.size(), text);
  };
  const std::string shown = escaped(warning);
  fill_in("@WARNING@",
          shown.empty() ? "" : "<p class=\"verdict no\" id=\"warning\">" + shown + "</p>");
  fill_in("@TITLE@", escaped(title));
  return out;
}

std::string_view script() {
  return web_files::page_script;
}

std::string style() {
  return page_style() + std::string(web_files::page_rules);
}

std::vector<SiteFile> files_of(const std::string& page) {
  return {{"/", "text/html; charset=utf-8", page},
          {"/panel.js", "text/javascript; charset=utf-8", std::string(script())},
          {"/panel.css", "text/css; charset=utf-8", style()}};
}

}  // namespace jounce::web
