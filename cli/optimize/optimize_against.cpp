// SPDX-License-Identifier: Apache-2.0
// Free shapes optimized through a drive: --against.
#include <fmt/format.h>

#include "jounce/base/units.hpp"
#include "jounce/design/make.hpp"
#include "jounce/spec/edit.hpp"
#include "jounce/study/against.hpp"

#include "cli/common/json.hpp"
#include "cli/optimize/optimizing.hpp"
#include "cli/optimize/shape_text.hpp"
#include "cli/optimize/watched.hpp"

namespace jounce::cli {
namespace {

/// The drive of --against in the units of the cam.
Against against_of(const OptimizeArguments& options, const Spec& spec) {
  const Spec file = read_spec(options.against);
  if (!file.drive)
    throw file.document.located(InputError("drive", "", "is missing: --against needs a [drive]"));
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

void print_drive(std::FILE* out, const AgainstOutcome& outcome, const ShapeWords& words) {
  if (outcome.driven_figures.empty()) return;
  fmt::print(out, "  {:<24} {:>12} {:>12} {:>12} {:>10}\n", "by integration", "given", "reached",
             "", "saved");
  for (const FigureResult& f : outcome.driven_figures)
    fmt::print(out, "  {:<24} {:>12} {:>12} {:>12} {:>12}   {}\n", f.name, rounded(f.given),
               rounded(f.reached), "",
               f.given > 0 ? fmt::format("{:.2f} %", 100 * (1 - f.reached / f.given)) : "-",
               unit_of(f, words));
  for (const auto& [whose, run] :
       {std::pair{"given", &outcome.driven_given}, {"reached", &outcome.driven_best}})
    if (!run->saturation.empty())
      fmt::print(out, "  - the torque of the {} cam reaches its limit {} times\n", whose,
                 run->saturation.size());
}

Json drive_json(const AgainstOutcome& outcome, const ShapeWords& words) {
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

int optimize_against(const OptimizeArguments& options, const Spec& spec) {
  const CamShapeProblem problem = make_shape_problem(spec, true);
  const Against against = against_of(options, spec);
  const ShapeWords words(spec);
  const AgainstOutcome outcome = watched(
      "optimizing", [&](const OptimizeProgress& p) { return words.stage(p); },
      [&](const KeepGoing& keep_going) {
        return jounce::optimize_against(problem, against, keep_going);
      });
  Json document = json_of(outcome, words);
  document["drive"] = drive_json(outcome, words);
  if (!options.json) {
    print_text(text_stream(options), outcome, words);
    print_drive(text_stream(options), outcome, words);
  }
  return finish(options, spec, std::move(document),
                outcome.usable() ? std::optional(with_shapes(spec, outcome.best)) : std::nullopt);
}

}  // namespace jounce::cli
