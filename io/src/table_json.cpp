// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "jounce/base/detail/printable.hpp"
#include "jounce/base/units.hpp"
#include "jounce/io/detail/table_parts.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using Json = nlohmann::ordered_json;

/// An object of the document while it is read: holds its path, requires types, rejects unread keys.
class JsonReader {
 public:
  JsonReader(const Json& object, std::string path, const std::string& document)
      : object_(object), path_(std::move(path)), document_(document) {
    if (!object.is_object()) fail("", object.dump(), "must be an object");
  }

  [[noreturn]] void fail(const std::string& key, const std::string& value,
                         const std::string& rule) const {
    throw InputError(path_ + key, value.size() > 60 ? value.substr(0, 57) + "..." : value, rule)
        .at(document_);
  }

  const Json& require(const char* key) {
    known_.insert(key);
    const auto it = object_.find(key);
    if (it == object_.end()) fail(key, "", "is missing: a Jounce table in JSON needs this key");
    return *it;
  }

  std::string text(const char* key) {
    const Json& value = require(key);
    if (!value.is_string()) fail(key, value.dump(), "must be a string");
    auto text = value.get<std::string>();
    if (!is_printable(text)) fail(key, printable(text), "must not contain control characters");
    return text;
  }

  std::string optional_text(const char* key) {
    return object_.contains(key) ? text(key) : std::string();
  }

  JsonReader object(const char* key) { return {require(key), path_ + key + ".", document_}; }

  std::vector<double> numbers(const char* key) {
    const Json& list = require(key);
    if (!list.is_array()) fail(key, list.dump(), "must be a list of numbers");
    std::vector<double> values;
    for (const Json& value : list) {
      if (!value.is_number() || !std::isfinite(value.get<double>()))
        fail(std::string(key) + "[" + std::to_string(values.size() + 1) + "]", value.dump(),
             "must be a finite number");
      values.push_back(value.get<double>());
    }
    return values;
  }

  void finish() const {
    for (const auto& [key, value] : object_.items())
      if (!known_.contains(key)) fail(key, value.dump(), "is not a key of this object");
  }

 private:
  const Json& object_;
  std::string path_;
  const std::string& document_;
  std::set<std::string> known_;
};

/// nlohmann silently keeps the last of two equal keys; a table must not be ambiguous.
Json parse_strictly(const std::string& text, const std::string& document) {
  std::vector<std::set<std::string>> keys;
  const auto watch = [&](int, Json::parse_event_t event, Json& value) {
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && !keys.back().insert(value.get<std::string>()).second)
      throw InputError(value.get<std::string>(), "", "is given twice: remove one").at(document);
    return true;
  };
  try {
    return Json::parse(text, watch);
  } catch (const Json::parse_error& error) {
    if (error.byte >= text.size())
      throw InputError("", "", "is not complete: the file ends within its JSON; export it again")
          .at(document);
    throw InputError("", "", "is not JSON: its syntax is wrong here")
        .at(document,
            1 + static_cast<int>(std::count(
                    text.begin(), text.begin() + static_cast<std::ptrdiff_t>(error.byte), '\n')));
  } catch (const Json::exception& error) {
    const std::string what = error.what();
    throw InputError("", "",
                     "is not JSON: " + what.substr(std::min(what.find("] ") + 2, what.size())))
        .at(document);
  }
}

}  // namespace

std::string to_json(const TableFile& file) {
  const Table& table = file.table;
  const auto names = io_detail::column_names(table.axis(), table.rule());
  Json units;
  Json columns;
  const auto& [x, p, v, a] = table.columns();
  const std::array all{&x, &p, &v, &a};
  for (std::size_t i = 0; i < names.size(); ++i) {
    units[names[i]] = i == 0
                          ? file.units.x
                          : rate_unit(file.units.position, file.units.x, static_cast<int>(i) - 1);
    columns[names[i]] = *all[i];
  }
  const Json document{{"jounce_table", io_detail::schema_version},
                      {"axis", name(table.axis())},
                      {"rule", name(table.rule())},
                      {"outside", name(table.outside())},
                      {"knots", table.size()},
                      {"sha256", hex(content_hash(table, file.units))},
                      {"provenance",
                       {{"spec", file.provenance.spec},
                        {"spec_sha256", file.provenance.spec_sha256},
                        {"made_by", file.provenance.made_by}}},
                      {"units", std::move(units)},
                      {"columns", std::move(columns)}};
  return document.dump(1) + "\n";
}

namespace io_detail {

TableParts parse_json(const std::string& text, const std::string& name) {
  const Json root = parse_strictly(text, name);
  JsonReader top(root, "", name);
  const auto fail = [&](const char* key) {
    return [&top, key](const std::string& value, const std::string& rule) {
      top.fail(key, value, rule);
    };
  };
  require_version(top.require("jounce_table").dump(), fail("jounce_table"));
  TableParts parts;
  const auto pick = [&](const char* key, const auto& all) {
    return choice(top.text(key), std::span(all), fail(key));
  };
  parts.axis = pick("axis", axes);
  parts.rule = pick("rule", rules);
  parts.outside = pick("outside", policies);
  parts.sha256 = top.text("sha256");
  JsonReader provenance = top.object("provenance");
  parts.provenance = {provenance.optional_text("spec"), provenance.optional_text("spec_sha256"),
                      provenance.optional_text("made_by")};
  provenance.finish();

  const auto names = column_names(parts.axis, parts.rule);
  const std::array all{&parts.columns.x, &parts.columns.p, &parts.columns.v, &parts.columns.a};
  JsonReader units = top.object("units");
  JsonReader columns = top.object("columns");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string unit = units.text(names[i].c_str());
    const std::string rule = take_unit(parts, i, unit);
    if (!rule.empty()) units.fail(names[i], unit, rule);
    *all[i] = columns.numbers(names[i].c_str());
  }
  units.finish();
  columns.finish();
  const std::string knots = top.require("knots").dump();
  if (knots != std::to_string(parts.columns.x.size()))
    top.fail("knots", knots,
             "the number of rows in the columns is " + std::to_string(parts.columns.x.size()));
  top.finish();
  return parts;
}

}  // namespace io_detail
}  // namespace jounce
