// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/cam_check.hpp"

#include <algorithm>
#include <iterator>

#include "jounce/cam/design/certificate.hpp"
#include "jounce/cam/design/warnings.hpp"

namespace jounce {
namespace {

/// For each segment of the cam, the number of the spec's segment. All pieces of one segment have
/// the same label.
std::vector<std::size_t> origin_of(const Cam& cam, const Labels& labels) {
  std::vector<std::size_t> origin;
  const auto all = groups(cam.segments().size(), labels);
  for (std::size_t g = 0; g < all.size(); ++g) origin.resize(all[g].last + 1, g);
  return origin;
}

void take(Report& all, Report part) {
  std::move(part.findings.begin(), part.findings.end(), std::back_inserter(all.findings));
}

/// True for a finding in a segment whose shape is free, and may reverse.
bool is_free_shape(const Input& input, const Finding& f) {
  const std::vector<FreeShape>& shapes = input.spec->optimize.shape.shapes;
  return f.segment && std::any_of(shapes.begin(), shapes.end(), [&](const FreeShape& shape) {
           return !shape.monotone &&
                  shape.segment + 1 == input.labels.number_of_segment(*f.segment);
         });
}

/// Slave positions through which a segment of the spec must pass, or which control it: its ends and
/// its points, in the order of the master.
std::vector<double> given_positions(const CamSpec& cam, std::size_t segment) {
  const CamSegment& one = cam.segments[segment];
  if (!one.control.values.empty()) return one.control.values;
  std::vector<double> given{segment == 0 ? cam.start.slave : cam.segments[segment - 1].end.slave};
  for (const CamPoint& point : one.points)
    if (point.slave) given.push_back(*point.slave);
  given.push_back(one.end.slave);
  return given;
}

/// True for an overshoot or a reversal that the points of its segment require.
bool is_given_by_points(const CamSpec& cam, std::size_t segment, const Finding& f) {
  const std::vector<CamPoint>& points = cam.segments[segment].points;
  if (points.empty() && cam.segments[segment].control.values.empty()) return false;
  const std::vector<double> given = given_positions(cam, segment);
  if (f.rule == "warning/reversal")
    return !std::is_sorted(given.begin(), given.end()) &&
           !std::is_sorted(given.rbegin(), given.rend());
  const auto [least, greatest] = std::minmax_element(given.begin(), given.end());
  double tolerance = 0;
  for (const CamPoint& point : points) tolerance = std::max(tolerance, point.tolerance);
  return f.rule == "warning/overshoot" && f.value >= *least - tolerance &&
         f.value <= *greatest + tolerance;
}

/// Removes the warnings about a shape that the points of the spec require.
void remove_given(Report& odd, const Input& input) {
  const CamSpec* const cam = std::get_if<CamSpec>(&input.spec->subject);
  if (cam == nullptr) return;
  std::erase_if(odd.findings, [&](const Finding& f) {
    const std::size_t segment = f.segment ? input.labels.number_of_segment(*f.segment) : 0;
    return segment >= 1 && segment <= cam->segments.size() &&
           is_given_by_points(*cam, segment - 1, f);
  });
}

}  // namespace

bool has_designed_rises(const Input& input) {
  return input.labels.over_master &&
         (!input.spec || !std::holds_alternative<SyncSpec>(input.spec->subject));
}

void add_cam_findings(Report& report, const Input& input, int continuity) {
  if (!input.labels.over_master) return;
  const Cam& cam = std::get<Cam>(*input.curve);
  Report odd = warnings(cam, origin_of(cam, input.labels));
  // The shape of a table from a spec is that of the spec, within its tolerance.
  if (!input.file.empty() && !input.table.provenance.spec_sha256.empty())
    std::erase_if(odd.findings,
                  [](const Finding& f) { return f.rule.family() == RuleFamily::warning; });
  for (int k = 0; k <= continuity; ++k)
    std::erase_if(odd.findings, [&](const Finding& f) {
      return f.rule == Rule(RuleFamily::joint, OverMaster::names[static_cast<std::size_t>(k)]);
    });
  const bool reported =
      std::any_of(report.findings.begin(), report.findings.end(),
                  [](const Finding& f) { return f.broken && f.rule == "knife/reversal"; });
  if (reported)  // knife/reversal has an advice of its own
    std::erase_if(odd.findings, [](const Finding& f) { return f.rule == "warning/reversal"; });
  if (input.spec) remove_given(odd, input);
  if (input.spec)
    for (Finding& f : odd.findings) {
      if (f.rule == "warning/reversal" && is_free_shape(input, f))
        f.advice = "add monotone = true to `free` of the segment, and run `jounce optimize` again";
      f.advice = with_units(f.advice, input.spec->document.nouns);
    }
  take(report, std::move(odd));
  if (has_designed_rises(input)) take(report, certificates(cam));
  sort(report);
}

Report checked(const Input& input, int continuity, const EngageState& at) {
  Report report = check_all(input, continuity, at);
  if (!input.against) add_cam_findings(report, input, continuity);
  return report;
}

}  // namespace jounce
