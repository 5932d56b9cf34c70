// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "jounce/stream/message/message.hpp"
#include "jounce/stream/security/key.hpp"
#include "jounce/stream/sender/stream_outcome.hpp"
#include "jounce/stream/transport/keyed_link.hpp"
#include "jounce/stream/transport/link.hpp"
#include "jounce/stream/transport/transport.hpp"

/// The state of the axes of executors, from their messages.
namespace jounce::dashboard {

/// Stands for the name of an executor that is missing, if no names are given.
inline constexpr const char* any_executor = "every executor";

/// The state of one axis.
struct Watched {
  static constexpr std::size_t traced = 240;  ///< greatest length of `trace`
  /// Greatest number of masters. (Without a key, any program can send messages about further
  /// masters.)
  static constexpr std::size_t most_masters = 64;

  std::string name = {};  ///< name of the axis
  /// The newest status; nullopt: no message yet.
  std::optional<wire::Status> status = std::nullopt;
  Nanos received{};                              ///< time at which the status arrived
  std::deque<double> trace = {};                 ///< positions every 100 ms, the newest last
  Nanos traced_at{};                             ///< time of the newest position in `trace`
  std::vector<wire::MasterStatus> masters = {};  ///< state of each master, sorted by name
  std::optional<wire::GroupStatus> group = {};   ///< for a group: its place on its path
  /// Greatest number of events; a latch buffer of the PMC600 (manual 9.5) has the same size.
  static constexpr std::size_t most_events = 256;
  std::deque<wire::Event> events = {};  ///< the last events, the newest last
  std::int64_t lost_events = 0;         ///< number of events whose messages did not arrive
};

/// Stores a status in the list, which is sorted by name. Adds the axis if it is new.
void take(std::vector<Watched>& axes, const std::string& name, const wire::Status& status,
          Nanos now);

/// Stores the state of a master in an axis. Has no effect before the first status of the axis. If
/// the axis has too many masters, drops the one whose newest state has the smallest tick.
void take(std::vector<Watched>& axes, const std::string& name, const wire::MasterStatus& master);

/// Stores the place of a group on its path. Has no effect before the first status of the group.
void take(std::vector<Watched>& axes, const std::string& name, const wire::GroupStatus& group);

/// Stores an event in an axis, unless it is there. Returns true if the event is new. Has no effect
/// before the first status of the axis. The first event of an executor that was started again
/// removes the events before it.
bool take(std::vector<Watched>& axes, const std::string& name, const wire::Event& event);

/// Options of Watch.
struct WatchOptions {
  /// Names of the axes; empty: all axes that send messages.
  std::vector<std::string> names = {};
  /// Key with which the executors authenticate messages; nullopt: none.
  std::optional<wire::Key> key = {};
};

/// Receives the status messages of executors:
///
///     Watch watch(*link, {});
///     for (;;) {
///       watch.run(50ms);
///       if (!watch.silent(3s).empty()) break;
///       use(watch.axes());
///     }
class Watch {
 public:
  /// Subscribes to the messages. `link` must outlive the object.
  Watch(Transport& link, WatchOptions options);

  /// Receives messages for the duration `time`. Calls `status` with each message about an axis,
  /// `master` with each message about a master, `event` with each new event, and `group` with each
  /// message about a group, if these functions are given.
  void run(
      Nanos time,
      const std::function<void(const std::string& axis, const wire::Status&)>& status = {},
      const std::function<void(const std::string& axis, const wire::MasterStatus&)>& master = {},
      const std::function<void(const std::string& axis, const wire::Event&)>& event = {},
      const std::function<void(const std::string& axis, const wire::GroupStatus&)>& group = {});

  /// Returns the name of an axis in the options that has sent no status for `patience`. Without
  /// names in the options, returns any_executor if no axis has sent a status for `patience`.
  /// Otherwise returns "". The time counts from the constructor on.
  [[nodiscard]] std::string silent(Nanos patience) const;
  /// Returns the name of an axis in the options that has sent no status at all. Without names in
  /// the options, returns any_executor if no status has arrived. Otherwise returns "".
  [[nodiscard]] std::string missing() const;
  /// Returns an axis whose newest status has a state other than `state`, if possible one in
  /// error_stop; nullptr if there is none. Axes without a status are not compared: see missing().
  [[nodiscard]] const Watched* outside(State state) const;
  /// True if a status of an axis has arrived.
  [[nodiscard]] bool has_received() const;
  /// Returns the unit of the positions of an axis or group; "" before its first message.
  [[nodiscard]] std::string unit_of(const std::string& name) const;
  /// The axes, sorted by name.
  [[nodiscard]] const std::vector<Watched>& axes() const { return axes_; }

 private:
  [[nodiscard]] bool is_wanted(const std::string& name) const;

  Transport& link_;
  WatchOptions options_;
  std::vector<Watched> axes_;
  Rejects rejects_;
  Nanos begun_ = steady_now();
};

/// Listens for a second. Returns the names of the executors that send messages, for the error that
/// one of them is missing: "messages arrive from x, y; check the name". If no message arrives,
/// returns "check that it is running, ...".
std::string senders_hint(KeyedLink& link);
/// Returns the sentence of a failed call; if there was no answer, with senders_hint().
std::string error_text(const CallOutcome& outcome, const std::string& executor, KeyedLink& link);
/// Throws TransportError: no message arrives from this executor; with senders_hint().
[[noreturn]] void throw_missing(KeyedLink& link, const std::string& executor);

/// Returns the tick that the text of an option --at requests: a number of a tick, such as 120000,
/// or a time from now in s, such as +2.5. The status of the executor converts the time to a tick.
/// For an empty text, returns -1. Throws InputError "--at", and as throw_missing().
std::int64_t tick_at(const std::string& text, KeyedLink& link, const std::string& executor);

/// Waits up to 1 s and returns the error text of throw_missing() for the first of these executors
/// that sends no status; "" if all of them send one.
std::string missing_text(KeyedLink& link, const std::vector<std::string>& executors);

}  // namespace jounce::dashboard
