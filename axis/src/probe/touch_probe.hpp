// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/inputs.hpp"
#include "jounce/axis/probe_step.hpp"
#include "jounce/command/cause.hpp"
#include "jounce/command/commands.hpp"

#include "axis/src/probe/position_history.hpp"

namespace jounce {

/// The touch probes of an axis (MC_TouchProbe, MC_AbortTrigger), computed tick by tick.
///
///     TouchProbes probes;
///     if (auto no = probes.start({.input = 1, .count = 256}, feedback, config)) refuse(*no);
///     probes.step(inputs, places, dt, config);                        // once a tick
///     for (const Capture& c : probes.now().captures()) log(c.position());
///
/// **Instant.** A drive reports an edge in a later cycle, at most 8 cycles after it, with the time
/// since the edge. A capture contains the positions at the instant of the edge, not those of the
/// cycle: on the motion through both neighboring cycles, or as latched by the drive. Without a time
/// stamp, the edge counts as at the instant of the cycle. Edges before the start of a touch probe
/// do not count.
///
/// The home switch (input 5) and the index (input 6) are latched by the drive without a time stamp.
///
/// step() does not allocate, lock or throw.
class TouchProbes {
 public:
  /// Greatest age of an edge, in cycles.
  static constexpr int latest = 8;

  /// Positions in the last cycles, and the offset of the axis's coordinate from that of the drive.
  struct Places {
    const PositionHistory& commanded;  ///< u
    const PositionHistory& actual;     ///< u
    const PositionHistory& master;     ///< m
    double offset = 0;                 ///< u
  };

  /// Starts a touch probe, in place of the previous one of the same input. Returns the reason for a
  /// rejection; nullopt: accepted.
  std::optional<Refusal> start(const command::TouchProbe& what, const Feedback& feedback,
                               const AxisConfig& config) noexcept;
  /// Ends the touch probe of an input. Returns no_touch_probe if none waits.
  std::optional<Refusal> abort(int input) noexcept;
  /// Computes one tick. `dt`: time since the previous tick, s.
  void step(const Feedback& feedback, const Places& places, double dt,
            const AxisConfig& config) noexcept;

  /// The captures of the last tick.
  [[nodiscard]] const ProbeStep& now() const noexcept { return now_; }

 private:
  struct Probe {
    command::TouchProbe what = {};
    double since = 0;  // s since its start
    int made = 0;      // captures
    bool waits = false;
  };
  void see(int input, bool rising, double age, double latched, const Places& places,
           const AxisConfig& config) noexcept;

  std::array<Probe, probe_inputs> probes_{};
  bool home_on_ = false;
  ProbeStep now_;
};

}  // namespace jounce
