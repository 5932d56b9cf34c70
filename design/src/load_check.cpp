// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/load_check.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "jounce/design/make.hpp"
#include "jounce/optimize/detail/pointwise.hpp"

namespace jounce {
namespace {

Finding against(double limit, const char* rule, const char* quantity) {
  Finding f;
  f.rule = rule;
  f.quantity = quantity;
  f.unit = "N m";
  f.limit = limit;
  return f;
}

void judge(Finding& f, double value) {
  f.value = value;
  f.limit = std::copysign(f.limit, value);
  f.margin = 1 - value / f.limit;
  f.broken = f.margin < -1e-12;
}

/// The finding for the greatest |torque| of the curve, with its segment.
Finding peak_finding(const LoadTorque& torque, const Cam& cam, const std::vector<Segment>& shape,
                     double limit) {
  Finding f = against(limit, "limit/load_torque", "torque");
  const auto figure = optimizer::pointwise(TorqueOf{torque}, cam.start());
  double peak = 0;
  for (const optimizer::Wave& wave : figure->waves(shape, cam.start())) {
    const Extremum here = optimizer::range_of(wave, 1e-8 * limit).peak();
    if (f.segment && std::abs(here.value) <= std::abs(peak)) continue;
    peak = here.value;
    f.where = here.where;
    f.segment = wave.piece;
  }
  judge(f, peak);
  return f;
}

}  // namespace

Report check_load(const Spec& spec, const Cam& cam) {
  const auto& load = spec.optimize.shape.load;
  if (!load || !spec.master) return {};
  const LoadLimits& limits = load->limits;
  const double speed = spec.master->velocity / seconds_per_unit(spec);
  const LoadTorque torque = load_torque_of(*load, speed, spec.units.position);
  const std::vector<Segment> shape(cam.segments().begin(), cam.segments().end());
  Report report;
  if (limits.torque) report.findings.push_back(peak_finding(torque, cam, shape, *limits.torque));
  if (limits.rms_torque) {
    Finding f = against(*limits.rms_torque, "limit/load_rms_torque", "rms torque");
    const auto figure = optimizer::pointwise(RmsTorqueOf{torque}, cam.start());
    f.where = cam.start();
    judge(f, optimizer::value_of(*figure, shape, cam.start()));
    report.findings.push_back(std::move(f));
  }
  return report;
}

}  // namespace jounce
