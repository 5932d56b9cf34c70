// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/report/detail/ci_formats.hpp"
#include "jounce/report/rules.hpp"

#include "report/src/ci/shared.hpp"

namespace jounce {
namespace {

using Json = nlohmann::ordered_json;

const char* sarif_level(Level level) {
  return level == Level::warning ? "warning" : "error";
}

/// The path as a relative URI (RFC 3986).
std::string uri(std::string_view path) {
  std::string out;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = byte < 0x80 && (std::isalnum(byte) != 0 ||
                                       std::string_view("-._~/").find(c) != std::string_view::npos);
    out += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return out;
}

Json location(const FilePlace& place) {
  Json physical{{"artifactLocation", {{"uri", uri(place.file)}, {"uriBaseId", "%SRCROOT%"}}}};
  if (place.line > 0) physical["region"]["startLine"] = place.line;
  if (place.line > 0 && place.column > 0) physical["region"]["startColumn"] = place.column;
  return {{"physicalLocation", std::move(physical)}};
}

Json rule_object(const std::string& rule, Level level) {
  Json object{{"id", rule}};
  if (const RuleInfo* info = rule_info(rule); info != nullptr) {
    object["shortDescription"]["text"] = info->meaning;
    object["help"]["text"] = info->remedy;
  }
  object["defaultConfiguration"]["level"] = sarif_level(level);
  return object;
}

Json properties(const Diagnostic& d) {
  Json object = Json::object();
  for (const auto& [name, value] :
       {std::pair{"value", d.value}, {"limit", d.limit}, {"margin", d.margin}, {"where", d.where}})
    if (value && std::isfinite(*value)) object[name] = *value;
  for (const auto& [name, text] : {std::pair<const char*, const std::string&>{"unit", d.unit},
                                   {"quantity", d.quantity},
                                   {"axis", d.axis},
                                   {"segment", d.segment},
                                   {"key", d.key}})
    if (!text.empty()) object[name] = text;
  return object;
}

}  // namespace

std::string to_sarif(const RunResult& run, bool quiet) {
  report_detail::Fingerprints fingerprints;
  std::vector<std::string> known;
  Json rules = Json::array();
  Json results = Json::array();
  for (const Diagnostic* d : report_detail::shown(run, quiet)) {
    auto at = std::find(known.begin(), known.end(), d->rule);
    if (at == known.end()) {
      at = known.insert(at, d->rule);
      rules.push_back(rule_object(d->rule, d->level));
    }
    Json result{{"ruleId", d->rule},
                {"ruleIndex", at - known.begin()},
                {"level", sarif_level(d->level)},
                {"message", {{"text", report_detail::with_advice(*d)}}},
                {"locations", Json::array({location(d->place)})},
                {"partialFingerprints", {{"jounceFinding/v1", fingerprints.of(*d)}}}};
    if (!d->limit_place.file.empty()) {
      Json related = location(d->limit_place);
      related["id"] = 1;
      related["message"]["text"] = "the limit";
      result["relatedLocations"] = Json::array({std::move(related)});
    }
    if (Json more = properties(*d); !more.empty()) result["properties"] = std::move(more);
    results.push_back(std::move(result));
  }
  const Json driver{
      {"name", "jounce"}, {"semanticVersion", JOUNCE_VERSION}, {"rules", std::move(rules)}};
  const Json one{
      {"tool", {{"driver", driver}}},
      {"invocations", Json::array({{{"executionSuccessful", run.count(Level::error) == 0},
                                    {"exitCode", run.status()}}})},
      {"originalUriBaseIds",
       {{"%SRCROOT%", {{"description", {{"text", "the root of the repository"}}}}}}},
      {"columnKind", "unicodeCodePoints"},
      {"results", std::move(results)}};
  return Json{{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
              {"version", "2.1.0"},
              {"runs", Json::array({one})}}
             .dump(1) +
         "\n";
}

}  // namespace jounce
