#include "jounce/io/spec_edit.hpp"

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include "jounce/io/detail/text_edit.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using detail::Edit;
using detail::offset;

/// `key = value` as a further entry of a knot's table: before the brace of an inline one, otherwise
/// on a line below the master's.
Edit insertion(const std::string& text, const toml::table& table, const char* key, double value) {
  const std::string entry = std::string(key) + " = " + number(value);
  if (table.is_inline()) {
    const std::size_t brace = text.rfind('}', offset(text, table.source().end) - 1);
    const std::size_t last = text.find_last_not_of(" \t", brace - 1) + 1;
    return {last, last, ", " + entry};  // never the first: master and slave stand before
  }
  // Beside the master's own entry, whose line has the indent and, with dotted keys, the prefix.
  const std::size_t at = offset(text, table.get("master")->source().begin);
  const std::size_t master = text.rfind("master", at);
  const std::size_t before = text.find_last_of("{,\n", master);
  const std::size_t begin = text.find_first_not_of(" \t", before + 1);
  const std::string prefixed = text.substr(begin, master - begin) + entry;
  if (text[before] != '\n') return {begin, begin, prefixed + ", "};
  const std::size_t end = std::min(text.find('\n', at), text.size());
  return {end, end, text.substr(before, begin - before) + prefixed};
}

class Editor {
 public:
  explicit Editor(const std::string& text) : text_(text) {}

  void set(const toml::table& table, const char* key, double before, double after, bool may_add) {
    const toml::node* node = table.get(key);
    if (before == after || (node == nullptr && !may_add)) return;
    if (node == nullptr)
      edits_.push_back(insertion(text_, table, key, after));
    else
      edits_.push_back(
          {offset(text_, node->source().begin), offset(text_, node->source().end), number(after)});
  }

  void set(const toml::table& table, const CamKnot& before, const CamKnot& after) {
    set(table, "master", before.master, after.master, false);
    set(table, "slave", before.slave, after.slave, false);
    set(table, "geo_velocity", *before.geo_velocity, *after.geo_velocity, true);
    set(table, "geo_acceleration", *before.geo_acceleration, *after.geo_acceleration, true);
  }

  std::string result() { return detail::edited(text_, std::move(edits_)); }

 private:
  const std::string& text_;
  std::vector<Edit> edits_;
};

}  // namespace

std::string with_knots(const Spec& spec, const CamSpec& cam) {
  const std::string& text = spec.document.text;
  const toml::table root =
      toml::parse(std::string_view(text), std::string_view(spec.document.name));
  const auto before = resolved_knots(std::get<CamSpec>(spec.subject));
  const auto after = resolved_knots(cam);
  assert(before.size() == after.size());
  Editor editor(text);
  editor.set(*root.get("start")->as_table(), before[0], after[0]);
  for (std::size_t i = 1; i < after.size(); ++i)
    editor.set(*root["segment"][i - 1]["end"].as_table(), before[i], after[i]);
  return editor.result();
}

}  // namespace jounce
