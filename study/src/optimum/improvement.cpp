// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <variant>

#include <nlohmann/json.hpp>

#include "jounce/design/detail/cam_check.hpp"
#include "jounce/design/detail/path_text.hpp"
#include "jounce/design/detail/peaks.hpp"
#include "jounce/design/make.hpp"
#include "jounce/report/report_text.hpp"
#include "jounce/study/optimum.hpp"

namespace jounce {
namespace {

/// For a path: what was gained, and the proven bound.
std::string path_gain(const Spec& given, const Spec& optimized) {
  if (!std::holds_alternative<PathSpec>(optimized.subject)) return "";
  const std::shared_ptr<const Plan> before = make_axes(given).front().plan;
  const std::shared_ptr<const Plan> after = make_axes(optimized).front().plan;
  if (!before || !after) return "";  // lines that overlap
  return path_difference(optimized, *before, *after) + path_bound(optimized, *after);
}

}  // namespace

std::string improvement_text(const Spec& given, const Spec& optimized) {
  return peaks_text(peak_changes(given, optimized)) + others_text(other_changes(given, optimized)) +
         path_gain(given, optimized);
}

std::string improvement_json(const SpecOptimum& best, const Spec& given, const Spec& optimized) {
  auto document = nlohmann::ordered_json::parse(best.json);
  document["peaks"] = nlohmann::ordered_json::parse(peaks_json(peak_changes(given, optimized)));
  document["other_figures"] =
      nlohmann::ordered_json::parse(peaks_json(other_changes(given, optimized)));
  return document.dump();
}

std::string broken_checks(const Spec& optimized) {
  std::string text;
  for (const Input& input : inputs_of(optimized, optimized.document.name))
    if (const Report report = checked(input); !report.ok()) text += full_text(report, input.labels);
  return text;
}

}  // namespace jounce
