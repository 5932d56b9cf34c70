// SPDX-License-Identifier: Apache-2.0
// Free shapes, optimized through a drive.
#include <fmt/format.h>

#include "jounce/base/units.hpp"
#include "jounce/design/make.hpp"
#include "jounce/spec/detail/edit.hpp"

#include "study/src/optimum/optimum.hpp"
#include "study/src/optimum/shape_text.hpp"
#include "study/src/tune/against.hpp"

namespace jounce {
namespace {

using Json = nlohmann::ordered_json;
using study_detail::ShapeWords;

/// The drive of a file in the units of the cam.
Against against_of(const Spec& file, const Spec& spec) {
  if (!file.drive)
    throw file.document.located(
        InputError("drive", "", "is missing: the cam is optimized for a [drive]"));
  if (!spec.master)
    throw spec.document.located(
        InputError("master", "", "is missing: it gives the speed of the drive"));
  Against against{
      .drive = file.drive->drive, .settle = file.drive->settle, .periodic = file.drive->periodic};
  against.velocity = spec.master->velocity / conversion(spec.time_unit, "s");
  try {
    against.drive.position_per_rev *= conversion(file.units.position, spec.units.position);
  } catch (const InputError&) {
    throw file.document.located(
        InputError("units.position", '"' + file.units.position + '"',
                   "must be convertible to the unit of the slave, " + spec.units.position));
  }
  return against;
}

std::string unit_of(const FigureResult& figure, const ShapeWords& words) {
  return figure.name.ends_with("torque") ? "N m" : words.labels().units.position;
}

std::string driven_text(const AgainstOutcome& outcome, const ShapeWords& words) {
  if (outcome.driven_figures.empty()) return "";
  std::string text = fmt::format("  {:<24} {:>12} {:>12} {:>12} {:>10}\n", "by integration",
                                 "given", "reached", "", "saved");
  for (const FigureResult& f : outcome.driven_figures)
    text += fmt::format(
        "  {:<24} {:>12} {:>12} {:>12} {:>12}   {}\n", f.name, rounded(f.given), rounded(f.reached),
        "", f.given > 0 ? fmt::format("{:.2f} %", 100 * (1 - f.reached / f.given)) : "-",
        unit_of(f, words));
  for (const auto& [whose, run] :
       {std::pair{"given", &outcome.driven_given}, {"reached", &outcome.driven_best}})
    if (!run->saturation.empty())
      text += fmt::format("  - the torque of the {} cam reaches its limit {} times\n", whose,
                          run->saturation.size());
  return text;
}

Json driven_json(const AgainstOutcome& outcome, const ShapeWords& words) {
  Json figures = Json::array();
  for (const FigureResult& f : outcome.driven_figures)
    figures.push_back({{"figure", f.name},
                       {"unit", unit_of(f, words)},
                       {"given", f.given},
                       {"reached", f.reached}});
  return {{"real", outcome.real},
          {"rounds", outcome.rounds},
          {"figures", figures},
          {"saturated", !outcome.driven_best.saturation.empty()}};
}

}  // namespace

SpecOptimum optimum_against(const Spec& spec, const Spec& drive,
                            const OptimumProgress& keep_going) {
  const CamShapeProblem problem = make_shape_problem(spec, true);
  const ShapeWords words(spec);
  const AgainstOutcome outcome =
      optimize_against(problem, against_of(drive, spec),
                       study_detail::reported_to(
                           keep_going, [&](const OptimizeProgress& p) { return words.stage(p); }));
  Json document = json_of(outcome, words);
  document["drive"] = driven_json(outcome, words);
  return {.text = text_of(outcome, words) + driven_text(outcome, words),
          .json = document.dump(),
          .spec = outcome.usable() ? std::optional(with_shapes(spec, outcome.best)) : std::nullopt};
}

}  // namespace jounce
