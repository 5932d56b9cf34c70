// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/flying_shear.hpp"

#include <algorithm>
#include <utility>

#include "jounce/profiles/error.hpp"

#include "gear/src/ratio/rest_to_rest.hpp"

namespace jounce {
namespace {

/// The cam under construction, interval by interval.
struct ShearBuild {
  std::vector<Segment> segments = {};
  std::vector<std::string> names = {};

  [[nodiscard]] double slave() const { return segments.empty() ? 0 : value(segments.back(), 1); }
  void add(const Segment& segment, const char* name) {
    segments.push_back(segment);
    names.emplace_back(name);
  }
};

/// Appends a ramp of the slope k f or k (1 - f): equation (2) of shear_plan.cpp, integrated from
/// the slave's present position.
void add_ramp(ShearBuild& build, const FlyingShear& shear, double from, double length, bool up,
              double k) {
  for (Segment& speed : gear_detail::placed(shear.ramp, {}, from, length, shear.cut_length)) {
    speed = up ? scaled(speed, k) : scaled(speed, -k, k);
    build.add(*integral(speed, build.slave()), up ? "accelerate" : "decelerate");
  }
}

/// Appends the sync interval. It uses the slope itself, not the difference of two positions, so k
/// is exact to the last digit.
void add_sync(ShearBuild& build, double length, double k) {
  Segment sync;
  sync.length = length;
  sync.degree = 1;
  sync.c[0] = build.slave();
  sync.c[1] = k * length;
  build.add(sync, "sync");
}

}  // namespace

SyncCam flying_shear(const FlyingShear& shear) {
  const ShearPlan plan = shear_plan(shear);
  const double begin = plan.accelerate;
  const double end = begin + plan.sync;
  ShearBuild build;
  add_ramp(build, shear, 0, plan.accelerate, true, plan.ratio);
  add_sync(build, plan.sync, plan.ratio);
  add_ramp(build, shear, end, plan.decelerate, false, plan.ratio);
  for (const Segment& piece :
       gear_detail::moved(shear.return_law, shear.return_form, end + plan.decelerate, plan.back,
                          shear.cut_length, build.slave(), 0))
    build.add(piece, "return");
  if (plan.wait > 0) build.add(line(plan.wait, 0, 0), "wait");
  return {Cam(std::move(build.segments), 0, Extrapolation::wrap),
          std::move(build.names),
          {{begin, end, "sync"}}};
}

std::optional<SyncCam> fastest_shear(FlyingShear shear, double cut_length) {
  if (!shear.sync_time && !shear.sync_length)
    throw InputError("sync_time", "", "is missing: a map of cut lengths needs it, or sync_length");
  shear.cut_length = cut_length;
  const double fastest = greatest_line_speed(shear).value;
  if (!(fastest > 0)) return std::nullopt;
  shear.line_speed = std::min(shear.line_speed, fastest);
  return flying_shear(shear);
}

}  // namespace jounce
