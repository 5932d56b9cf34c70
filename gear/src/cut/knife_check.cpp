// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/gear/rotary_knife.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

constexpr double rounding = 1e-12;

/// The finding for the knife's least velocity. A knife that stops as specified keeps this limit.
Finding reversal(const RotaryKnifeSpec& spec, const RotaryKnifeFigures& f, const Cam& cam) {
  const Ranges ranges = extrema(cam);
  const Extremum& least = ranges[1].min;
  const double peak = ranges[1].peak().value;
  Finding finding;
  finding.rule = "knife/reversal";
  finding.quantity = "geo_velocity";
  finding.where = least.where;
  const auto after = std::upper_bound(cam.breaks().begin(), cam.breaks().end() - 1, least.where);
  finding.segment = static_cast<std::size_t>(after - cam.breaks().begin()) - 1;
  finding.value = std::abs(least.value) <= rounding * peak ? 0 : least.value;
  finding.margin = finding.value / peak;
  finding.broken = finding.value < 0;
  if (finding.broken)
    finding.advice = "cut lengths above " + number(f.longest) +
                     " need a stop between the cuts: set dwell = true";
  else if (spec.dwell)
    finding.margin = 1;  // the stop is intended, so it is not listed as the closest limit
  return finding;
}

/// The finding for the contact: the blade must be in step while it is in the web.
Finding contact(const RotaryKnifeFigures& f) {
  const double touches = 2 * f.contact_angle;
  Finding finding;
  finding.rule = "knife/contact";
  finding.quantity = "sync_angle";
  finding.where = f.sync_length / 2;
  finding.value = f.sync_angle;
  finding.limit = touches;
  finding.margin = 1 - touches / f.sync_angle;
  finding.broken = finding.margin < -rounding;
  if (std::abs(finding.margin) <= rounding) finding.margin = 0;
  if (finding.broken)
    finding.advice = "the blade touches the web before it is in step: set sync_angle to at least " +
                     number(touches);
  return finding;
}

/// The finding for the slip: how much slower than the web the blade moves along it during the cut.
Finding slip(const RotaryKnifeSpec& spec, const RotaryKnifeFigures& f) {
  const double unit = spec.turn / (2 * std::numbers::pi);
  const double angle = f.contact_angle > 0 ? f.contact_angle : f.sync_angle / 2;
  Finding finding;
  finding.rule = "knife/slip";
  finding.quantity = "slip";
  finding.where = f.sync_length / 2 * std::min(1.0, 2 * angle / f.sync_angle);
  const double s = std::sin(angle / unit / 2);
  finding.value = 2 * s * s;  // 1 - cos
  finding.limit = 0.01;
  finding.margin = 1 - finding.value / finding.limit;
  finding.severity = finding.value > finding.limit ? Severity::warning : Severity::note;
  if (finding.severity == Severity::warning)
    finding.advice = "matching = \"horizontal\" leaves no slip";
  return finding;
}

}  // namespace

Report check(const RotaryKnifeSpec& spec) {
  const RotaryKnifeFigures f = figures(spec);
  Report report;
  report.findings.push_back(reversal(spec, f, rotary_knife(spec).cam));
  if (f.contact_angle > 0) report.findings.push_back(contact(f));
  if (spec.matching == KnifeMatching::surface) report.findings.push_back(slip(spec, f));
  sort(report);
  return report;
}

}  // namespace jounce
