// SPDX-License-Identifier: Apache-2.0
#include "jounce/machine/watch.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <utility>
#include <variant>

#include "jounce/base/detail/csv.hpp"
#include "jounce/base/detail/listed.hpp"
#include "jounce/machine/detail/outcome_text.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/sender/operate.hpp"

namespace jounce::dashboard {
namespace {

constexpr Nanos trace_period = std::chrono::milliseconds(100);
constexpr int queue_capacity = 256;  // two statuses each of the most axes of a machine, and more

}  // namespace

void take(std::vector<Watched>& axes, const std::string& name, const wire::Status& status,
          Nanos now) {
  const auto place = std::lower_bound(axes.begin(), axes.end(), name,
                                      [](const Watched& a, const auto& n) { return a.name < n; });
  Watched& axis = place != axes.end() && place->name == name
                      ? *place
                      : *axes.insert(place, Watched{.name = name});
  axis.status = status;
  axis.received = now;
  if (!axis.trace.empty() && now - axis.traced_at < trace_period) return;
  axis.traced_at = now;
  axis.trace.push_back(status.slave_position);
  if (axis.trace.size() > Watched::traced) axis.trace.pop_front();
}

void take(std::vector<Watched>& axes, const std::string& name, const wire::MasterStatus& master) {
  const auto axis =
      std::find_if(axes.begin(), axes.end(), [&](const Watched& a) { return a.name == name; });
  if (axis == axes.end() || !axis->status) return;
  // An executor that was started again may have other masters.
  std::erase_if(axis->masters, [&](const auto& m) { return m.boot != master.boot; });
  auto& all = axis->masters;
  const auto place = std::lower_bound(all.begin(), all.end(), master.master,
                                      [](const auto& m, const auto& n) { return m.master < n; });
  if (place != all.end() && place->master == master.master)
    *place = master;
  else
    all.insert(place, master);
  if (all.size() > Watched::most_masters)
    all.erase(std::min_element(all.begin(), all.end(),
                               [](const auto& a, const auto& b) { return a.tick < b.tick; }));
}

void take(std::vector<Watched>& axes, const std::string& name, const wire::GroupStatus& group) {
  const auto axis =
      std::find_if(axes.begin(), axes.end(), [&](const Watched& a) { return a.name == name; });
  if (axis != axes.end() && axis->status) axis->group = group;
}

bool take(std::vector<Watched>& axes, const std::string& name, const wire::Event& event) {
  const auto axis =
      std::find_if(axes.begin(), axes.end(), [&](const Watched& a) { return a.name == name; });
  if (axis == axes.end() || !axis->status) return false;
  auto& events = axis->events;
  if (!events.empty() && events.back().boot != event.boot) events.clear();
  if (!events.empty()) {
    if (event.count <= events.back().count) return false;
    axis->lost_events += event.count - events.back().count - 1;
  }
  events.push_back(event);
  if (events.size() > Watched::most_events) events.pop_front();
  return true;
}

Watch::Watch(Transport& link, WatchOptions options) : link_(link), options_(std::move(options)) {
  std::set<std::string> names(options_.names.begin(), options_.names.end());
  options_.names.assign(names.begin(), names.end());
  if (names.empty()) names.insert("*");
  for (const std::string& name : names)
    for (const auto lane :
         {wire::Lane::status, wire::Lane::masters, wire::Lane::event, wire::Lane::group})
      link_.subscribe(wire::channel(name, lane), queue_capacity);
  for (const std::string& name : options_.names) axes_.push_back({.name = name});
}

void Watch::run(
    Nanos time, const std::function<void(const std::string& axis, const wire::Status&)>& on_status,
    const std::function<void(const std::string& axis, const wire::MasterStatus&)>& on_master,
    const std::function<void(const std::string& axis, const wire::Event&)>& on_event,
    const std::function<void(const std::string& axis, const wire::GroupStatus&)>& on_group) {
  const Nanos end = steady_now() + time;
  for (Nanos left = time; left > Nanos{}; left = end - steady_now()) {
    const auto message = next_message(link_, left, rejects_, options_.key);
    if (!message || !is_wanted(message->executor)) continue;
    const std::string& axis = message->executor;
    if (const auto* status = std::get_if<wire::Status>(&message->body)) {
      take(axes_, axis, *status, steady_now());
      if (on_status) on_status(axis, *status);
    } else if (const auto* master = std::get_if<wire::MasterStatus>(&message->body)) {
      take(axes_, axis, *master);
      if (on_master) on_master(axis, *master);
    } else if (const auto* event = std::get_if<wire::Event>(&message->body)) {
      if (take(axes_, axis, *event) && on_event) on_event(axis, *event);
    } else if (const auto* group = std::get_if<wire::GroupStatus>(&message->body)) {
      take(axes_, axis, *group);
      if (on_group) on_group(axis, *group);
    }
  }
}

std::string Watch::silent(Nanos patience) const {
  const Nanos now = steady_now();
  Nanos last = begun_;
  for (const Watched& axis : axes_) {
    const Nanos received = std::max(begun_, axis.received);
    if (!options_.names.empty() && now - received > patience) return axis.name;
    last = std::max(last, received);
  }
  return now - last > patience ? any_executor : "";
}

std::string Watch::missing() const {
  for (const Watched& axis : axes_)
    if (!options_.names.empty() && !axis.status) return axis.name;
  return has_received() ? "" : any_executor;
}

const Watched* Watch::outside(State state) const {
  const Watched* found = nullptr;
  for (const Watched& axis : axes_) {
    if (!axis.status || axis.status->state == state) continue;
    if (axis.status->state == State::error_stop) return &axis;
    if (found == nullptr) found = &axis;
  }
  return found;
}

bool Watch::has_received() const {
  return std::any_of(axes_.begin(), axes_.end(),
                     [](const Watched& axis) { return axis.status.has_value(); });
}

std::string Watch::unit_of(const std::string& name) const {
  for (const Watched& axis : axes_)
    if (axis.name == name && axis.status) return axis.status->units.position;
  return "";
}

bool Watch::is_wanted(const std::string& name) const {
  const auto& names = options_.names;
  return names.empty() || std::binary_search(names.begin(), names.end(), name);
}

std::string senders_hint(KeyedLink& link) {
  Watch watch(link.transport(), {.key = link.key()});
  watch.run(std::chrono::seconds(1));
  std::vector<std::string> names;
  for (const Watched& axis : watch.axes()) names.push_back(axis.name);
  return names.empty() ? unheard_hint
                       : "messages arrive from " + listed(names) + ": check the name";
}

std::string error_text(const CallOutcome& outcome, const std::string& executor, KeyedLink& link) {
  return jounce::error_text(outcome, executor,
                            outcome.error == StreamError::no_answer ? senders_hint(link) : "");
}

void throw_missing(KeyedLink& link, const std::string& executor) {
  throw TransportError("no message from " + executor + ": " + senders_hint(link));
}

std::int64_t tick_at(const std::string& text, KeyedLink& link, const std::string& executor) {
  if (text.empty()) return -1;
  constexpr double most_seconds = 86400;  // a day: a command that waits keeps others from waiting
  constexpr double most_ticks = 1e15;
  const bool from_now = text.front() == '+';
  const auto number = csv_number(from_now ? text.substr(1) : text);
  const bool good = number && *number >= 0 &&
                    (from_now ? *number <= most_seconds
                              : *number <= most_ticks && *number == std::floor(*number));
  if (!good)
    throw InputError(
        "--at", text,
        "must be a tick, such as 120000, or +SECONDS from now, such as +2.5 (at most +86400), "
        "without a unit");
  if (!from_now) return static_cast<std::int64_t>(*number);
  const auto tick = tick_after(link.transport(), executor, *number, link.key());
  if (!tick) throw_missing(link, executor);
  return *tick;
}

std::string missing_text(KeyedLink& link, const std::vector<std::string>& executors) {
  Watch watch(link.transport(), {.names = executors, .key = link.key()});
  constexpr auto slice = std::chrono::milliseconds(100);
  constexpr int slices = 10;
  for (int i = 0; i < slices && !watch.missing().empty(); ++i) watch.run(slice);
  const std::string name = watch.missing();
  return name.empty() ? "" : "no message from " + name + ": " + senders_hint(link);
}

}  // namespace jounce::dashboard
