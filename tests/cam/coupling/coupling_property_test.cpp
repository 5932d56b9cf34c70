// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/cam/coupling/coupling_cycle.hpp"
#include "jounce/cam/design/design.hpp"

#include "support/fig_6_14.hpp"
#include "support/random.hpp"

// No setpoint jumps, for every motion of the slave before it is coupled, every start mode and every
// motion of the master. Exceptions are the modes that are documented to jump; they jump by the
// amount that the check reports.

namespace jounce::coupling_property_test {
namespace {

using test::Random;

/// x = x0 + w t + A sin(q t): it accelerates, and where A q > w it reverses.
struct Master {
  double x0, w, A, q;
  [[nodiscard]] Sample at(double t) const {
    return {t,
            {x0 + w * t + A * std::sin(q * t), w + A * q * std::cos(q * t),
             -A * q * q * std::sin(q * t), -A * q * q * q * std::cos(q * t)}};
  }
  [[nodiscard]] Jet most() const { return {0, std::abs(w) + A * q, A * q * q, A * q * q * q}; }
};

Cam closed() {
  return design(test::fig_6_14()).cam;
}

Cam indexing() {
  CamSpec spec;
  spec.start = {-30, 5, 0, 0};
  spec.segments = {{Law::quintic, {100, 50, 0.2, 0}, ""}, {Law::quintic, {330, 95, 0, 0}, ""}};
  return with(design(spec).cam, Extrapolation::wrap);
}

/// The most that velocity, acceleration and jerk of a slave on its cam can be.
Jet most(const Coupling& coupling, const Master& master) {
  const CouplingSpec& spec = coupling.spec();
  const Ranges f = extrema(coupling.cam());
  const double k = spec.master_scaling;
  const auto d = [&](std::size_t n) {
    return spec.slave_scaling * std::abs(f[n].peak().value) * std::pow(k, static_cast<double>(n));
  };
  const Jet x = master.most();
  return {0, d(1) * x[1], d(2) * x[1] * x[1] + d(1) * x[2],
          d(3) * x[1] * x[1] * x[1] + 3 * d(2) * x[1] * x[2] + d(1) * x[3]};
}

/// Motion of the slave before the coupling, a function of time.
enum class Before { standing, moving, on_a_cam, ramping_in, ramping_over_master, let_go };
constexpr Before befores[] = {Before::standing,
                              Before::moving,
                              Before::on_a_cam,
                              Before::ramping_in,
                              Before::ramping_over_master,
                              Before::let_go};

struct Case {
  Before before;
  CouplingSpec spec;
  bool indexed;
  Master master;

  [[nodiscard]] Coupling coupling() const {
    return Coupling(indexed ? indexing() : closed(), spec);
  }
  [[nodiscard]] std::string text() const {
    std::ostringstream out;
    out.precision(17);
    out << "before " << static_cast<int>(before) << ", " << name(spec.start) << ", master "
        << (spec.master_absolute ? "absolute" : "relative") << ", slave "
        << (spec.slave_absolute ? "absolute" : "relative") << ", indexed " << indexed << ", k "
        << spec.master_scaling << " s " << spec.slave_scaling << " o " << spec.slave_offset
        << " period " << spec.slave_period.value_or(0) << ", master " << master.x0 << " "
        << master.w << " " << master.A << " " << master.q;
    return out.str();
  }
};

CouplingSpec random_spec(Random& random, StartMode start) {
  CouplingSpec spec{.master_scaling = random.log_uniform(0.5, 2),
                    .master_offset = random.uniform(-100, 100),
                    .slave_scaling = random.log_uniform(0.3, 3),
                    .slave_offset = random.uniform(-20, 20),
                    .master_absolute = random.below(2) == 0,
                    .slave_absolute = random.below(2) == 0,
                    .start = start,
                    .velocity_diff = random.log_uniform(20, 300),
                    .acceleration = random.log_uniform(200, 3000),
                    .deceleration = random.log_uniform(200, 3000),
                    .jerk = random.log_uniform(2000, 100000),
                    .distance = random.log_uniform(20, 200)};
  return spec;
}

MotionState state(const Jet& y) {
  return {y[0], y[1], y[2]};
}

/// The slave before at time 0.
MotionState before_of(const Case& c, Random& random) {
  const Sample zero = c.master.at(0);
  if (c.before == Before::standing) return {random.uniform(-300, 300), 0, 0};
  if (c.before == Before::moving)
    return {random.uniform(-300, 300), random.uniform(-200, 200), random.uniform(-500, 500)};
  const StartMode start = c.before == Before::ramping_in            ? StartMode::ramp_in
                          : c.before == Before::ramping_over_master ? StartMode::ramp_in_distance
                                                                    : StartMode::absolute;
  CouplingSpec spec = random_spec(random, start);
  spec.slave_absolute = true;
  const Coupling old(closed(), spec);
  const Sample then = c.master.at(-0.05);
  const Engagement in = engage(old, {random.uniform(-300, 300), 0, 0}, then.master, then.t);
  if (!in) return {};  // a master that stood in that very instant
  if (c.before != Before::let_go) return state(point(old, in.engaged, zero.master, 0));
  const Jet y = point(old, in.engaged, then.master, then.t);
  return state(point(cam_out(y, then.t, 5000), 0));
}

/// Runs the coupling and compares every step with what the limits allow.
void expect_no_jump(const Case& c, const MotionState& slave) {
  const Coupling coupling = c.coupling();
  const CouplingSpec& spec = c.spec;
  const Engagement in = engage(coupling, slave, c.master.at(0).master, 0);
  const Report report = check(coupling, slave, c.master.at(0).master);
  if (!in) {
    EXPECT_TRUE(in.status == CouplingStatus::would_reverse && !spec.slave_period) << c.text();
    EXPECT_FALSE(report.ok());
    return;
  }
  const bool may_jump = spec.start == StartMode::absolute || spec.start == StartMode::relative;
  const bool jumps = in.jump != MotionState{};
  EXPECT_TRUE(may_jump || !jumps) << c.text();
  const Jet first = point(coupling, in.engaged, c.master.at(0).master, 0);
  const std::array<double, 3> stepped{first[0] - slave.position, first[1] - slave.velocity,
                                      first[2] - slave.acceleration};
  const std::array<double, 3> announced{in.jump.position, in.jump.velocity, in.jump.acceleration};
  // A fast rotary slave may need many turns to stop: what it goes is what rounding is measured by.
  const double far = std::abs(in.engaged.placement.slave_offset);
  for (std::size_t k = 0; k < 3; ++k)
    ASSERT_NEAR(stepped[k], announced[k], 1e-9 * (1 + std::abs(first[k])) + 1e-14 * far)
        << k << c.text();
  for (const Finding& f : report.findings)
    EXPECT_TRUE(may_jump || !f.broken || f.rule != "coupling/start") << c.text();

  const Jet cam = most(coupling, c.master);
  const bool over_time = !may_jump && spec.start != StartMode::ramp_in_distance;
  const MotionState d = in.engaged.correction.profile().start();
  const double v_most =
      std::max({*spec.velocity_diff,
                std::abs(d.velocity) + d.acceleration * d.acceleration / (2 * *spec.jerk)});
  const double a_most =
      std::max({*spec.acceleration, *spec.deceleration, std::abs(d.acceleration)});
  const double dt = 1e-3;
  Engaged engaged = in.engaged;
  Jet last = first;
  for (int n = 1; n <= 1500; ++n) {
    const Stepped now = step(coupling, engaged, c.master.at(n * dt));
    ASSERT_EQ(now.status, CouplingStatus::ok) << c.text();
    const Jet& y = now.slave;
    // The step of each derivative is the next one's integral: no jump hides in between.
    const double slack = 1e-9 * (1 + std::abs(y[0])) + 1e-14 * far;
    if (!may_jump || spec.start == StartMode::relative || coupling.period_jump() == 0) {
      if (over_time || may_jump) {
        const double a_all = cam[2] + (over_time ? a_most : 0);
        const double j_all = cam[3] + (over_time ? *spec.jerk : 0);
        ASSERT_NEAR(y[0] - last[0], dt * (y[1] + last[1]) / 2, dt * dt * a_all / 2 + slack)
            << "at " << n << ": " << c.text();
        ASSERT_LE(std::abs(y[1] - last[1]), dt * a_all + 1e-9 * (1 + std::abs(y[1])))
            << "at " << n << ": " << c.text();
        ASSERT_LE(std::abs(y[2] - last[2]), dt * j_all + 1e-9 * (1 + std::abs(y[2])))
            << "at " << n << ": " << c.text();
      }
      if (over_time) {
        const Jet correction = engaged.correction.jet(n * dt, c.master.at(n * dt).master);
        ASSERT_LE(std::abs(correction[1]), v_most * (1 + 1e-9)) << c.text();
      }
    }
    engaged = now.engaged;
    last = y;
  }
}

Case random_case(Random& random, Before before, StartMode start, bool indexed) {
  Case c{before,
         random_spec(random, start),
         indexed,
         {random.uniform(-500, 500), random.uniform(-200, 400), random.uniform(0, 50),
          random.uniform(0.5, 5)}};
  // A stroke per period that an absolute slave keeps: whole turns of a rotary one.
  if (indexed || random.below(3) == 0)
    c.spec.slave_period = indexed ? 90 * c.spec.slave_scaling : random.log_uniform(50, 500);
  return c;
}

TEST(CouplingProperty, NothingJumpsButWhatIsDocumentedTo) {
  Random random(20260719);
  for (int round = 0; round < 20; ++round)
    for (const Before before : befores)
      for (std::size_t mode = 0; mode < start_mode_count; ++mode)
        for (const bool indexed : {false, true}) {
          const Case c = random_case(random, before, static_cast<StartMode>(mode), indexed);
          expect_no_jump(c, before_of(c, random));
          if (HasFatalFailure()) return;
        }
}

/// Over the master: the same, by refining. The steps of a smooth motion shrink with the cycle.
TEST(CouplingProperty, ARampOverMasterIsSmoothToTheSecondDerivative) {
  Random random(5);
  for (int round = 0; round < 200; ++round) {
    const Case c = random_case(random, Before::moving, StartMode::ramp_in_distance, round % 2 == 0);
    const Coupling coupling = c.coupling();
    const Engagement in = engage(coupling, before_of(c, random), c.master.at(0).master, 0);
    ASSERT_TRUE(in) << c.text();
    const double dt = 1e-6;
    for (int n = 0; n < 400; ++n) {
      const double t = random.uniform(0, 1.5);
      const Jet a = point(coupling, in.engaged, c.master.at(t).master, t);
      const Jet b = point(coupling, in.engaged, c.master.at(t + dt).master, t + dt);
      const double scale = std::abs(a[3]) + std::abs(b[3]) + most(coupling, c.master)[3];
      ASSERT_LE(std::abs(b[2] - a[2]), 2 * dt * scale + 1e-7 * (1 + std::abs(a[2])))
          << t << ": " << c.text();
      ASSERT_NEAR(b[1] - a[1], dt * (a[2] + b[2]) / 2,
                  dt * dt * scale + 1e-8 * (1 + std::abs(a[1])))
          << t << ": " << c.text();
    }
  }
}

}  // namespace
}  // namespace jounce::coupling_property_test
