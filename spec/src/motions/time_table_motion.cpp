// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "jounce/controllers/detail/time_table_limits.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/pvt/warnings.hpp"
#include "jounce/spec/detail/in_document.hpp"
#include "jounce/spec/time_table_spec.hpp"

namespace jounce {
namespace {

constexpr std::size_t most_segments = 1'000'000;

Trajectory made(const PtSpec& spec) {
  if (spec.googol) googol::require_pt(spec.points, spec.loops);
  if (spec.loops == 0)
    return pt<OverTime>(spec.points, spec.start_velocity, Extrapolation::advance);
  if (spec.loops > most_segments / std::max<std::size_t>(1, spec.points.size()))
    throw InputError("loops", std::to_string(spec.loops),
                     "makes more than 1e6 segments: use fewer loops, or 0 for an endless table");
  return pt_loops<OverTime>(spec.points, static_cast<int>(spec.loops), spec.start_velocity,
                            spec.outside);
}

Trajectory made(const ProfileTableSpec& spec) {
  const auto curve = [&] {
    switch (spec.quantity) {
      case ProfileTableSpec::Quantity::velocity:
        return velocity_profile(spec.table);
      case ProfileTableSpec::Quantity::acceleration:
        return acceleration_profile(spec.table);
      case ProfileTableSpec::Quantity::position:
        break;
    }
    return position_profile(spec.table, spec.rule);
  };
  return with(curve(), spec.outside);
}

std::vector<std::string> labels(const PtSpec& spec) {
  constexpr std::array types{" normal", " even", " stop", " continue"};
  std::vector<std::string> all;
  for (std::size_t pass = 1; pass <= std::max<std::size_t>(1, spec.loops); ++pass)
    for (std::size_t i = 0; i < spec.points.size(); ++i)
      all.push_back((spec.loops > 1 ? "pass " + std::to_string(pass) + ": " : "") +
                    std::to_string(i + 1) + types[static_cast<std::size_t>(spec.points[i].type)]);
  return all;
}

std::vector<std::string> labels(const ProfileTableSpec&) {
  return {};
}

void append(Report& all, Report part) {
  std::move(part.findings.begin(), part.findings.end(), std::back_inserter(all.findings));
}

/// Appends the findings of `part` that have this rule.
void append(Report& all, Report part, const char* rule) {
  std::erase_if(part.findings, [&](const Finding& f) { return f.rule != rule; });
  append(all, std::move(part));
}

Report warnings(const PtSpec& spec, const std::string& unit) {
  const auto pass = [&](Extrapolation outside) {
    return pt<OverTime>(spec.points, spec.start_velocity, outside);
  };
  const Extrapolation outside = spec.loops == 0 ? Extrapolation::advance : spec.outside;
  Report report = check_pt<OverTime>(spec.points, spec.start_velocity, outside);
  append(report, overshoot(pass(outside), unit));
  if (spec.loops > 1) {
    std::erase_if(report.findings, [](const Finding& f) { return f.rule == "pt/end_velocity"; });
    append(report, velocity_steps(made(spec)), "pt/end_velocity");
    if (spec.points.front().type != PtType::continued)
      append(report, velocity_steps(pass(Extrapolation::advance)), "pt/wrap");
  }
  return report;
}

Report warnings(const ProfileTableSpec& spec, const std::string& unit) {
  const Trajectory curve = made(spec);
  Report report = velocity_steps(curve);
  append(report, overshoot(curve, unit));
  return report;
}

}  // namespace

Trajectory motion_of(const TimeTableSpec& spec) {
  try {
    return std::visit([](const auto& each) { return made(each); }, spec);
  } catch (const InputError& error) {
    if (error.key().starts_with("point")) throw;
    throw spec_detail::renamed(error, "pt." + error.key());
  }
}

std::vector<std::string> labels_of(const TimeTableSpec& spec) {
  return std::visit([](const auto& each) { return labels(each); }, spec);
}

Report warnings_of(const TimeTableSpec& spec, const std::string& unit) {
  return std::visit([&](const auto& each) { return warnings(each, unit); }, spec);
}

}  // namespace jounce
