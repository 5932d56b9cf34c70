// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "jounce/profiles/detail/tolerances.hpp"

#include "axis/src/state/axis_impl.hpp"

// The motion along a path (path_player.hpp), and the changes to the next path without a stop: at the
// end of the present path, or of its pass, or where its master passes a position.

namespace jounce {

Cause MotionAxis::Impl::advance_path(Setpoint& next) {
  PathTime time = path_.time(now_.tick);
  if (path_.reaches_boundary(now_.tick)) {
    if (path_.finishes()) {
      joint_ = true;
      next = {now_.master, 0, {path_->end()->position, 0, 0, 0}};
      return Cause::none;
    }
    if (const Cause no = swap_at_boundary(); no != Cause::none) return no;
    time = path_.time(now_.tick);
  }
  path_.govern(request());
  if (ending_ != Ending::fault && path_.starves(request())) return Cause::underrun;
  if (path_->growing() && time.s > path_->known()) return Cause::jump;
  const bool swaps = armed_.waiting() && armed_.when() == StartAt::master_position;
  if (swaps && path_->synchronized())
    if (const auto s = path_.passing(armed_.position(), time.s, moment())) {
      swap_at_master(*s);
      time = path_.time(now_.tick);
    }
  next = path_.play(time, moment());
  joint_ = joint_ || path_->progress() == Progress::done;
  if (path_->progress() != Progress::broken) return Cause::none;
  return is_fault(path_->cause()) ? path_->cause() : Cause::jump;
}

/// The superimposed move comes to rest with the path, and resumes with it.
bool MotionAxis::Impl::replan_path() {
  SuperimposedMove above = above_;
  if (!above.hold(requested_rate() == 0, bare_.tick) || !path_.follow(request())) return false;
  above_ = above;
  return true;
}

// ---- the next path -----------------------------------------------------------------------------

/// A swap at the end of the path, or of its present pass.
MotionAxis::Impl::Rejection MotionAxis::Impl::start_at_end() {
  if (base_ == Base::live) return start_at_pass_end();
  const auto end = expected_end();
  if (!on_path() || !(end || path_.open_ended())) return Refusal{Cause::not_on_path};
  if (end)
    if (auto no = armed_->admit(config_, *end)) return no;
  if (auto no = against_swap()) return no;
  armed_.accept(StartAt::end_of_table, 0, 0, now_.tick);
  path_.follow(request());
  path_.swap_at_end(now_.tick);
  return std::nullopt;
}

/// Another coupling, at the end of a pass of the cam that follows the live master.
MotionAxis::Impl::Rejection MotionAxis::Impl::start_at_pass_end() {
  if (!live_->passes()) return Refusal{Cause::no_movement};
  if (!armed_.is_live() || above_.running()) return Refusal{Cause::in_motion};
  armed_.accept(StartAt::end_of_table, 0, 0, now_.tick);
  return std::nullopt;
}

/// Returns the reason why the armed movement cannot take over from the present path, or none. From
/// its accepted start to the swap, the rate is limited to the range that both paths permit. The
/// present path slows down to that range within its own limits.
MotionAxis::Impl::Rejection MotionAxis::Impl::against_swap() const {
  if (above_.running() || armed_.is_live()) return Refusal{Cause::in_motion};
  if (!path_.steady(now_.tick)) return Refusal{Cause::rate_changing};
  return std::nullopt;
}

/// The present path has reached its boundary. If the boundary was not available at the command,
/// checks now that both paths meet; otherwise the present path ends.
Cause MotionAxis::Impl::swap_at_boundary() {
  const double boundary = path_.boundary();
  if (!path_.open_ended()) {
    swap(boundary, *path_->end());
    return Cause::none;
  }
  const double last = path_->at({boundary, dt(), inputs_.master}).slave[0];
  if (path_->progress() == Progress::broken) return path_->cause();
  if (const auto no = armed_->admit(config_, {last + above_.finished(), 0, 0}))
    drop(*no);
  else
    swap(boundary, {last, 0, 0});
  return Cause::none;
}

/// Swaps where the master passes the start position, if both paths meet.
void MotionAxis::Impl::swap_at_master(double s) {
  const MotionState end = state_of(path_->at({s, dt(), inputs_.master}));
  if (const auto no = armed_->admit(
          config_, {end.position + above_.finished(), end.velocity, end.acceleration}))
    return drop(*no);
  swap(s, end);
}

/// The armed movement continues from the end of the present path, or of its pass, at path time
/// `boundary`.
void MotionAxis::Impl::swap(double boundary, MotionState end) {
  path_.forget_boundary();
  if (inputs_.peers == Peers::missing) return drop({.cause = Cause::group_stopped});
  // The boundary may precede the end of the rate change.
  const double rate = path_.time(now_.tick).rate;
  const double most = armed_->growing() ? 1 : highest_rate(armed_->peaks(), config_);
  if (rate > most * (1 + profiles_detail::rounded_input))
    return drop({.cause = Cause::rate_changing, .value = rate, .limit = most});
  end.position += above_.finished();
  if (const Cause no = armed_->begin(end, moment()); no != Cause::none)
    return drop({.cause = no, .value = end.position});
  if (is_group()) outputs_.leave(*path_.path(), boundary);
  hand_back(path_.path());
  const ArmedMotion begun = std::exchange(armed_, {});
  path_.take_over(*begun.movement(), now_.tick, boundary);
  ++now_.finished;
  above_.clear_finished();
  path_.follow(request());
  enter(begun);
}

}  // namespace jounce
