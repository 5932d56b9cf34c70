// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/detail/group.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "jounce/profiles/error.hpp"

#include "stream/src/sender/reasons.hpp"

namespace jounce {
namespace {

// Causes of the end of a motion, in the axis's numbers (docs/executor/axis.md), other than the end
// of the table.
constexpr std::int32_t stopped = 80;
constexpr std::int32_t halted = 81;
constexpr std::int32_t group_stopped = 85;

std::vector<StreamPlan> checked(std::vector<StreamPlan> plans) {
  if (plans.size() < 2) throw InputError("axes", std::to_string(plans.size()), "must be 2 or more");
  std::set<std::string> names;
  for (StreamPlan& plan : plans) {
    if (!names.insert(plan.executor).second)
      throw InputError("to", plan.executor, "is named twice: name each axis once");
    if (!plan.swaps.empty())
      throw InputError("swaps", plan.executor, "work with a single axis only");
    plan.goal = StreamGoal::arm;
    plan.when = StartAt::tick;
    plan.await = true;
  }
  return plans;
}

bool at_rest(const wire::Status& status) {
  return status.state == State::standstill || status.state == State::disabled ||
         status.state == State::error_stop;
}

/// True if the motion of an axis at rest did not end by its table.
bool broken(const wire::Status& status) {
  return status.state != State::standstill || status.last_error != 0 || status.reason == stopped ||
         status.reason == halted || status.reason == group_stopped;
}

}  // namespace

Group::Group(std::vector<StreamPlan> plans, std::int64_t session, GroupOptions options)
    : options_(std::move(options)) {
  plans = checked(std::move(plans));
  axes_.reserve(plans.size());
  for (StreamPlan& plan : plans) {
    std::string name = plan.executor;
    axes_.push_back({std::move(name), Sender(std::move(plan), session, options_.sender)});
  }
}

std::vector<wire::Message> Group::poll(Nanos now) {
  go_on();
  std::vector<wire::Message> all;
  for (Axis& axis : axes_) {
    auto some = axis.sender.poll(now);
    all.insert(all.end(), std::make_move_iterator(some.begin()),
               std::make_move_iterator(some.end()));
    axis.sender.hash();
  }
  return all;
}

void Group::receive(const wire::Message& message, Nanos now) {
  for (Axis& axis : axes_) {
    if (axis.name != message.executor || axis.sender.session() != message.session) continue;
    if (const auto* status = std::get_if<wire::Status>(&message.body)) axis.status = *status;
    axis.sender.receive(message, now);
  }
}

const Group::Axis* Group::failed() const {
  const auto found = std::find_if(axes_.begin(), axes_.end(),
                                  [](const Axis& axis) { return !axis.sender.outcome().ok(); });
  return found == axes_.end() ? nullptr : &*found;
}

bool Group::all_at_goal() const {
  return std::all_of(axes_.begin(), axes_.end(),
                     [](const Axis& axis) { return axis.sender.at_goal(); });
}

void Group::go_on() {
  if (phase_ == Phase::leaving) {
    for (Axis& axis : axes_)
      if (axis.sender.at_goal()) axis.sender.release();  // it has stopped
    return;
  }
  const Axis* const bad = failed();
  // While they are armed, the others may have separate reasons.
  const bool settled = std::all_of(axes_.begin(), axes_.end(), [](const Axis& axis) {
    return axis.sender.at_goal() || axis.sender.ended();
  });
  if (bad != nullptr && (phase_ != Phase::arming || settled)) return leave(*bad);
  if (phase_ == Phase::arming && all_at_goal()) return start();
  if (phase_ == Phase::starting && all_at_goal()) {
    phase_ = Phase::playing;
    if (!options_.watch) release();
  } else if (phase_ == Phase::playing) {
    watch();
  }
}

/// One start tick for all: only axes of one machine have a common tick.
void Group::start() {
  const auto known = [](const Axis& axis) { return axis.status.has_value(); };
  if (!std::all_of(axes_.begin(), axes_.end(), known)) return;
  const wire::Status& first = *axes_.front().status;
  std::int64_t newest = first.tick;
  for (const Axis& axis : axes_) {
    newest = std::max(newest, axis.status->tick);
    if (axis.status->boot != first.boot || axis.status->cycle_ns != first.cycle_ns)
      return fail(StreamError::refused,
                  axes_.front().name + " and " + axis.name + " are axes of different machines");
  }
  tick_ = options_.tick >= 0 ? options_.tick : newest + options_.lead.count() / first.cycle_ns;
  phase_ = Phase::starting;
  for (Axis& axis : axes_) axis.sender.start_at(tick_);
}

/// During the motions: one that ends by anything but its table ends the others. The first reason is
/// that of an axis that the executor did not stop on behalf of another.
void Group::watch() {
  const auto swept = [](const Axis& axis) { return axis.status->reason == group_stopped; };
  for (Axis& axis : axes_) {
    if (axis.over || !at_rest(*axis.status) || axis.status->start != wire::StartOutcome::begun)
      continue;
    axis.over = true;
    if (broken(*axis.status) && !swept(axis)) return leave_broken(axis);
  }
  if (!std::all_of(axes_.begin(), axes_.end(), [](const Axis& axis) { return axis.over; })) return;
  const auto first = std::find_if(axes_.begin(), axes_.end(), swept);
  if (first != axes_.end()) return leave_broken(*first);
  release();
}

void Group::leave_broken(Axis& axis) {
  const wire::Status& status = *axis.status;
  const std::int32_t cause = status.last_error != 0 ? status.last_error : status.reason;
  axis.sender.fail(StreamError::stopped,
                   stream_detail::at_rest_reason("the end of its motion", cause));
  leave(axis);
}

/// One has failed: releases the others if nothing can move yet, otherwise stops them.
void Group::leave(const Axis& because) {
  const bool moves = phase_ != Phase::arming;
  phase_ = Phase::leaving;
  for (Axis& axis : axes_) {
    if (axis.sender.ended()) continue;
    axis.own = axis.sender.outcome();
    axis.own->error = StreamError::stopped;
    axis.own->reason =
        moves ? "together with " + because.name + ", which did not start or has stopped"
              : "not started, because " + because.name + " rejected its start";
    if (moves)
      axis.sender.stop(wire::StopMode::stop);
    else
      axis.sender.release();
  }
}

void Group::release() {
  phase_ = Phase::leaving;
  for (Axis& axis : axes_) axis.sender.release();
}

void Group::stop(wire::StopMode mode) {
  phase_ = Phase::leaving;
  for (Axis& axis : axes_) axis.sender.stop(mode);
}

void Group::fail(StreamError error, const std::string& reason) {
  const bool moves = phase_ == Phase::starting || phase_ == Phase::playing;
  phase_ = Phase::leaving;
  for (Axis& axis : axes_) {
    if (axis.sender.ended()) continue;
    axis.own = axis.sender.outcome();
    axis.own->error = error;
    axis.own->reason = reason;
    if (moves)
      axis.sender.stop(wire::StopMode::stop);
    else
      axis.sender.release();
  }
}

bool Group::ended() const {
  return phase_ == Phase::leaving && std::all_of(axes_.begin(), axes_.end(), [](const Axis& axis) {
           return axis.sender.done();
         });
}

std::vector<StreamOutcome> Group::outcomes() const {
  std::vector<StreamOutcome> all;
  for (const Axis& axis : axes_) {
    StreamOutcome outcome = axis.own.value_or(axis.sender.outcome());
    outcome.stopped = axis.sender.outcome().stopped;
    all.push_back(std::move(outcome));
  }
  return all;
}

std::vector<StreamOutcome> stream_group(Transport& link, std::vector<StreamPlan> plans,
                                        const GroupOptions& group, const StreamOptions& options,
                                        const Clock& clock) {
  for (const StreamPlan& plan : plans) {
    link.subscribe(wire::channel(plan.executor, wire::Lane::reply), queue_capacity);
    link.subscribe(wire::channel(plan.executor, wire::Lane::status), queue_capacity);
  }
  Group all(std::move(plans), random_id(), group);
  Rejects rejects;
  bool cancelled = false;
  for (const Nanos begin = clock();;) {
    if (!all.started() && clock() - begin > options.total)
      all.fail(StreamError::out_of_time, stream_detail::time_over_reason(options.total));
    for (const auto& message : all.poll(clock())) send_message(link, message, options.key);
    if (all.ended()) return all.outcomes();
    drain(link, options.period, options.key, rejects,
          [&](const wire::Message& message) { all.receive(message, clock()); });
    if (!cancelled && options.cancelled && options.cancelled()) {
      cancelled = true;
      all.stop(wire::StopMode::stop);
    }
  }
}

}  // namespace jounce
