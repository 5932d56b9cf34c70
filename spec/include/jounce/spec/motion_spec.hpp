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
#include "jounce/profiles/sequences/synchronize.hpp"
#include "jounce/profiles/sequences/via.hpp"
#include "jounce/profiles/vibration/notch.hpp"
#include "jounce/profiles/vibration/shaper.hpp"
#include "jounce/pvt/compensation.hpp"

/// Specs of motions over time: one struct for each `profile`, with the parameters of its generator.
/// Numbers are in the spec's units, unless a comment names the unit of a controller.

namespace jounce {

/// profile = "point_to_point": a move by move_to(); with `period`, on a modulo axis.
struct PointToPointSpec {
  MotionState from = {}, to = {};
  Bounds bounds = {};
  std::optional<double> duration = {};        ///< required duration; omitted: the shortest
  std::optional<double> period = {};          ///< period of a modulo axis
  Direction direction = Direction::shortest;  ///< for a modulo axis only
};

/// profile = "velocity": a change of velocity by move_velocity().
struct VelocitySpec {
  MotionState from = {};
  double velocity = 0;      ///< velocity at the end
  double acceleration = 0;  ///< acceleration at the end
  Bounds bounds = {};
};

/// profile = "himc": a move of HIWIN HIMC.
struct HimcMoveSpec {
  double from = 0, to = 0;  ///< start and target
  himc::AxisProfile axis = {};
};

/// profile = "himc_velocity": a velocity command of HIWIN HIMC.
struct HimcVelocitySpec {
  MotionState from = {};
  int direction = 1;  ///< 1 or -1
  himc::AxisProfile axis = {};
};

/// profile = "googol_move_velocity": a velocity command of Googol.
struct GoogolVelocitySpec {
  MotionState from = {};
  googol::MoveVelocity move = {};
};

/// profile = "googol_jog": a jog of Googol.
struct GoogolJogSpec {
  double from = 0;
  std::vector<googol::JogVelocity> velocities = {};  ///< the commanded velocities, in order
  googol::Jog parameters = {};
};

/// profile = "agito": a move of Agito, single or repetitive (PTP).
struct AgitoSpec {
  double from = 0;
  agito::Target target = {};
  agito::Settings settings = {};
  std::optional<int> strokes =
      {};               ///< number of strokes of a repetitive motion; omitted: a single move
  double rpt_wait = 0;  ///< ms, rest between two strokes (RptWait)
};

/// profile = "agito_quasi_sine": a repetitive move of Agito that resembles a sine.
struct AgitoSineSpec {
  double from = 0;       ///< position at the start
  double amplitude = 0;  ///< half of the stroke
  double frequency = 0;  ///< Hz
  int strokes = 2;       ///< number of strokes
  double rpt_wait = 0;   ///< ms, rest between two strokes (RptWait)
};

/// profile = "agito_jog": a jog of Agito.
struct AgitoJogSpec {
  MotionState from = {};
  agito::Settings settings = {};
};

/// profile = "pmc600": a move of the PMC600.
struct Pmc600Spec {
  double from = 0, to = 0;  ///< start and target
  Dynamics dynamics = {};
  pmc600::VelocityMode mode = pmc600::VelocityMode::trapezoid;
};

/// profile = "pmc600_ls_velocity": LS_MoveVel of the PMC600.
struct Pmc600LsVelocitySpec {
  double from = 0;
  double velocity = 0, acceleration = 0;
  double start_velocity = 20;  ///< velocity to which the setpoint steps at the start
};

/// profile = "pmc600_inch": SMC_Inch of the PMC600, one step by `distance`.
struct Pmc600InchSpec {
  double from = 0;
  double distance = 0;  ///< signed
  Dynamics dynamics = {};
  /// Time at which the button is released; omitted: the button is held until the end.
  std::optional<double> released = {};
};

/// profile = "pmc600_jog": MC_Jog of the PMC600.
struct Pmc600JogSpec {
  double from = 0;
  std::vector<pmc600::JogInput> inputs = {};  ///< the inputs, in order
  Dynamics dynamics = {};
  std::optional<double> max_velocity = {};  ///< limit of the velocity; omitted: none
};

/// A spec of kind "move"; the alternative depends on `profile`.
using MoveSpec =
    std::variant<TrapezoidSpec, SCurveSpec, FourthOrderSpec, PointToPointSpec, VelocitySpec,
                 HimcMoveSpec, HimcVelocitySpec, googol::Trap, googol::MoveAbsolute,
                 googol::MoveAbsoluteEx, GoogolVelocitySpec, GoogolJogSpec, AgitoSpec,
                 AgitoSineSpec, AgitoJogSpec, Pmc600Spec, pmc600::LsMove, Pmc600LsVelocitySpec,
                 pmc600::PositionToVelocity, Pmc600InchSpec, Pmc600JogSpec>;

/// A spec of kind "axes": several axes in one motion, from one state to another, or through points.
struct AxesSpec {
  Sync sync = Sync::time;
  double duration = 0;  ///< least duration; 0: as short as possible
  std::vector<AxisMove> axes =
      {};  ///< bounds and goals of the axes; for a motion through points, only
           ///< the bounds are used
  /// Positions of all axes at each point; `sync` is then not used.
  std::vector<std::vector<double>> points = {};
  ViaSpec via = {};  ///< further options of a motion through points
  /// True: a spline through the points with the best times, instead of via().
  bool shortest_times = false;
};

// ---- [[then]]: operators on a motion, one after another -----------------------------------

/// The moving average of a motion over `window`, in the spec's unit of time.
struct MovingAverageSpec {
  double window = 0;  ///< window T of moving_average()
};

/// Retimes the motion with retimed(), to the [limits] of each axis.
struct RetimeSpec {};

/// A change in flight at a given time, or when the motion first passes a given position.
struct ChangeSpec {
  enum class To { target, velocity, additive, superimposed };
  To to = To::target;      ///< kind of the change
  double time = 0;         ///< time at which it takes effect
  double value = 0;        ///< target position, velocity, or distance
  Dynamics dynamics = {};  ///< dynamics of the new command
  /// Position at which it takes effect, instead of `time`; nullopt: at the time.
  std::optional<double> past = {};
  /// For superimposed: time at which the superimposed move is aborted.
  std::optional<double> abort = {};
};

/// A correction of one axis that depends on the positions of one or more axes. If the spec has
/// several axes, the members name them.
struct CompensateSpec {
  CompensationSpec table = {};  ///< grid and values of the correction
  std::string axis = {};        ///< the corrected axis; "": the only axis
  /// One name for each axis of the grid; "": the corrected axis itself.
  std::vector<std::string> references = {};
  std::optional<double> tolerance = {};  ///< tolerance of a fit, if the result does not fit exact
                                         ///< segments
};

/// An operator of [[then]]. Frequencies in ShaperSpec and NotchSpec are in Hz, for every unit of
/// time of the spec.
using Operator = std::variant<MovingAverageSpec, ShaperSpec, NotchSpec, RetimeSpec, OverrideSpec,
                              ChangeSpec, CompensateSpec>;

}  // namespace jounce
