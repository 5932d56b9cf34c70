// SPDX-License-Identifier: Apache-2.0
// The response of a linear drive by matrix exponentials, cycle by cycle. With q(x) the response for
// the logarithms x of the numbers, its derivatives are
//
//     (1)  dq/dx_j = (q(x + h e_j) - q(x - h e_j)) / 2h,    h = 1e-4
//
// with relative errors of h^2 and of rounding / h, both below 1e-8.

#include "validate/src/identify/stepped_response.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <string>

#include "jounce/validate/drive_stepper.hpp"
#include "jounce/validate/linear_drive.hpp"

namespace jounce::validate_detail {
namespace {

constexpr double difference_of_steps = 1e-4;  // (1)
constexpr double same_cycle = 1e-6;           // share of a cycle
constexpr double rounding_of_cycle = 1e-12;   // relative, in a count of cycles
constexpr std::int64_t most_periods = 1000;   // in one step of DriveStepper

/// The number of cycles from the start of the grid; nullopt: t is between two of them.
std::optional<std::int64_t> cycle_at(const Grid& grid, double t) {
  const double cycles = (t - grid.start) / grid.period;
  const double nearest = std::round(cycles);
  const double slack = same_cycle + rounding_of_cycle * std::abs(nearest);
  if (!(std::abs(cycles - nearest) <= slack) || !(nearest >= 0 && nearest < 1e9))
    return std::nullopt;
  return static_cast<std::int64_t>(nearest);
}

bool on_cycles(const Grid& grid, std::span<const double> times) {
  return std::all_of(times.begin(), times.end(),
                     [&](double t) { return cycle_at(grid, t).has_value(); });
}

/// The jet at t; at a break, within rounding, the one after it.
Jet jet_in(const SignalView& motion, double t, double slack) {
  if (t >= motion.end() - slack) return {motion.jet(motion.end(), Side::left)[0], 0, 0, 0};
  const auto breaks = motion.breaks();
  const auto after = std::lower_bound(breaks.begin(), breaks.end(), t - slack);
  return motion.jet(*after <= t + slack ? *after : t);
}

/// True if DriveStepper accepts the drive.
bool is_linear(const Drive& drive) {
  const auto bend = nonlinearity(drive);
  return !bend || (drive.controller.cycle > 0 && *bend == "controller.encoder_counts");
}

/// A run along the motion. It stops at each cycle of a sampled controller, which reads the reference
/// there. It stops at each setpoint of a continuous one, and at the samples.
class SteppedRun {
 public:
  SteppedRun(const Commanded& command, const Grid& grid, const ResponseSpec& spec)
      : motion_(command.motion), grid_(grid), spec_(spec) {
    if (spec.start->controller.cycle > 0) return;
    const auto breaks = motion_.breaks();
    for (std::size_t i = 0; i < breaks.size(); ++i)
      stops_[*cycle_at(grid, breaks[i])] = command.setpoints->setpoint(i);
    for (const double t : spec.times) {
      const std::int64_t cycle = *cycle_at(grid, t);
      stops_.try_emplace(cycle, at(cycle));
    }
  }

  std::vector<std::vector<double>> of(const Drive& drive) {
    DriveStepper stepper(drive, grid_.period);
    const double radians = 2 * std::numbers::pi / drive.position_per_rev;
    stepper.rest(motion_.jet(motion_.start())[0]);
    std::vector<std::vector<double>> value(outputs, std::vector<double>(spec_.times.size()));
    now_ = 0;
    for (std::size_t i = 0; i < spec_.times.size(); ++i) {
      go_to(*cycle_at(grid_, spec_.times[i]), stepper);
      const DriveSample& s = stepper.now();
      value[position][i] = -s.following_error;
      value[velocity][i] = s.velocity / radians;
      value[torque][i] = s.torque;
      value[load][i] = s.load - s.reference;
    }
    return value;
  }

 private:
  [[nodiscard]] Jet at(std::int64_t cycle) const {
    const double t = grid_.start + static_cast<double>(cycle) * grid_.period;
    return jet_in(motion_, t, same_cycle * grid_.period);
  }

  void go_to(std::int64_t end, DriveStepper& stepper) {
    while (now_ < end) {
      const auto after = stops_.upper_bound(now_);
      const std::int64_t most = std::min(end, now_ + most_periods);
      const bool stops = after != stops_.end() && after->first <= most;
      const std::int64_t next = stops_.empty() ? now_ + 1 : stops ? after->first : most;
      stepper.step(stops ? after->second : at(next), static_cast<int>(next - now_));
      now_ = next;
    }
  }

  const SignalView& motion_;
  const Grid& grid_;
  const ResponseSpec& spec_;
  std::map<std::int64_t, Jet> stops_ = {};  // by cycle; empty: every cycle
  std::int64_t now_ = 0;
};

}  // namespace

std::optional<Grid> grid_of(const Commanded& command, const ResponseSpec& spec) {
  const SignalView& motion = command.motion;
  const Controller& controller = spec.start->controller;
  const bool sampled = controller.cycle > 0;
  if (!is_linear(*spec.start)) return std::nullopt;
  std::vector<double> values(spec.values.begin(), spec.values.end());
  for (double& value : values) value *= std::exp(-difference_of_steps);
  if (!is_linear(with_numbers(*spec.start, spec.keys, values))) return std::nullopt;
  if (sampled && controller.delay > static_cast<double>(most_periods) * controller.cycle)
    return std::nullopt;
  const double period = command.setpoints != nullptr ? command.setpoints->cycle() : 0;
  const Grid grid{motion.start(), sampled ? controller.cycle : period};
  if (!(grid.period > 0) || !on_cycles(grid, spec.times)) return std::nullopt;
  if (!sampled && !on_cycles(grid, motion.breaks())) return std::nullopt;
  return grid;
}

DriveResponse stepped_values(const Commanded& command, const Grid& grid, const ResponseSpec& spec) {
  DriveResponse answer;
  answer.integration.reached = spec.times.back();
  answer.value =
      SteppedRun(command, grid, spec).of(with_numbers(*spec.start, spec.keys, spec.values));
  return answer;
}

DriveResponse stepped_response(const Commanded& command, const Grid& grid,
                               const ResponseSpec& spec) {
  DriveResponse answer = stepped_values(command, grid, spec);
  SteppedRun run(command, grid, spec);
  const auto moved = [&](std::size_t j, double by) {
    std::vector<double> values(spec.values.begin(), spec.values.end());
    values[j] *= std::exp(by);
    return run.of(with_numbers(*spec.start, spec.keys, values));
  };
  const std::size_t n = spec.times.size();
  answer.by.assign(outputs, std::vector<double>(n * spec.keys.size()));
  for (std::size_t j = 0; j < spec.keys.size(); ++j) {
    const auto up = moved(j, difference_of_steps);
    const auto down = moved(j, -difference_of_steps);
    for (std::size_t k = 0; k < outputs; ++k)
      for (std::size_t i = 0; i < n; ++i)
        answer.by[k][j * n + i] = (up[k][i] - down[k][i]) / (2 * difference_of_steps);  // (1)
  }
  return answer;
}

}  // namespace jounce::validate_detail
