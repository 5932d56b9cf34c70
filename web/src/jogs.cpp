// SPDX-License-Identifier: Apache-2.0
#include "jounce/web/jogs.hpp"

#include <condition_variable>
#include <thread>
#include <utility>

namespace jounce::web {
namespace {

constexpr std::size_t most_over = 1024;  // numbers kept

CallOutcome has_ended(const std::string& axis) {
  return {StreamError::refused, wire::Refusal::none, 0,
          "the jog of " + axis + " has ended: release the button, and press it again"};
}

}  // namespace

/// A jog in progress. Its thread ends with it.
struct Jogs::Held {
  explicit Held(std::int64_t its_number) : number(its_number), asked(steady_now()) {}
  ~Held() {
    end();
    if (keeper.joinable()) keeper.join();
  }

  void end() {
    {
      const std::scoped_lock lock(mutex);
      ended = true;
    }
    changed.notify_all();
  }

  /// The browser still holds its button; returns false if the jog has ended.
  bool ask() {
    const std::scoped_lock lock(mutex);
    asked = steady_now();
    return !ended;
  }

  /// Returns true if it ended within `time`, or by the browser's timeout.
  bool ends_within(Nanos time) {
    std::unique_lock lock(mutex);
    changed.wait_for(lock, time, [this] { return ended; });
    if (steady_now() - asked > patience) ended = true;
    return ended;
  }

  /// Sends heartbeats until it ends. An operator's stop ends the session: heartbeats are then
  /// pointless.
  void keep() {
    const std::int64_t session = client->session();
    try {
      while (!ends_within(beat))
        if (!client->beat().ok() || client->session() != session) break;
      end();
      static_cast<void>(client->release());
    } catch (const std::exception&) {
      end();  // the executor stops the axis
    }
  }

  const std::int64_t number;
  std::unique_ptr<Transport> link;
  std::unique_ptr<Client> client;
  std::mutex mutex;  // guards the two below
  Nanos asked;
  bool ended = false;
  std::condition_variable changed;
  std::thread keeper;
};

Jogs::Jogs(MakeLink make_link, std::optional<wire::Key> key)
    : make_link_(std::move(make_link)), key_(std::move(key)) {}

Jogs::~Jogs() {
  for (auto& [axis, held] : held_) held->end();
}

/// Returns the new jog of this number; null if it exists, or has ended.
std::shared_ptr<Jogs::Held> Jogs::begun(const std::string& axis, std::int64_t number) {
  std::shared_ptr<Held> before;  // destroyed without the lock, before the new one begins
  const std::scoped_lock lock(mutex_);
  if (over_.contains({axis, number})) return nullptr;
  std::shared_ptr<Held>& held = held_[axis];
  if (held && held->number == number) return nullptr;
  if (held) {
    forget(axis, held->number);
    held->end();
  }
  before = std::exchange(held, std::make_shared<Held>(number));
  return held;
}

CallOutcome Jogs::jog(const std::string& axis, double velocity, std::int64_t number) {
  const std::shared_ptr<Held> held = begun(axis, number);
  if (!held) {
    const std::scoped_lock lock(mutex_);
    const auto at = held_.find(axis);
    const bool goes_on = at != held_.end() && at->second->number == number && at->second->ask();
    return goes_on ? CallOutcome{} : has_ended(axis);
  }
  try {
    held->link = make_link_();
    held->client = std::make_unique<Client>(*held->link, axis, ClientOptions{.key = key_});
    // The button may be released while the session opens, which may take seconds.
    CallOutcome outcome = held->client->beat();
    if (outcome.ok())
      outcome = held->ends_within(Nanos{}) ? has_ended(axis)
                                           : held->client->command(command::MoveVelocity{
                                                 .velocity = velocity, .hold_to_run = true});
    if (outcome.ok())
      held->keeper = std::thread([raw = held.get()] { raw->keep(); });
    else
      static_cast<void>(held->client->release());
    if (!outcome.ok()) end(axis, number);
    return outcome;
  } catch (...) {
    end(axis, number);
    throw;
  }
}

void Jogs::release(const std::string& axis, std::int64_t number) {
  end(axis, number);
}

/// The number cannot begin a jog again. The oldest of the kept numbers is dropped.
void Jogs::forget(const std::string& axis, std::int64_t number) {
  if (!over_.emplace(axis, number).second) return;
  oldest_.emplace_back(axis, number);
  if (oldest_.size() <= most_over) return;
  over_.erase(oldest_.front());
  oldest_.pop_front();
}

void Jogs::end(const std::string& axis, std::int64_t number) {
  const std::scoped_lock lock(mutex_);
  forget(axis, number);
  const auto at = held_.find(axis);
  if (at != held_.end() && at->second->number == number) at->second->end();
}

}  // namespace jounce::web
