// SPDX-License-Identifier: Apache-2.0
#include "edit/src/analysis.hpp"

#include <utility>
#include <variant>

#include "jounce/design/detail/file_check.hpp"
#include "jounce/lint/lint.hpp"
#include "jounce/plot/chart_data.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/report/detail/ci_formats.hpp"
#include "jounce/spec/spec.hpp"

#include "edit/src/cam_json.hpp"
#include "edit/src/editable.hpp"

namespace jounce::edit_detail {
namespace {

/// The tables of a spec that describes no curve: an axis, or a cam whose knots contradict
/// each other.
void take_numbers(Analysis& analysis, const std::string& path, const std::string& text) {
  try {
    const Spec spec = parse_spec(text, path);
    analysis.cam = cam_json(spec);
    analysis.edit = editable_json(spec, {});
  } catch (const InputError&) {  // the findings have the error
  }
}

bool can_optimize(const Spec& spec) {
  return spec.parameters || !spec.optimize.free.empty() || !spec.optimize.shape.shapes.empty() ||
         std::holds_alternative<PathSpec>(spec.subject);
}

/// Removes the notes on segments and joints: a cam of 100 segments has a thousand. Those on missing
/// limits stay.
void keep_what_needs_attention(FileResult& result) {
  std::erase_if(result.diagnostics, [](const Diagnostic& each) {
    return each.level == Level::note && !each.rule.starts_with("unlimited/");
  });
}

}  // namespace

Analysis analysis_of(const std::string& path, const std::string& text) {
  Analysis analysis{{path}};
  const auto examine = [&](std::vector<Input>& axes) {
    std::vector<Report> reports;
    for (const Input& axis : axes) reports.push_back(axis_report(axis));
    for (const Input& axis : axes) analysis.charts.push_back(chart_data(axis));
    analysis.check = file_check_text(file_check(axes, reports), axes);
    if (const auto& spec = axes.front().spec) {
      analysis.cam = cam_json(*spec);
      analysis.edit = editable_json(*spec, axes);
      analysis.can_optimize = can_optimize(*spec);
    }
    return reports;
  };
  analysis.result = lint_text(path, text, examine);
  keep_what_needs_attention(analysis.result);
  if (analysis.charts.empty()) take_numbers(analysis, path, text);
  return analysis;
}

void add_to(Json& object, const Analysis& analysis) {
  object["result"] = Json::parse(to_json(analysis.result));
  Json& charts = object["charts"] = Json::array();
  for (const std::string& chart : analysis.charts) charts.push_back(Json::parse(chart));
  object["check"] = analysis.check;
  object["cam"] = Json::parse(analysis.cam);
  object["edit"] = Json::parse(analysis.edit);
  object["can_optimize"] = analysis.can_optimize;
}

}  // namespace jounce::edit_detail
