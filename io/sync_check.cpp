#include "jounce/io/sync_check.hpp"

#include <cmath>

#include <fmt/format.h>

#include "jounce/io/cut_lengths.hpp"
#include "jounce/io/report_text.hpp"
#include "jounce/io/sync_follow.hpp"
#include "jounce/io/units.hpp"

namespace jounce {
namespace {

template <class Kind>
Report findings_of(const Kind&, const Spec&) {
  return {};
}

Report findings_of(const FollowPart&, const Spec& spec) {
  return check_follow(spec);
}

Report findings_of(const RotaryKnifeSpec& knife, const Spec& spec) {
  Report report = check(knife);
  for (Finding& f : report.findings) {
    if (f.rule == "knife/contact") f.unit = spec.units.position;
    if (f.rule == "knife/reversal" && f.broken)
      f.advice = fmt::format("cuts above {} {} need a stop between them: dwell = true",
                             rounded(figures(knife).longest), spec.units.x);
  }
  return report;
}

template <class Kind>
std::vector<SyncFigure> figures_of(const Kind&, const Spec&) {
  return {};
}

std::string runs_at(const RotaryKnifeSpec& knife, const RotaryKnifeFigures& f) {
  if (f.dwell > 0) return "the knife stops between the cuts";
  return fmt::format("rho {}; the blade runs at {} times the web in the middle", rounded(f.rho),
                     rounded(f.surface_ratio)) +
         (knife.speed_ratio == 1 ? "" : fmt::format(", {} in step", number(knife.speed_ratio)));
}

/// Of the line that the spec's master is.
void add_speeds(std::vector<SyncFigure>& all, const Spec& spec) {
  if (!spec.master) return;
  const CutLengths cuts = cut_lengths(spec);
  const double line = spec.master->velocity;
  const std::string per_time = rate_unit(spec.units.x, spec.time_unit, 1);
  const CutLimits limits{spec.slave, std::numeric_limits<double>::infinity()};
  if (const auto least = shortest_length(cuts.cams, limits, line, cuts.shortest, cuts.synchronous))
    all.push_back({"shortest cut", *least, spec.units.x,
                   fmt::format("at {} {}: the slave's {} limit", rounded(line), per_time,
                               fastest_cut(cuts.cams, *least, limits).limit)});
}

std::vector<SyncFigure> figures_of(const RotaryKnifeSpec& knife, const Spec& spec) {
  const RotaryKnifeFigures f = figures(knife);
  const std::string& m = spec.units.x;
  const std::string& u = spec.units.position;
  std::vector<SyncFigure> all{
      {"synchronous length", f.synchronous, m, "where it is a plain gear"},
      {"in step", f.sync_length, m, fmt::format("{} {} of the knife", rounded(f.sync_angle), u)},
      {"recovery", f.recovery_length, m, runs_at(knife, f)},
      {"longest cut", f.longest, m, "without a stop"}};
  if (knife.matching == KnifeMatching::horizontal) all[0].meaning = "at the same mean speeds";
  if (f.contact_angle > 0)
    all.push_back({"contact angle", f.contact_angle, u, "before the bottom the blade touches"});
  if (f.dwell > 0) all.push_back({"dwell", f.dwell, m, "while the knife stands"});
  add_speeds(all, spec);
  return all;
}

template <class Find>
auto of_sync(const Spec& spec, Find&& find) -> decltype(find(GearSpec{})) {
  const auto* sync = std::get_if<SyncSpec>(&spec.subject);
  if (sync == nullptr) return {};
  try {
    return std::visit(find, *sync);
  } catch (const InputError& error) {
    throw spec.document.located(error);
  }
}

}  // namespace

Report check_sync(const Spec& spec) {
  return of_sync(spec, [&](const auto& kind) { return findings_of(kind, spec); });
}

std::vector<SyncFigure> sync_figures(const Spec& spec) {
  return of_sync(spec, [&](const auto& kind) { return figures_of(kind, spec); });
}

bool is_sync_rule(const std::string& rule) {
  return rule.starts_with("knife/");
}

std::string sync_sentence(const Finding& f, const std::string& where) {
  if (f.rule == "knife/reversal")
    return f.broken ? fmt::format("the knife turns back at {}", where)
                    : fmt::format("the knife never turns back; it is slowest at {}", where);
  if (f.rule == "knife/slip")
    return fmt::format("the blade is {:.3g} % slower along the web than in step at {}",
                       100 * f.value, where);
  if (f.broken)
    return fmt::format("the blade is in the web for {} {}, but in step for {} alone",
                       rounded(f.limit), f.unit, rounded(f.value));
  return fmt::format("the blade is in step for {} {}, in the web for {}", rounded(f.value), f.unit,
                     rounded(f.limit));
}

}  // namespace jounce
