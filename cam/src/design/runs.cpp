// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/design/runs.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/curve/roots.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "cam/src/design/parts.hpp"

namespace jounce {

namespace {

using profiles_detail::one_rounding;

using Kind = CamRun::Kind;

Kind kind_of(double travel, double rounding) {
  if (std::abs(travel) <= rounding) return Kind::dwell;
  return travel > 0 ? Kind::rise : Kind::fall;
}

}  // namespace

namespace cam_detail {

std::vector<Part> parts(const Segment& f) {
  const double rounding = motion_rounding * magnitude(f);
  std::vector<double> cuts;
  if (rounding > 0) roots(derivative(f), one_rounding * magnitude(f) / f.length, cuts);
  std::vector<double> kept{0};
  const auto moves = [&](double a, double b) {
    return std::abs(value(f, b) - value(f, a)) > rounding;
  };
  for (const double s : cuts)
    if (moves(kept.back(), s)) kept.push_back(s);
  if (kept.size() > 1 && !moves(kept.back(), 1)) kept.pop_back();
  kept.push_back(1);
  std::vector<Part> result;
  for (std::size_t i = 0; i + 1 < kept.size(); ++i)
    result.push_back(
        {kept[i], kept[i + 1], kind_of(value(f, kept[i + 1]) - value(f, kept[i]), rounding)});
  return result;
}

double master_at(const Cam& cam, std::size_t segment, double s) {
  const double end = cam.breaks()[segment + 1];
  return s == 1 ? end : std::min(end, cam.breaks()[segment] + s * cam.segments()[segment].length);
}

double greatest_magnitude(const Cam& cam) {
  double greatest = 0;
  for (const Segment& f : cam.segments()) greatest = std::max(greatest, magnitude(f));
  return greatest;
}

bool jumps(const CamRun& before, const CamRun& after, double magnitude) {
  return std::abs(after.slave_from - before.slave_to) > joint_rounding * magnitude;
}

}  // namespace cam_detail

std::vector<CamRun> runs(const Cam& cam) {
  std::vector<CamRun> found;
  const double scale = cam_detail::greatest_magnitude(cam);
  for (std::size_t i = 0; i < cam.segments().size(); ++i) {
    const Segment& f = cam.segments()[i];
    for (const cam_detail::Part& part : cam_detail::parts(f)) {
      const CamRun run{part.kind, cam_detail::master_at(cam, i, part.s0),
                       cam_detail::master_at(cam, i, part.s1), value(f, part.s0),
                       value(f, part.s1)};
      if (found.empty() || found.back().kind != run.kind ||
          cam_detail::jumps(found.back(), run, scale)) {
        found.push_back(run);
      } else {
        found.back().to = run.to;
        found.back().slave_to = run.slave_to;
      }
    }
  }
  return found;
}

std::vector<MasterSpan> positions_for(const Cam& cam, double slave) {
  std::vector<MasterSpan> spans;
  for (const double x : crossings(cam, 0, slave)) spans.push_back({x, x});
  const double rounding = cam_detail::joint_rounding * cam_detail::greatest_magnitude(cam);
  for (const CamRun& run : runs(cam)) {
    if (run.kind != Kind::dwell || std::abs(run.slave_from - slave) > rounding) continue;
    std::erase_if(spans,
                  [&](const MasterSpan& at) { return at.from >= run.from && at.to <= run.to; });
    spans.push_back({run.from, run.to});
  }
  std::sort(spans.begin(), spans.end(),
            [](const MasterSpan& a, const MasterSpan& b) { return a.from < b.from; });
  if (cam.outside() == Extrapolation::wrap && spans.size() > 1 &&
      spans.front().from == cam.start() && spans.back().from == cam.end())
    spans.pop_back();
  return spans;
}

}  // namespace jounce
