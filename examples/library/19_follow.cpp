// SPDX-License-Identifier: Apache-2.0
// A slave follows its master: the Googol manual's flying shear (7-6) as a plan and as tables, its
// switch of tables (7-9) in two FIFOs, and its waiting for the master (7-7).
#include <cstdio>
#include <utility>

#include "jounce/controllers/googol/googol_follow.hpp"
#include "jounce/gear/follow_plan.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

using namespace jounce;

int main() {
  // The task of the shear: in step at both ends of its cycle, a cut every 10000 pulses.
  const FollowPlan shear{.points = {{10000, 8000}},
                         .zones = {{0, 1000, 1}, {9000, 10000, 1}},
                         .periodic = true,
                         .form = FollowForm::table};
  for (const PtPoint& p : follow_table(shear).segments)
    std::printf("to %5g, %4g type %d\n", p.x, p.position, static_cast<int>(p.type));

  // A misprint in a table: the slave would turn back.
  const FollowTable bridge{{{20000, 10000}, {40000, 30000}, {260000, 46000}}};
  const FollowTable last{{{20000, 16000, PtType::continued}, {40000, 36000}, {60000, 52000}}, 0};
  for (const Finding& f : check(FollowSpec{{bridge, last}}).findings)
    std::printf("%s %.3f at %g\n", f.rule.text().c_str(), f.value, f.where);

  // The controller plays it: one table, then the other, switched while it runs.
  googol::FollowFifos axis;
  axis.prf_follow(0);
  axis.set_follow_master(1);
  axis.set_follow_loop(0);
  for (const PtPoint& p : {PtPoint{20000, 10000}, {40000, 30000}, {60000, 46000}})
    axis.follow_data(p, 0);
  axis.follow_start(0, 0, 0);
  for (const PtPoint& p : last.segments) axis.follow_data(p, 1);
  Sample before{};
  for (int cycle = 1; cycle <= 24; ++cycle) {
    if (cycle == 2) std::printf("switch: %s\n", googol::explain(axis.follow_switch(1)));
    const Sample now{1.0 * cycle, {5000.0 * cycle, 5000, 0, 0}};
    const Jet slave = axis.step(std::exchange(before, now), now);
    if (cycle % 6 == 0)
      std::printf("master %6g slave %6g ratio %.2f\n", now.master[0], slave[0], slave[1]);
  }

  // Waiting until the master passes 50000.
  const Trajectory master = trapezoid({.to = 230000, .velocity = 50, .acceleration = 1}).curve();
  const auto t = begin_of({FollowEvent::pass, 50000}, master, 0);
  if (t) std::printf("begins at %g ms\n", *t);
}

// > to  1000, 1000 type 1
// > to  5000, 4000 type 0
// > to  9000, 7000 type 0
// > to 10000, 8000 type 1
// > follow/reversal -0.855 at 260000
// > follow/wrap_ratio 2.055 at 380000
// > switch: done
// > master  30000 slave  20000 ratio 1.00
// > master  60000 slave  46000 ratio 0.60
// > master  90000 slave  72000 ratio 1.00
// > master 120000 slave  98000 ratio 0.60
// > begins at 1025 ms
