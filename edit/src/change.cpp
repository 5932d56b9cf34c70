// SPDX-License-Identifier: Apache-2.0
#include "edit/src/change.hpp"

#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "jounce/profiles/error.hpp"
#include "jounce/spec/detail/text_numbers.hpp"
#include "jounce/spec/spec.hpp"

#include "edit/src/cam_change.hpp"
#include "edit/src/json_reader.hpp"
#include "edit/src/kinds/insert.hpp"

namespace jounce::edit_detail {
namespace {

/// Sets numbers of the text by their keys; null removes one.
ChangedText set_numbers(const std::string& path, const std::string& text,
                        const JsonReader& change) {
  const Spec spec = parse_spec(text, path);
  std::vector<NumberChange> changes;
  for (const std::string& key : change.keys())
    if (key != "do") changes.push_back({key, change.optional_number(key.c_str())});
  if (changes.empty()) throw InputError("change", "", "needs the key of a number");
  std::string label = changes.front().key;
  if (changes.size() > 1) label += fmt::format(" and {} more", changes.size() - 1);
  return {with_numbers(spec.document, changes), std::move(label)};
}

}  // namespace

ChangedText changed(const std::string& path, const std::string& text, const std::string& change) {
  const JsonReader reader("change", change);
  const std::string name = reader.word("do");
  if (name == "numbers") return set_numbers(path, text, reader);
  if (name == "insert") {
    reader.require_only({"do", "at"});
    return {with_point(path, text, reader.number("at")), "insert a point"};
  }
  if (name == "insert_in_plane") {
    reader.require_only({"do", "before", "place"});
    return {
        with_plane_point(path, text, reader.index("before", 1, 1'000'000), reader.numbers("place")),
        "insert a point"};
  }
  if (name == "remove") {
    reader.require_only({"do", "row"});
    return {without_row(text, reader.word("row")), "remove " + reader.word("row")};
  }
  if (auto done = changed_cam(path, text, reader)) return *std::move(done);
  throw InputError("do", name,
                   fmt::format("must be one of numbers, insert, insert_in_plane, remove, {}",
                               fmt::join(cam_changes(), ", ")));
}

}  // namespace jounce::edit_detail
