// SPDX-License-Identifier: Apache-2.0
#include "edit/src/gallery.hpp"

#include <filesystem>
#include <sstream>

#include <nlohmann/json.hpp>

#include "jounce/base/file.hpp"
#include "jounce/design/input.hpp"
#include "jounce/plot/input_figure.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::edit_detail {
namespace {

constexpr double preview_width = 340;  // px
constexpr double preview_height = 90;  // px, of each plot

/// True if a line of the text sets the version of the format: a spec, perhaps with errors.
bool has_version(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::erase_if(line, [](char c) { return c == ' ' || c == '\t'; });
    if (line.starts_with("jounce=")) return true;
  }
  return false;
}

/// The position and velocity of a template.
std::string picture_of(const std::string& kind, const std::string& text) try {
  Figure figure = figure_of(inputs_of(parse_spec(text, kind + ".toml"), kind));
  figure.title.clear();
  figure.strips.clear();
  if (figure.panels.size() > 2) figure.panels.resize(2);
  for (Panel& panel : figure.panels) panel.markers.clear();
  return svg(figure, {.width = preview_width, .panel_height = preview_height});
} catch (const InputError&) {
  return "";  // no motion: an axis, a drive
}

}  // namespace

void require_spec(const std::string& path) {
  std::error_code none;
  if (path == "-" || !std::filesystem::exists(path, none)) return;
  const std::string text = read_file(path);
  const bool is_text = text.find('\0') == std::string::npos;
  const bool is_empty = text.find_first_not_of(" \t\r\n") == std::string::npos;
  if (is_empty || (is_text && has_version(text))) return;
  static_cast<void>(read_inputs(path));  // throws for a file that no verb reads
  throw InputError("", "", "is a table, not a spec: `jounce edit` changes specs").at(path);
}

std::string gallery(const std::map<std::string, std::string>& templates) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const auto& [kind, text] : templates)
    all.push_back({{"kind", kind}, {"text", text}, {"picture", picture_of(kind, text)}});
  return all.dump();
}

}  // namespace jounce::edit_detail
