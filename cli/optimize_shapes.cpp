// Segments of a cam that are free in shape.
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/io/make.hpp"
#include "jounce/io/report_text.hpp"
#include "jounce/io/spec_edit.hpp"
#include "jounce/io/units.hpp"
#include "jounce/study/against.hpp"

#include "interrupt.hpp"
#include "optimizing.hpp"
#include "progress.hpp"
#include "verb.hpp"

namespace jounce::cli {
namespace {

using Json = nlohmann::ordered_json;

/// What the numbers of an outcome are called.
class Words {
 public:
  explicit Words(const Spec& spec)
      : spec_(spec), cam_(std::get<CamSpec>(spec.subject)), labels_{spec.units, true, {}} {
    for (std::size_t i = 0; i < cam_.segments.size(); ++i) labels_.segments.push_back(segment(i));
  }

  [[nodiscard]] const Labels& labels() const { return labels_; }
  [[nodiscard]] const std::vector<ShapeFigureSpec>& figures() const {
    return spec_.optimize.shape.figures;
  }

  /// Figures that are minimised; the others are ceilings.
  [[nodiscard]] std::size_t minimized() const {
    return figures().size() - spec_.optimize.shape.ceilings.size();
  }

  [[nodiscard]] std::string segment(std::size_t i) const {
    const std::string& name = cam_.segments[i].name;
    return std::to_string(i + 1) + (name.empty() ? "" : " " + name);
  }

  [[nodiscard]] std::string segments(const CamRunOutcome& run) const {
    std::string list;
    for (const std::size_t i : run.segments) list += (list.empty() ? "" : ", ") + segment(i);
    return list;
  }

  /// A run may go beyond the seam: its places are told as the cam has them.
  [[nodiscard]] double place(double where) const {
    const double start = cam_.start.master;
    const double end = cam_.segments.back().end.master;
    return where > end ? where - (end - start) : where;
  }

  [[nodiscard]] std::string at(double where, const CamRunOutcome& run) const {
    const double here = place(where);
    std::size_t i = run.segments.front();
    for (const std::size_t each : run.segments)
      if (here >= begin(each) && here <= cam_.segments[each].end.master) i = each;
    return fmt::format("{} {} (segment {})", rounded(here), spec_.units.x, segment(i));
  }

  [[nodiscard]] double length(const CamRunOutcome& run) const {
    double length = 0;
    for (const std::size_t i : run.segments) length += cam_.segments[i].end.master - begin(i);
    return length;
  }

 private:
  [[nodiscard]] double begin(std::size_t i) const {
    return i == 0 ? cam_.start.master : cam_.segments[i - 1].end.master;
  }

  const Spec& spec_;
  const CamSpec& cam_;
  Labels labels_;
};

/// A figure of a run in the numbers that are printed.
struct Told {
  const ShapeFigureSpec& spec;
  double given;
  double reached;
  std::optional<double> bound;
  std::optional<double> could_save;  ///< share of `reached`
};

/// A figure that is alone has the bound of its splines where no better one is known.
std::vector<Told> told(const CamRunOutcome& run, const Words& words) {
  const double length = words.length(run);
  const bool alone = words.minimized() == 1;
  std::vector<Told> all;
  for (std::size_t i = 0; i < run.figures.size() && i < words.figures().size(); ++i) {
    const ShapeFigureSpec& spec = words.figures()[i];
    const FigureResult& figure = run.figures[i];
    Told t{spec, shown(spec, figure.given, length), shown(spec, figure.reached, length), {}, {}};
    std::optional<double> bound = figure.bound;
    if (bound && *bound > 0) t.bound = shown(spec, *bound, length);  // 0 is no news
    if (i == 0 && alone && run.shape.spline_bound && run.shape.value > 0)
      bound =
          std::max(bound.value_or(0), figure.reached * *run.shape.spline_bound / run.shape.value);
    if (bound && *bound > 0 && t.reached > 0)
      t.could_save = std::max(0.0, 1 - shown(spec, *bound, length) / t.reached);
    all.push_back(t);
  }
  return all;
}

/// "limited by geo_velocity at 12 deg (segment 1 push), 212 deg (segment 2 back) and 7 more places".
std::string active_sentence(std::span<const Finding> findings, const CamRunOutcome& run,
                            const Words& words) {
  constexpr std::size_t most = 3;
  const Finding& first = findings.front();
  const bool objective = first.rule.starts_with("objective/");
  std::string text = objective ? first.quantity + " is attained" : "limited by " + first.quantity;
  if (first.quantity == "residual" || first.quantity.starts_with("rms "))
    return text;  // of all of it
  for (std::size_t i = 0; i < std::min(most, findings.size()); ++i)
    text += (i == 0 ? " at " : ", ") + words.at(findings[i].where, run);
  if (findings.size() > most) text += fmt::format(" and {} more places", findings.size() - most);
  return text;
}

/// Places that belong together told in one line; an rms has no place.
void print_active(std::FILE* out, const CamRunOutcome& run, const Words& words) {
  const auto& active = run.shape.active;
  for (auto first = active.begin(); first != active.end();) {
    const auto last =
        std::find_if(first, active.end(), [&](const Finding& f) { return f.rule != first->rule; });
    if (!first->rule.starts_with("objective/") || first->quantity.starts_with("peak"))
      fmt::print(out, "  - {}\n", active_sentence({first, last}, run, words));
    first = last;
  }
}

/// The limit that would stop it next: the least room of those that are not met already.
const Finding* next_limit(const CamRunOutcome& run) {
  const Finding* next = nullptr;
  for (const Finding& f : run.shape.limits.findings) {
    const bool met = std::any_of(run.shape.active.begin(), run.shape.active.end(),
                                 [&](const Finding& a) { return a.quantity == f.quantity; });
    if (f.broken || met || f.margin <= 1e-6) continue;
    if (next == nullptr || f.margin < next->margin) next = &f;
  }
  return next;
}

void print_run(std::FILE* out, const CamRunOutcome& run, const Words& words) {
  fmt::print(out, "  {:<24} {:>12} {:>12} {:>12} {:>10}   segments {}\n", "", "given", "reached",
             "bound", "could save", words.segments(run));
  for (const Told& t : told(run, words))
    fmt::print(out, "  {:<24} {:>12} {:>12} {:>12} {:>12}   {}\n", t.spec.name, rounded(t.given),
               rounded(t.reached), t.bound ? rounded(*t.bound) : "-",
               t.could_save ? fmt::format("{:.2f} %", 100 * *t.could_save) : "-", t.spec.unit);
  print_active(out, run, words);
  if (const Finding* next = next_limit(run))
    fmt::print(out, "  - {} stays {:.0f} % below its limit, closest at {}\n", next->quantity,
               100 * next->margin, words.at(next->where, run));
}

void print_text(std::FILE* out, const CamShapeOutcome& outcome, const Words& words) {
  fmt::print(out, "{}: {}\n", name(outcome.status), outcome.reason);
  for (const CamRunOutcome& run : outcome.runs) {
    print_run(out, run, words);
    if (!run.shape.usable())
      fmt::print(out, "least violated:\n{}",
                 full_text(run.shape.limits, {words.labels().units, true, {}}));
  }
  if (!outcome.limits.ok())
    fmt::print(out, "limits of the whole cam:\n{}", full_text(outcome.limits, words.labels()));
}

Json json_of(const Finding& finding, const Words& words) {
  return {{"rule", finding.rule},
          {"quantity", finding.quantity},
          {"where", words.place(finding.where)},
          {"value", finding.value},
          {"limit", finding.limit},
          {"margin", finding.margin}};
}

Json json_of(const CamRunOutcome& run, const Words& words) {
  Json figures = Json::array();
  for (const Told& t : told(run, words)) {
    Json figure{
        {"figure", t.spec.name}, {"unit", t.spec.unit}, {"given", t.given}, {"reached", t.reached}};
    if (t.bound) figure["bound"] = *t.bound;
    if (t.could_save) figure["could_save"] = *t.could_save;
    figures.push_back(std::move(figure));
  }
  Json active = Json::array();
  for (const Finding& finding : run.shape.active) active.push_back(json_of(finding, words));
  Json segments = Json::array();
  for (const std::size_t i : run.segments) segments.push_back(i + 1);
  Json object{{"segments", segments},
              {"status", name(run.shape.status)},
              {"reason", run.shape.reason},
              {"figures", figures},
              {"active", active},
              {"limits", Json::parse(to_json(run.shape.limits, {words.labels().units, true, {}}))},
              {"rounds", run.shape.rounds},
              {"evaluations", run.shape.evaluations}};
  if (const Finding* next = next_limit(run)) object["next"] = json_of(*next, words);
  return object;
}

Json json_of(const CamShapeOutcome& outcome, const Words& words) {
  Json runs = Json::array();
  for (const CamRunOutcome& run : outcome.runs) runs.push_back(json_of(run, words));
  return {{"status", name(outcome.status)},
          {"usable", outcome.usable()},
          {"reason", outcome.reason},
          {"runs", runs},
          {"limits", Json::parse(to_json(outcome.limits, words.labels()))}};
}

/// The outcome, with progress and Ctrl-C. `optimize` is given what to ask whether to go on.
template <class Optimize>
auto watched(const Words& words, const Optimize& optimize) {
  Progress progress("optimising");
  const Interrupt interrupt;
  return optimize([&](const CamShapeProgress& p) {
    const double parts = static_cast<double>(p.runs * p.stages);
    const double round = static_cast<double>(p.round);
    const double done = static_cast<double>(p.run * p.stages + p.stage) + round / (round + 10);
    progress.show(done / parts,
                  words.figures()[std::min(p.stage, words.figures().size() - 1)].name);
    return !interrupt.asked();
  });
}

}  // namespace

namespace {

/// The drive of --against in the units of the cam.
Against against_of(const OptimizeOptions& options, const Spec& spec) {
  const Spec file = read_spec(options.against);
  if (!file.drive)
    throw file.document.located(InputError("drive", "", "is missing: nothing to optimise against"));
  if (!spec.master)
    throw spec.document.located(
        InputError("master", "", "is missing: how fast the drive must follow"));
  Against against{.drive = file.drive->drive, .settle = file.drive->settle};
  against.velocity = spec.master->velocity / conversion(spec.time_unit, "s");
  try {
    against.drive.position_per_rev *= conversion(file.units.position, spec.units.position);
  } catch (const InputError&) {
    throw file.document.located(
        InputError("units.position", '"' + file.units.position + '"',
                   "must measure what the cam's slave does, in " + spec.units.position));
  }
  return against;
}

std::string unit_of(const DriveFigureResult& figure, const Words& words) {
  return figure.name.ends_with("torque") ? "N m" : words.labels().units.position;
}

void print_drive(std::FILE* out, const AgainstOutcome& outcome, const Words& words) {
  if (outcome.figures.empty()) return;
  fmt::print(out, "  {:<24} {:>12} {:>12} {:>12} {:>10}\n", "by integration", "given", "reached",
             "", "saved");
  for (const DriveFigureResult& f : outcome.figures)
    fmt::print(out, "  {:<24} {:>12} {:>12} {:>12} {:>12}   {}\n", f.name, rounded(f.given),
               rounded(f.reached), "",
               f.given > 0 ? fmt::format("{:.2f} %", 100 * (1 - f.reached / f.given)) : "-",
               unit_of(f, words));
  for (const auto& [whose, run] : {std::pair{"given", &outcome.given}, {"reached", &outcome.best}})
    if (!run->saturation.empty())
      fmt::print(out, "  - the torque of the {} cam meets its limit {} times\n", whose,
                 run->saturation.size());
}

Json json_of(const AgainstOutcome& outcome, const Words& words) {
  Json figures = Json::array();
  for (const DriveFigureResult& f : outcome.figures)
    figures.push_back({{"figure", f.name},
                       {"unit", unit_of(f, words)},
                       {"given", f.given},
                       {"reached", f.reached}});
  return {{"real", outcome.real},
          {"rounds", outcome.rounds},
          {"figures", figures},
          {"saturated", !outcome.best.saturation.empty()}};
}

int optimize_against_drive(const OptimizeOptions& options, const Spec& spec) {
  const CamShapeProblem problem = make_shape_problem(spec, true);
  const Against against = against_of(options, spec);
  const Words words(spec);
  const AgainstOutcome outcome = watched(words, [&](const CamShapeKeepGoing& keep_going) {
    return optimize_against(problem, against, keep_going);
  });
  std::FILE* out = told_on(options);
  if (options.json) {
    Json document = json_of(outcome.shapes, words);
    document["usable"] = outcome.usable();
    document["drive"] = json_of(outcome, words);
    fmt::print(out, "{}\n", document.dump(1));
  } else {
    print_text(out, outcome.shapes, words);
    print_drive(out, outcome, words);
  }
  if (!outcome.usable()) return finding;
  write_optimized(options, spec, with_shapes(spec, outcome.shapes.best));
  return fine;
}

}  // namespace

int optimize_shapes(const OptimizeOptions& options, const Spec& spec) {
  if (!options.against.empty()) return optimize_against_drive(options, spec);
  const CamShapeProblem problem = make_shape_problem(spec);
  const Words words(spec);
  const CamShapeOutcome outcome = watched(words, [&](const CamShapeKeepGoing& keep_going) {
    return optimize_cam_shapes(problem, keep_going);
  });
  std::FILE* out = told_on(options);
  if (options.json)
    fmt::print(out, "{}\n", json_of(outcome, words).dump(1));
  else
    print_text(out, outcome, words);
  if (!outcome.usable()) return finding;
  write_optimized(options, spec, with_shapes(spec, outcome.best));
  return fine;
}

}  // namespace jounce::cli
