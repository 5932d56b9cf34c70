// SPDX-License-Identifier: Apache-2.0
#include "design/src/check/load_check.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "jounce/design/make.hpp"
#include "jounce/optimize/detail/pointwise.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_sum;

constexpr double torque_precision = 1e-8;  ///< share of the limit

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
  f.broken = f.margin < -rounded_sum;
}

/// The finding for the greatest |torque| of the curve, with its segment.
Finding peak_finding(const LoadTorque& torque, const Cam& cam, double limit) {
  Finding f = against(limit, "limit/load_torque", "torque");
  const LoadPeak peak = load_peak(TorqueOf{torque}, cam, torque_precision * limit);
  f.where = peak.where;
  f.segment = peak.segment;
  judge(f, peak.value);
  return f;
}

std::vector<Segment> shape_of(const Cam& cam) {
  return {cam.segments().begin(), cam.segments().end()};
}

}  // namespace

LoadPeak load_peak(const ShapeFigure& figure, const Cam& cam, double tolerance) {
  const std::vector<Segment> shape = shape_of(cam);
  const auto pointwise = optimize_detail::pointwise(figure, cam.start());
  if (!(tolerance > 0))
    tolerance = torque_precision * optimize_detail::value_of(*pointwise, shape, cam.start());
  LoadPeak peak;
  bool any = false;
  for (const optimize_detail::Wave& wave : pointwise->waves(shape, cam.start())) {
    const Extremum here = optimize_detail::range_of(wave, tolerance).peak();
    if (std::exchange(any, true) && std::abs(here.value) <= std::abs(peak.value)) continue;
    peak = {here.value, here.where, wave.piece};
  }
  return peak;
}

double load_rms(const ShapeFigure& figure, const Cam& cam) {
  return optimize_detail::value_of(*optimize_detail::pointwise(figure, cam.start()), shape_of(cam),
                                   cam.start());
}

Report check_load(const Spec& spec, const Cam& cam) {
  const auto& load = spec.optimize.shape.load;
  if (!load || !spec.master) return {};
  const double speed = spec.master->velocity / seconds_per_unit(spec);
  const LoadTorque torque = load_torque_of(*load, speed, spec.units.position);
  Report report;
  if (load->peak_torque) report.findings.push_back(peak_finding(torque, cam, *load->peak_torque));
  if (load->rms_torque) {
    Finding f = against(*load->rms_torque, "limit/load_rms_torque", "rms torque");
    f.where = cam.start();
    judge(f, load_rms(RmsTorqueOf{torque}, cam));
    report.findings.push_back(std::move(f));
  }
  return report;
}

}  // namespace jounce
