// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/cam_check.hpp"

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
