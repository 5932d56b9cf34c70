// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/detail/dispatcher.hpp"

#include <algorithm>
#include <utility>

#include "jounce/executor/detail/recorder.hpp"

#include "executor/src/group/group_server.hpp"
#include "executor/src/server/axis_server.hpp"

namespace jounce {
namespace {

std::vector<ReceiverOptions> receivers_of(const std::vector<ExecutorOptions>& axes) {
  std::vector<ReceiverOptions> receivers;
  for (const auto& axis : axes) receivers.push_back(axis.receiver);
  return receivers;
}

MasterServer::Options masters_of(const std::vector<ExecutorOptions>& axes,
                                 std::vector<MachineMaster> masters) {
  MasterServer::Options options{.masters = std::move(masters),
                                .keyed = axes.front().receiver.key.has_value(),
                                .notify = axes.front().notify};
  for (const auto& axis : axes) options.follows.push_back(axis.follow);
  return options;
}

}  // namespace

std::vector<MachineAxis> machine_of(const std::vector<ExecutorOptions>& axes) {
  std::vector<MachineAxis> machine;
  for (const auto& axis : axes)
    machine.push_back({axis.receiver.executor, axis.axis, axis.switches, axis.follow, axis.compare,
                       axis.group ? std::optional(axis.group->of) : std::nullopt, axis.second,
                       axis.references});
  return machine;
}

Dispatcher::Dispatcher(Transport& link, const std::vector<ExecutorOptions>& axes,
                       MachineExchange& exchange, Clock clock, std::vector<MachineMaster> masters,
                       std::optional<Claim> claim)
    : cycle_(exchange.cycle),
      a_while_(axes.front().axis.period / 4),
      clock_(std::move(clock)),
      claim_(std::move(claim)),
      pump_(link, receivers_of(axes), claim_ ? claim_->boot() : random_id(), clock_),
      masters_(masters_of(axes, std::move(masters)), pump_, exchange, clock_),
      recorder_(axes.front().recorder) {
  if (claim_)
    pump_.subscribe_claims([this](const wire::Message& said) { claim_->receive(said, clock_()); });
  const Nanos now = clock_();
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (axes[i].group)
      servers_.push_back(std::make_unique<GroupServer>(
          axes[i], pump_.receiver(i), exchange, i, worker_,
          [this](std::size_t axis) { return servers_[axis]->last().position; }));
    else
      servers_.push_back(
          std::make_unique<AxisServer>(axes[i], pump_.receiver(i), exchange, i, worker_));
    // Distributed over the period: the statuses of 64 axes do not come in one burst.
    const auto share = static_cast<std::int64_t>(i) * axes[i].status_period.count() /
                       static_cast<std::int64_t>(axes.size());
    published_.push_back(now - axes[i].status_period + Nanos(share));
  }
}

Dispatcher::~Dispatcher() = default;

const Tick& Dispatcher::last(std::size_t axis) const {
  return servers_[axis]->last();
}

void Dispatcher::turn(Nanos timeout) {
  cycle_.alive.fetch_add(1, std::memory_order_relaxed);
  pump_.run(busy() ? std::min(timeout, a_while_) : timeout);
  masters_.turn();
  for (std::size_t i = 0; i < servers_.size(); ++i) {
    servers_[i]->turn();
    for (const wire::Event& event : servers_[i]->take_events()) announce(event, i);
    if (clock_() - published_[i] >= servers_[i]->options().status_period) publish(i);
  }
  if (claim_)
    for (const wire::Message& said : claim_->poll(clock_())) pump_.send(said);
  pump_.answer();  // the answers of the axes, without the delay of another iteration
  if (recorder_ != nullptr) recorder_->turn();
}

void Dispatcher::retire() {
  for (const auto& server : servers_) server->retire();
}

void Dispatcher::close() {
  for (std::size_t i = 0; i < servers_.size(); ++i) {
    servers_[i]->close();
    publish(i);
  }
}

bool Dispatcher::moving() const {
  return std::any_of(servers_.begin(), servers_.end(), [](const auto& s) { return s->moving(); });
}

bool Dispatcher::settled() const {
  return std::all_of(servers_.begin(), servers_.end(), [](const auto& s) { return s->settled(); });
}

bool Dispatcher::owned() const {
  return std::any_of(servers_.begin(), servers_.end(), [](const auto& s) { return s->owned(); });
}

std::string Dispatcher::lost_name() const {
  return claim_ ? claim_->lost().value_or("") : "";
}

bool Dispatcher::busy() const {
  return std::any_of(servers_.begin(), servers_.end(), [](const auto& s) { return s->busy(); });
}

/// Sent at once, and again with the next status: one of the two may be lost.
void Dispatcher::announce(const wire::Event& event, std::size_t axis) {
  pump_.announce(event, axis);
  again_.emplace_back(axis, event);
}

void Dispatcher::publish(std::size_t axis) {
  pump_.publish(servers_[axis]->status(), axis);
  if (auto group = servers_[axis]->group_status()) pump_.publish_group(std::move(*group), axis);
  masters_.publish(axis);
  const auto repeat = [&](const auto& entry) {
    if (entry.first != axis) return false;
    pump_.announce(entry.second, axis);
    return true;
  };
  again_.erase(std::remove_if(again_.begin(), again_.end(), repeat), again_.end());
  published_[axis] = clock_();
}

}  // namespace jounce
