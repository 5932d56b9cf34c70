// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/sequences/queue.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "jounce/profiles/error.hpp"

#include "profiles/src/sequences/blend.hpp"
#include "profiles/src/sequences/queue_input.hpp"
#include "profiles/src/sequences/sequence.hpp"
#include "profiles/src/sequences/sign.hpp"
#include "profiles/src/solver/brake.hpp"

// A batch is planned in runs: successive position moves. Let L_k be the length of move k of a run,
// V_k the junction velocity that the mode at its end requires, and entry(L, w, cap) the highest
// entry velocity, up to cap, from which a move over L can end at w (blend.cpp, (2)). Then
//
//   (1)  backward:  W_k = entry(L_{k+1}, W_{k+1}, V_k),   W of the last = its V
//   (2)  forward:   move k ends at W_k, or as near to it as it can from its beginning
//
// The forward pass reaches at most W_k at the end of move k, and a move that may begin at W_k may
// also begin at a lower velocity. So every move can end at its W or below, and the last move can
// stop: no queue fails. One exception: if the first move of a run begins too fast for W_1,
// reachable_exit() uses (1) without cap.

namespace jounce {
namespace {

using profiles_detail::sign;

template <class T>
const T* get(const QueuedCommand& c) {
  return std::get_if<T>(&c.command);
}

bool moves_to_position(const QueuedCommand& c) {
  return get<MoveAbsolute>(c) != nullptr || get<MoveRelative>(c) != nullptr;
}

MotionState times(double factor, const MotionState& s) {
  return {factor * s.position, factor * s.velocity, factor * s.acceleration};
}

/// The direction in which the axis would move without a command: 1 or -1.
double heading(const MotionState& s) {
  return s.velocity < 0 || (s.velocity == 0 && s.acceleration < 0) ? -1 : 1;
}

/// One position move of a run.
struct Leg {
  double target = 0;   ///< u
  double length = 0;   ///< u, signed: from the target of the previous leg
  double planned = 0;  ///< V_k of (1), >= 0
  double exit = 0;     ///< W_k of (1)
};

class Planner {
 public:
  explicit Planner(const QueueSpec& spec)
      : commands_(spec.commands), start_(spec.start), records_(commands_.size()), path_(start_) {}

  void plan(std::size_t first, std::size_t last);
  void abort(std::size_t first, std::size_t next, double time);
  QueuedMotion finish() &&;

 private:
  struct Place {
    std::size_t begin = 0, end = 0;  ///< indices of breaks of the path
  };

  void plan_run(std::size_t first, std::size_t last);
  void travel(const std::vector<Leg>& run, std::size_t k, std::size_t first);
  void halt(std::size_t command);
  std::vector<Leg> legs(std::size_t first, std::size_t last) const;
  double junction_velocity(std::size_t command, double direction) const;
  double highest_exit(const std::vector<Leg>& legs, std::size_t k, std::size_t first,
                      double cap) const;
  void change_velocity(std::size_t command, double direction, double velocity);
  template <class Add>
  void record(std::size_t command, const Add& add);

  const std::vector<QueuedCommand>& commands_;
  MotionState start_;
  std::vector<CommandRecord> records_;
  std::vector<Place> places_ = std::vector<Place>(records_.size());
  profiles_detail::Sequence path_;
};

template <class Add>
void Planner::record(std::size_t command, const Add& add) {
  places_[command].begin = path_.size();
  const double begin = path_.state().position;
  try {
    add();
  } catch (const InputError& e) {
    throw InputError("commands[" + std::to_string(command + 1) + "]", "",
                     "cannot be planned from position " + number(begin) + ": " + e.rule());
  }
  places_[command].end = path_.size();
  records_[command].target = path_.state().position;
  records_[command].reached = path_.state().velocity;
}

void Planner::plan(std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last;) {
    const QueuedCommand& c = commands_[i];
    if (moves_to_position(c)) {
      std::size_t end = i;
      while (end < last && moves_to_position(commands_[end])) ++end;
      plan_run(i, end);
      i = end;
      continue;
    }
    if (const auto* dwell = get<Dwell>(c))
      record(i, [&] { path_.hold(dwell->time); });
    else if (const auto* move = get<MoveVelocity>(c))
      change_velocity(i, move->direction, c.dynamics.velocity);
    else
      record(i, [&] { halt(i); });
    ++i;
  }
}

void Planner::halt(std::size_t command) {
  path_.add(profiles_detail::halt(path_.state(), commands_[command].dynamics), 1);
}

void Planner::change_velocity(std::size_t command, double direction, double velocity) {
  const Dynamics& dynamics = commands_[command].dynamics;
  record(command, [&] {
    if (profiles_detail::stops_to_turn(dynamics) &&
        profiles_detail::runs_backwards(times(direction, path_.state()), dynamics))
      halt(command);
    path_.add(profiles_detail::ramp(times(direction, path_.state()), velocity,
                                    profiles_detail::forward(dynamics)),
              direction);
  });
}

double Planner::junction_velocity(std::size_t command, double direction) const {
  if (command + 1 == commands_.size()) return 0;
  const QueuedCommand& next = commands_[command + 1];
  if (get<Dwell>(next) != nullptr) return 0;
  if (const auto* move = get<MoveVelocity>(next); move != nullptr && move->direction != direction)
    return 0;
  const double v = commands_[command].dynamics.velocity;
  const double w = get<Halt>(next) != nullptr ? 0 : next.dynamics.velocity;
  switch (next.mode) {
    case BufferMode::blending_low:
      return std::min(v, w);
    case BufferMode::blending_previous:
      return v;
    case BufferMode::blending_next:
      return w;
    case BufferMode::blending_high:
      return std::max(v, w);
    default:
      return 0;
  }
}

std::vector<Leg> Planner::legs(std::size_t first, std::size_t last) const {
  std::vector<Leg> all(last - first);
  double x = path_.state().position;
  for (std::size_t i = first; i < last; ++i) {
    Leg& leg = all[i - first];
    const auto* relative = get<MoveRelative>(commands_[i]);
    leg.target =
        relative != nullptr ? x + relative->distance : get<MoveAbsolute>(commands_[i])->position;
    leg.length = leg.target - x;
    x = leg.target;
  }
  for (std::size_t k = 0; k < all.size(); ++k) {
    const double direction = sign(all[k].length);
    const bool goes_on = k + 1 == all.size() || direction == sign(all[k + 1].length);
    all[k].planned = goes_on && direction != 0 ? junction_velocity(first + k, direction) : 0;
  }
  for (std::size_t k = all.size(); k-- > 0;)
    all[k].exit = highest_exit(all, k, first, all[k].planned);
  return all;
}

/// The greatest velocity, up to `cap`, with which the legs after leg k can begin: (1).
double Planner::highest_exit(const std::vector<Leg>& legs, std::size_t k, std::size_t first,
                             double cap) const {
  if (legs[k].planned == 0) return 0;
  if (k + 1 == legs.size()) return cap;
  const Leg& next = legs[k + 1];
  return profiles_detail::highest_entry(
      std::abs(next.length), next.exit, cap,
      profiles_detail::forward(commands_[first + k + 1].dynamics));
}

void Planner::plan_run(std::size_t first, std::size_t last) {
  const std::vector<Leg> run = legs(first, last);
  for (std::size_t k = 0; k < run.size(); ++k) {  // (2)
    const double direction = run[k].length == 0 ? heading(path_.state()) : sign(run[k].length);
    record(first + k, [&] { travel(run, k, first); });
    records_[first + k].planned = direction * run[k].planned;
  }
}

/// Plans leg k from the present state of the axis. After a stop to reverse, which may be beyond the
/// target, the axis covers the remaining distance.
void Planner::travel(const std::vector<Leg>& run, std::size_t k, std::size_t first) {
  const Dynamics& dynamics = commands_[first + k].dynamics;
  const double way = run[k].target - path_.state().position;
  const double direction = way == 0 ? heading(path_.state()) : sign(way);
  const double wanted = direction * run[k].length < 0 ? 0 : run[k].exit;
  const MotionState from = times(direction, path_.state());
  const double target = direction * run[k].target;
  const double fastest =
      std::max({wanted, from.velocity,
                profiles_detail::natural_velocity(from, profiles_detail::forward(dynamics))});
  const double cap = k == 0 ? highest_exit(run, k, first, fastest) : wanted;
  const profiles_detail::Exit exit =
      profiles_detail::reachable_exit(from, target, wanted, cap, dynamics);
  if (exit.turns && profiles_detail::stops_to_turn(dynamics)) {
    halt(first + k);
    return travel(run, k, first);
  }
  for (const Profile& p : profiles_detail::between(from, target, exit, dynamics))
    path_.add(p, direction);
}

void Planner::abort(std::size_t first, std::size_t next, double time) {
  if (time > path_.end() && path_.state().acceleration != 0)
    throw InputError("start.acceleration", path_.state().acceleration,
                     "must be 0 where the first command waits: the axis cannot keep it");
  const std::size_t whole = path_.end_at(time);
  for (std::size_t i = first; i < next; ++i) {
    if (places_[i].end <= whole) continue;
    if (commands_[i].dynamics.jerk == 0) path_.let_go();
    places_[i].begin = std::min(places_[i].begin, path_.size());
    places_[i].end = path_.size();
    records_[i].reached = path_.state().velocity;
    records_[i].state = CommandState::aborted;
  }
}

QueuedMotion Planner::finish() && {
  if (path_.size() == 0)
    throw InputError("commands", "",
                     "must move or dwell: there is no motion. A halt or stop before the first "
                     "motion ends the queue: issue it later");
  const MotionState end = path_.state();
  const bool rests = start_.velocity == 0 && start_.acceleration == 0 && end.velocity == 0;
  Trajectory trajectory(std::move(path_).segments(), 0,
                        rests ? Extrapolation::hold : Extrapolation::refuse);
  for (std::size_t i = 0; i < records_.size(); ++i) {
    records_[i].begin = trajectory.breaks()[places_[i].begin];
    records_[i].end = trajectory.breaks()[places_[i].end];
  }
  return {std::move(trajectory), std::move(records_), end};
}

}  // namespace

QueuedMotion queue(const QueueSpec& spec) {
  profiles_detail::require_valid(spec);
  Planner planner(spec);
  std::size_t first = 0;
  if (const auto& issued = spec.commands.front().issued) planner.abort(0, 0, *issued);
  while (first < spec.commands.size()) {
    std::size_t next = first + 1;
    while (next < spec.commands.size() && spec.commands[next].mode != BufferMode::aborting) ++next;
    planner.plan(first, next);
    if (next < spec.commands.size()) planner.abort(first, next, *spec.commands[next].issued);
    first = next;
  }
  return std::move(planner).finish();
}

}  // namespace jounce
