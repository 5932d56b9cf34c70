#include "jounce/web/page.hpp"

#include "jounce/plot/page.hpp"

#include "page_files.hpp"

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

std::string page(const std::string& title) {
  constexpr std::string_view mark = "@TITLE@";
  std::string out(page_html);
  for (std::size_t at = out.find(mark); at != std::string::npos; at = out.find(mark, at))
    out.replace(at, mark.size(), escaped(title));
  return out;
}

std::string_view script() {
  return page_script;
}

std::string style() {
  return page_style() + std::string(page_rules);
}

}  // namespace jounce::web
