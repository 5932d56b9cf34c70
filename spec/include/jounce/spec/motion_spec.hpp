// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "jounce/controllers/agito/agito.hpp"
#include "jounce/controllers/googol/googol.hpp"
#include "jounce/controllers/himc/himc.hpp"
#include "jounce/controllers/pmc600/pmc600.hpp"
#include "jounce/profiles/curve/modulo.hpp"
#include "jounce/profiles/moves/fourth_order.hpp"
#include "jounce/profiles/moves/move.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/profiles/sequences/override.hpp"
#include "jounce/profiles/sequences/queue.hpp"
#include "jounce/profiles/sequences/synchronise.hpp"
#include "jounce/profiles/sequences/via.hpp"
#include "jounce/profiles/vibration/notch.hpp"
#include "jounce/profiles/vibration/shaper.hpp"
#include "jounce/pvt/compensation.hpp"

/// Specs of motions over time: one struct for each `profile`, with the parameters of its generator
/// in `profiles/`. Numbers are in the spec's units, unless a controller's own are named.
namespace jounce {

/// profile = "point_to_point": move_to, on a modulo axis if there is a period.
struct PointToPointSpec {
  MotionState from, to;
  Bounds bounds;
  std::optional<double> duration;
  std::optional<double> period;
  Direction direction = Direction::shortest;  ///< needs a period
};

/// profile = "velocity": move_velocity.
struct VelocitySpec {
  MotionState from;
  double velocity = 0;
  double acceleration = 0;  ///< at the end
  Bounds bounds;
};

struct HimcMoveSpec {
  double from = 0, to = 0;
  himc::AxisProfile axis;
};

struct HimcVelocitySpec {
  MotionState from;
  int direction = 1;
  himc::AxisProfile axis;
};

struct GoogolVelocitySpec {
  MotionState from;
  googol::MoveVelocity move;
};

struct GoogolJogSpec {
  double from = 0;
  std::vector<googol::JogVelocity> velocities;
  googol::Jog parameters;
};

struct AgitoSpec {
  double from = 0;
  agito::Target target;
  agito::Settings settings;
  std::optional<int> strokes;  ///< number of strokes of a repetitive motion
  double rpt_wait = 0;         ///< ms
};

struct AgitoSineSpec {
  double from = 0;
  double amplitude = 0;
  double frequency = 0;  ///< Hz
  int strokes = 2;
  double rpt_wait = 0;  ///< ms
};

struct AgitoJogSpec {
  MotionState from;
  agito::Settings settings;
};

struct Pmc600Spec {
  double from = 0, to = 0;
  Dynamics dynamics = {};
  pmc600::VelocityMode mode = pmc600::VelocityMode::trapezoid;
};

struct Pmc600LsVelocitySpec {
  double from = 0;
  double velocity = 0, acceleration = 0;
  double start_velocity = 20;
};

struct Pmc600InchSpec {
  double from = 0;
  double distance = 0;
  Dynamics dynamics = {};
  std::optional<double> released;
};

struct Pmc600JogSpec {
  double from = 0;
  std::vector<pmc600::JogInput> inputs;
  Dynamics dynamics = {};
  std::optional<double> max_velocity;
};

/// kind = "move": its `profile`.
using MoveSpec =
    std::variant<TrapezoidSpec, SCurveSpec, FourthOrderSpec, PointToPointSpec, VelocitySpec,
                 HimcMoveSpec, HimcVelocitySpec, googol::Trap, googol::MoveAbsolute,
                 googol::MoveAbsoluteEx, GoogolVelocitySpec, GoogolJogSpec, AgitoSpec,
                 AgitoSineSpec, AgitoJogSpec, Pmc600Spec, pmc600::LsMove, Pmc600LsVelocitySpec,
                 pmc600::PositionToVelocity, Pmc600InchSpec, Pmc600JogSpec>;

/// kind = "axes": several axes in one motion, from one state to another, or through points.
struct AxesSpec {
  Sync sync = Sync::time;
  double duration = 0;                      ///< minimum; 0: as short as possible
  std::vector<AxisMove> axes;               ///< for points, only the bounds count
  std::vector<std::vector<double>> points;  ///< through these; then without `sync`
  ViaSpec via = {};                         ///< further options of a motion through points
  bool shortest_times = false;  ///< a spline through them with the best times, not via()
};

// ---- [[then]]: operators on a motion, one after another -----------------------------------

struct MovingAverageSpec {
  double window = 0;
};

/// Retimes the motion to the [limits] of each axis.
struct RetimeSpec {};

/// A change in flight, at a time.
struct ChangeSpec {
  enum class To { target, velocity, additive, superimposed };
  To to = To::target;
  double time = 0;
  double value = 0;  ///< target, velocity or distance
  Dynamics dynamics = {};
  std::optional<double> abort = {};  ///< for superimposed: the time at which the move is aborted
};

/// A correction of one axis, computed from the positions of one or more axes. If the spec has several axes, they are
/// given by name.
struct CompensateSpec {
  CompensationSpec table;
  std::string axis = {};  ///< the corrected axis; "": the only one
  std::vector<std::string> references =
      {};                                ///< one for each grid axis; "": the corrected one itself
  std::optional<double> tolerance = {};  ///< if no segment can be exact
};

/// ShaperSpec and NotchSpec use Hz, independent of the unit of time of the spec.
using Operator = std::variant<MovingAverageSpec, ShaperSpec, NotchSpec, RetimeSpec, OverrideSpec,
                              ChangeSpec, CompensateSpec>;

}  // namespace jounce
