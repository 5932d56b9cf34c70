// SPDX-License-Identifier: Apache-2.0
// Gears as controllers have them: exact counts, a clutch, GearIn, GearInPos, several masters.
#include <array>
#include <cstdio>

#include "jounce/controllers/gears.hpp"
#include "jounce/gear/feasibility.hpp"
#include "jounce/gear/gear_course.hpp"
#include "jounce/gear/gear_in.hpp"
#include "jounce/gear/gear_in_pos.hpp"
#include "jounce/gear/gear_sum.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

using namespace jounce;

int main() {
  // Two masters, each with its own ratio; rounded once, never drifts.
  const std::array gears{Gear::ratio(4000, 3072), agito::gear(-196608)};
  const GearSum sum = GearSum::of(gears);
  const std::array<std::int64_t, 2> masters{1'000'000'000'000, 7};
  std::printf("two masters: %lld counts\n", static_cast<long long>(sum.slave(masters)));

  // Googol example 7-5: engaged at 2:1 over 100000 pulses of the master.
  const Clutch clutch = googol::set_gear_ratio(Gear::ratio(0, 1), {2, 1, 100000});
  Clutch::State state;
  std::int64_t slave = 0;
  for (int cycle = 0; cycle < 1000; ++cycle) slave += clutch.advance(state, 100);
  std::printf("clutch: %lld pulses, %s\n", static_cast<long long>(slave),
              state.engaged ? "engaged" : "slipping");

  // The same as a cam, and whether the slave can follow a master of 100 pulse/ms.
  const SyncCam cam = gear_course({.master_end = 200000, .changes = {{0, 0.5, 100000}}});
  const Report report =
      feasibility(cam.cam, {.velocity = 60, .acceleration = 0.02}, {.velocity = 100});
  for (const Finding& f : report.findings)
    std::printf("%s: %s, master up to %.6g pulse/ms\n", f.rule.text().c_str(),
                f.broken ? "broken" : "kept", f.limit);

  // PMC600 example 6.2: in step from master 5000, slave 2000.
  const GearInPosSpec spec{.numerator = 1,
                           .denominator = 2,
                           .master_sync_position = 5000,
                           .slave_sync_position = 2000,
                           .master_start_distance = 4000};
  const GearInPos in_pos = gear_in_pos(spec);
  const EngageWindow window = engage_window(spec);
  std::printf("gear in pos: at master 10000 slave %g; rho %g, better a distance of %.6g to %g\n",
              sync_cam(in_pos, 0, 10000).cam.jet(10000)[0], window.rho, window.least,
              window.greatest);

  // GearIn at 0.2 s, behind a master that is under way: what is lost while ramping stays lost.
  const Trajectory master = trapezoid({.to = 1000, .velocity = 400, .acceleration = 4000}).curve();
  const Trajectory behind =
      gear_in({.numerator = 1, .denominator = 2, .acceleration = 1000}, 0, master, 0.2);
  std::printf("gear in: %g of %g\n", behind.jet(behind.end(), Side::left)[0],
              (1000 - master.at(0.2).position) / 2);
}

// > two masters: 1302083333312 counts
// > clutch: 25000 pulses, engaged
// > feasible/acceleration: broken, master up to 63.2456 pulse/ms
// > feasible/velocity: kept, master up to 120 pulse/ms
// > gear in pos: at master 10000 slave 4500; rho 1, better a distance of 6666.67 to 10000
// > gear in: 450 of 470
