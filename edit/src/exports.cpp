// SPDX-License-Identifier: Apache-2.0
#include "edit/src/exports.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "jounce/design/convert.hpp"
#include "jounce/design/files/file_difference.hpp"
#include "jounce/design/input.hpp"
#include "jounce/design/over_time.hpp"
#include "jounce/plot/chart_data.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/proof/report_page.hpp"

namespace jounce::edit_detail {
namespace {

std::vector<Input> inputs_of_text(const std::string& path, const std::string& text) {
  return inputs_of(parse_spec(text, path), path);
}

Input axis_of_text(const std::string& path, const std::string& text, std::size_t axis) {
  std::vector<Input> axes = inputs_of_text(path, text);
  if (axis >= axes.size())
    throw InputError("axis", std::to_string(axis),
                     axes.size() == 1 ? "must be 0: the spec has one axis"
                                      : fmt::format("must be 0 to {}", axes.size() - 1));
  return std::move(axes[axis]);
}

std::string ending_of(const TableForm& form) {
  const std::string otherwise = form.name == "points" ? ".csv" : ".txt";
  if (form.format != nullptr) return *form.format->extension ? form.format->extension : otherwise;
  for (const OwnForm& own : own_forms())
    if (form.name == own.name) return own.ending;
  return otherwise;
}

}  // namespace

Exported exported_table(const std::string& path, const std::string& text,
                        const ExportRequest& request) {
  const std::string& form = request.form;
  const std::vector<std::string> forms = form_names();
  if (std::find(forms.begin(), forms.end(), form) == forms.end())
    throw InputError("form", form, fmt::format("must be one of {}", fmt::join(forms, ", ")));
  if (!request.over.empty() && request.over != "master" && request.over != "time")
    throw InputError("over", request.over, "must be master or time");
  const Input input = over(request.over, axis_of_text(path, text, request.axis));
  const TableForm to = table_form(form, "");
  const auto rule = form == "points" ? std::optional(Interpolation::linear) : std::nullopt;
  Conversion wanted{.rule = rule_for(to, rule, "", input.table.table), .format = to.format};
  if (request.target.any())
    wanted.target =
        target_of(request.target, input.table.table.axis(), *wanted.rule, input.labels.units);
  const Converted made = converted(input, wanted);
  if (to.format == nullptr) require_units(made.file);
  return {form_text(to, made.file), ending_of(to),
          conversion_text(input, made, to, all_losses(input, to, made.file.table)), made.keeps()};
}

std::string exported_report(const std::string& path, const std::string& text, std::size_t axis) {
  const Input input = axis_of_text(path, text, axis);
  return html(report_page(input, std::nullopt).page);
}

void add_difference(Json& object, const std::string& path, const std::string& before,
                    const std::string& after) {
  Json charts = Json::array();
  try {
    const FileDifference difference =
        file_difference(inputs_of_text(path, before), inputs_of_text(path, after), path, path,
                        [](const Labels& /*labels*/) { return Tolerance{}; });
    for (const auto& [old, now] : difference.axes)
      charts.push_back(Json::parse(chart_data(now, old)));
    object["difference"] = to_text(difference);
  } catch (const InputError& error) {
    object["difference"] = error.what();
    charts.clear();
  }
  object["charts"] = std::move(charts);
}

}  // namespace jounce::edit_detail
