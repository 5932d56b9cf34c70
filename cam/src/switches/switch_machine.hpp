// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "jounce/cam/switches/cam_switch.hpp"

#include "cam/src/switches/switch_path.hpp"

namespace jounce::cam_detail {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// The next event along a path: the state of the search, and its result.
struct Event {
  std::size_t path = 0;
  std::size_t part = 0;  ///< interval of the path: the first one not yet finished
  double next = never;   ///< s since the piece's start
  bool rising = true;    ///< the compensated position rises there
};

/// One boundary of a switch, repeated in each period. It counts the repetitions that the axis has
/// passed.
struct Boundary : Event {
  double position = 0;
  double period = 0;  ///< 0: a single boundary
  double hysteresis = 0;
  std::int64_t passed = 0;  ///< the highest index behind the axis; for a single boundary 0, or -1
  bool locked = false;      ///< the axis is still near `lock`, the position of its last edge
  std::int64_t lock = 0;

  [[nodiscard]] double at(std::int64_t index) const {
    return position + static_cast<double>(index) * period;
  }
  void place(double y);
  /// The next level of y, upwards or downwards, that changes the state.
  [[nodiscard]] double target(bool up) const;
  void follow(const MonotonePart& /*part*/) {}
  /// Passes the target with y; returns the change of `passed`, 1, 0 or -1.
  int pass(bool up);
};

/// Direction of the axis, with hysteresis: 1, -1, or 0 before the first motion.
struct Heading : Event {
  double hysteresis = 0;
  int sign = 0;
  double low = 0, high = 0;  ///< extremes since the sign changed

  void place(double x, double velocity);
  [[nodiscard]] double target(bool up) const;
  void follow(const MonotonePart& done);
  void turn(bool up);
};

/// The simulation behind both forms of the cam switches. It takes a motion piece by piece and
/// returns the edges in order.
///
///     machine.place(x0, v0);
///     machine.begin(motion);                          // a Segment over s, which begins at x0
///     while (const auto edge = machine.next()) ...    // edge->time: s since the piece's start
///
/// It simulates discrete events: each boundary, direction and running duration has a time for its
/// next event, and the earliest event occurs first. All changes at the same instant are one change.
/// begin() and next() do not allocate for a piece of degree at most 3.
class SwitchMachine {
 public:
  explicit SwitchMachine(const CamSwitchSpec& spec);

  /// Sets the position x without passing anything.
  void place(double x, double velocity);
  void begin(const Segment& motion);
  /// Instead of begin(): only time passes, without a motion.
  void wait(double length);
  std::optional<SwitchEdge> next();
  /// Shifts the origin of positions by this number of periods; the positions of the next piece are
  /// less by it.
  void shift(std::int64_t periods);
  void enable(std::uint32_t mask) { enabled_ = mask; }

  [[nodiscard]] std::uint32_t outputs() const { return outputs_; }
  /// Sets the outputs to their required state, without an edge.
  std::uint32_t settle() { return outputs_ = wanted(); }

 private:
  struct Switch {
    std::size_t track = 0;
    AxisDirection direction = AxisDirection::both;
    Boundary lower = {}, upper = {};  // time mode has a lower one only
    double pulse = 0;                 // s; 0: position mode
    double off = never;               // end of a running duration; never: none runs
  };
  struct Track {
    SwitchTrack options;
    Heading heading = {};
  };

  std::size_t path(double forwards, double backwards);
  std::size_t track(const SwitchTrack& options);
  void add(const CamSwitch& s, const CamSwitchSpec& spec);

  template <class Source>
  void seek(Source& source) const;
  [[nodiscard]] double earliest() const;
  void happen();
  void happen(Switch& s);
  [[nodiscard]] std::uint32_t wanted() const;
  void finish();

  double period_;
  double length_ = 0;  // length of the piece
  std::vector<SwitchPath> paths_;
  std::vector<Track> tracks_;
  std::vector<Switch> switches_;
  TurningPiece piece_;
  std::uint32_t enabled_ = 0;
  std::uint32_t outputs_ = 0;
  double now_ = 0;
};

}  // namespace jounce::cam_detail
