// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "jounce/base/file.hpp"
#include "jounce/controllers/exchange/exchange.hpp"
#include "jounce/design/input.hpp"

#include "design/src/input/against_spec.hpp"

namespace jounce {
namespace {

std::string name_of(const std::string& path) {
  return path == "-" ? "standard input" : path;
}

/// One input for each cam. If there are several, each has the name of its cam as its axis.
std::vector<Input> cams_of(const std::string& text, const std::string& name, bool decimal_comma) {
  std::vector<ExchangeTable> cams = parse_exchange_tables(text, name, decimal_comma);
  const bool several = cams.size() > 1;
  std::vector<Input> all;
  for (ExchangeTable& cam : cams) {
    Input input = input_of(std::move(cam.file), several ? name + " " + cam.name : name);
    if (several) input.axis = cam.name;
    input.unread = std::move(cam.unread);
    all.push_back(std::move(input));
  }
  return all;
}

}  // namespace

std::vector<Input> read_inputs(const std::string& path, bool decimal_comma) {
  std::string text = read_file(path);
  if (path.ends_with(".dxf") || path.ends_with(".svg"))
    throw InputError("", "", "is a drawing: `jounce fit` makes the spec of a cam from it").at(path);
  if (is_finished_table(text, path)) return table_inputs(text, path, decimal_comma);
  return inputs_of(parse_spec(std::move(text), name_of(path)), path);
}

bool is_finished_table(const std::string& text, const std::string& path) {
  return is_table(text) || exchange_format_of_text(text, path) != nullptr;
}

std::vector<Input> table_inputs(const std::string& text, const std::string& path,
                                bool decimal_comma) {
  const std::string name = name_of(path);
  std::vector<Input> all;
  if (is_table(text)) {
    all.push_back(input_of(parse_table(text, name), name));
    all.front().newer_spec = newer_spec(all.front().table.provenance, path);
  } else {
    all = cams_of(text, name, decimal_comma);
  }
  for (Input& input : all) {
    input.file = path;
    input.files = {path};
    if (!is_table(text)) input.format = exchange_format_of_text(text, path);
  }
  return all;
}

}  // namespace jounce
