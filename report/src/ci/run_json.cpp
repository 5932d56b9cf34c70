// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <nlohmann/json.hpp>

#include "jounce/report/detail/ci_formats.hpp"

namespace jounce {
namespace {

using Json = nlohmann::ordered_json;

Json number_of(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json();
}

Json whole(int number) {
  return number > 0 ? Json(number) : Json();
}

Json text(const std::string& text) {
  return text.empty() ? Json() : Json(text);
}

Json to_object(const Diagnostic& d) {
  Json object{{"rule", d.rule},
              {"severity", severity(d.level)},
              {"file", d.place.file},
              {"line", whole(d.place.line)},
              {"column", whole(d.place.column)},
              {"key", text(d.key)},
              {"axis", text(d.axis)},
              {"segment", text(d.segment)},
              {"message", d.message},
              {"advice", text(d.advice)},
              {"quantity", text(d.quantity)},
              {"unit", text(d.unit)},
              {"value", number_of(d.value)},
              {"limit", number_of(d.limit)},
              {"margin", number_of(d.margin)},
              {"where", number_of(d.where)},
              {"where_unit", text(d.where_unit)}};
  object["limit_line"] = whole(d.limit_place.line);
  return object;
}

Json to_object(const FileResult& file, bool strict) {
  Json findings = Json::array();
  for (const Diagnostic& each : file.diagnostics) findings.push_back(to_object(each));
  const int status = RunResult{"", {file}}.status(strict);
  return {{"file", file.file},
          {"kind", text(file.kind)},
          {"ok", status == 0},
          {"status", status},
          {"findings", std::move(findings)}};
}

}  // namespace

std::string to_json(const FileResult& file, bool strict) {
  return to_object(file, strict).dump(1) + "\n";
}

std::string to_json(const RunResult& run, bool strict) {
  Json files = Json::array();
  for (const FileResult& file : run.files) files.push_back(to_object(file, strict));
  const int status = run.status(strict);
  return Json{{"ok", status == 0},
              {"status", status},
              {"verb", run.verb},
              {"summary", summary_line(run)},
              {"errors", run.count(Level::error)},
              {"broken", run.count(Level::broken)},
              {"warnings", run.count(Level::warning)},
              {"files", std::move(files)}}
             .dump(1) +
         "\n";
}

}  // namespace jounce
