// SPDX-License-Identifier: Apache-2.0
#include "design/src/input/excursions.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "jounce/profiles/curve/roots.hpp"

namespace jounce::design_detail {
namespace {

/// The positions at which the pieces of a curve begin.
std::vector<double> joints_of(const Input& input) {
  return of_motion(input, [](const auto& motion) {
    std::vector<double> all;
    if constexpr (requires { motion.segments(); })
      for (const Segment& piece : motion.segments()) all.push_back(value(piece, 0));
    else
      all = motion.columns().p;
    return all;
  });
}

/// The name of the segment at this time.
std::string segment_at(const Input& input, double time) {
  const auto breaks = std::get<Trajectory>(*input.curve).breaks();
  const auto after = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, time);
  Finding there;
  there.segment = static_cast<std::size_t>(after - breaks.begin()) - 1;
  return input.labels.segment_of(there);
}

/// True if each segment is a command with a target of its own.
bool is_queue(const Input& input) {
  return input.spec && std::holds_alternative<QueueSpec>(input.spec->subject);
}

}  // namespace

bool begins_beyond(const Trajectory& curve, const Finding& f) {
  const double start = curve.jet(curve.start())[0];
  return f.value > f.limit ? start > f.limit : start < f.limit;
}

void join_excursions(const Input& input, Report& report) {
  std::vector<const Finding*> beyond;
  for (const Finding& f : report.findings)
    if (f.broken && f.segment && (f.rule == "limit/position_max" || f.rule == "limit/position_min"))
      beyond.push_back(&f);
  if (beyond.size() < 2) return;
  std::sort(beyond.begin(), beyond.end(), [](const Finding* a, const Finding* b) {
    return std::pair(a->rule.text(), *a->segment) < std::pair(b->rule.text(), *b->segment);
  });
  const std::vector<double> joints = joints_of(input);
  const auto excess = [](const Finding& f) { return std::abs(f.value - f.limit); };
  std::set<const Finding*> dropped;
  const Finding* worst = beyond.front();
  for (std::size_t i = 1; i < beyond.size(); ++i) {
    const Finding& f = *beyond[i];
    const bool above = f.value > f.limit;
    const auto first = joints.begin() + static_cast<std::ptrdiff_t>(*beyond[i - 1]->segment) + 1;
    const bool goes_on =
        f.rule == worst->rule &&
        std::all_of(first, joints.begin() + static_cast<std::ptrdiff_t>(*f.segment) + 1,
                    [&](double joint) { return above ? joint > f.limit : joint < f.limit; });
    if (goes_on) dropped.insert(excess(f) > excess(*worst) ? worst : &f);
    if (!goes_on || excess(f) > excess(*worst)) worst = &f;
  }
  std::erase_if(report.findings, [&](const Finding& f) { return dropped.contains(&f); });
}

void name_first_passages(const Input& input, Report& report) {
  if (input.labels.over_master) return;
  for (const char* const limit : {"limit/position_max", "limit/position_min"}) {
    const auto worst = std::find_if(report.findings.begin(), report.findings.end(),
                                    [&](const Finding& f) { return f.broken && f.rule == limit; });
    if (worst == report.findings.end()) continue;
    const auto& curve = std::get<Trajectory>(*input.curve);
    if (begins_beyond(curve, *worst)) continue;
    const std::vector<double> passages = crossings(curve, 0, worst->limit);
    if (passages.empty()) continue;
    const std::string where = segment_at(input, passages.front());
    const bool elsewhere = is_queue(input) && where != input.labels.segment_of(*worst);
    constexpr std::string_view target = "move the target ";
    if (elsewhere && worst->advice.starts_with(target))
      worst->advice.replace(0, target.size(), "move its target ");
    worst->advice =
        fmt::format("the motion first passes this limit at {:.6g} {}{}; {}", passages.front(),
                    input.labels.units.x, elsewhere ? ", in segment " + where : "", worst->advice);
  }
}

}  // namespace jounce::design_detail
