// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "jounce/profiles/detail/tolerances.hpp"

#include "axis/src/motion/motion_rules.hpp"
#include "axis/src/state/axis_impl.hpp"

// The motion along a path (path_player.hpp), and the changes to the next path without a stop: at the
// end of the present path, or of its pass, or where its master passes a position.

namespace jounce {

Cause MotionAxis::Impl::advance_path(Setpoint& next) {
  PathTime time = motion_.path().time(now_.tick);
  if (motion_.path().reaches_boundary(now_.tick)) {
    if (motion_.path().finishes()) {
      motion_.join();
      next = {now_.master, 0, {motion_.path()->end()->position, 0, 0, 0}};
      return Cause::none;
    }
    if (const Cause no = swap_at_boundary(); no != Cause::none) return no;
    time = motion_.path().time(now_.tick);
  }
  motion_.path().govern(request());
  if (motion_.ending() != Ending::fault && motion_.path().starves(request()))
    return Cause::underrun;
  if (motion_.path()->growing() && time.s > motion_.path()->known()) return Cause::jump;
  const bool swaps = slot_.armed().waiting() && slot_.armed().when() == StartAt::master_position;
  if (swaps && motion_.path()->synchronized())
    if (const auto s = motion_.path().passing(slot_.armed().position(), time.s, moment())) {
      swap_at_master(*s);
      time = motion_.path().time(now_.tick);
    }
  next = motion_.path().play(time, moment());
  if (motion_.path()->progress() == Progress::done) motion_.join();
  if (motion_.path()->progress() != Progress::broken) return Cause::none;
  return is_fault(motion_.path()->cause()) ? motion_.path()->cause() : Cause::jump;
}

// ---- the next path -----------------------------------------------------------------------------

/// A swap at the end of the path, or another coupling at the end of a pass of the cam.
MotionAxis::Impl::Rejection MotionAxis::Impl::start_at_end() {
  if (auto no = against_start_at_end(slot_.armed(), motion_, present(), config_)) return no;
  slot_.accept(StartAt::end_of_table, 0, 0, now_.tick);
  if (motion_.is_live()) return std::nullopt;
  motion_.path().follow(request());
  motion_.path().swap_at_end(now_.tick);
  return std::nullopt;
}

/// The present path has reached its boundary. If the boundary was not available at the command,
/// checks now that both paths meet; otherwise the present path ends.
Cause MotionAxis::Impl::swap_at_boundary() {
  const double boundary = motion_.path().boundary();
  if (!motion_.path().open_ended()) {
    swap(boundary, *motion_.path()->end());
    return Cause::none;
  }
  const double last = motion_.path()->at({boundary, dt(), inputs_.master}).slave[0];
  if (motion_.path()->progress() == Progress::broken) return motion_.path()->cause();
  if (const auto no = slot_.armed()->admit(config_, {last + motion_.above().finished(), 0, 0}))
    drop(*no);
  else
    swap(boundary, {last, 0, 0});
  return Cause::none;
}

/// Swaps where the master passes the start position, if both paths meet.
void MotionAxis::Impl::swap_at_master(double s) {
  const MotionState end = state_of(motion_.path()->at({s, dt(), inputs_.master}));
  if (const auto no = slot_.armed()->admit(
          config_, {end.position + motion_.above().finished(), end.velocity, end.acceleration}))
    return drop(*no);
  swap(s, end);
}

/// The armed movement continues from the end of the present path, or of its pass, at path time
/// `boundary`.
void MotionAxis::Impl::swap(double boundary, MotionState end) {
  motion_.path().forget_boundary();
  if (inputs_.peers == Peers::missing) return drop({.cause = Cause::group_stopped});
  // The boundary may precede the end of the rate change.
  const double rate = motion_.path().time(now_.tick).rate;
  const double most = slot_.armed()->growing() ? 1 : highest_rate(slot_.armed()->peaks(), config_);
  if (rate > most * (1 + profiles_detail::rounded_input))
    return drop({.cause = Cause::rate_changing, .value = rate, .limit = most});
  end.position += motion_.above().finished();
  if (const Cause no = slot_.armed()->begin(end, moment()); no != Cause::none)
    return drop({.cause = no, .value = end.position});
  if (is_group()) outputs_.leave(*motion_.path().path(), boundary);
  hand_back(motion_.path().path());
  const ArmedMotion begun = slot_.take();
  motion_.path().take_over(*begun.movement(), now_.tick, boundary);
  ++now_.finished;
  motion_.above().clear_finished();
  motion_.path().follow(request());
  enter(begun);
}

}  // namespace jounce
