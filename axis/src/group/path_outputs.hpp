// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "jounce/axis/detail/path_clock.hpp"
#include "jounce/axis/movement.hpp"
#include "jounce/cam/switches/cam_switches.hpp"

namespace jounce {

/// The outputs that the path of a group switches (H words of a program), with the instants between
/// two ticks. An output keeps its state until the path switches it again, or until off().
///
///     outputs.step();                                  // once a tick
///     outputs.pass(path, clock.at(tick), dt);          // if the path was played in this tick
///     outputs.add_to(tick.switches);
///
/// At a constant rate, the instant of an edge is exact, except for rounding. While the rate changes,
/// it follows from the cubic through path time and rate at both ticks.
///
/// The functions do not allocate, lock or throw.
class PathOutputs {
 public:
  /// Begins a tick: no edges.
  void step() noexcept { edges_.count = edges_.lost = 0; }
  /// The path was played up to the path time `now`. `dt`: time since the previous step, s.
  void pass(const Movement& path, const PathTime& now, double dt) noexcept;
  /// The path continues as this one, whose path time is lower by `shift`.
  void continue_as(const Movement& path, double shift) noexcept;
  /// Switches all outputs off, at the previous tick.
  void off() noexcept;
  /// Adds the outputs and edges to those of this tick.
  void add_to(SwitchStep& step) const noexcept;

 private:
  void set(const PathSwitch& what, double time) noexcept;

  SwitchStep edges_;  // `outputs`: present outputs
  std::uint64_t path_ = 0;
  PathTime before_{};  // in the previous tick of the path
};

}  // namespace jounce
