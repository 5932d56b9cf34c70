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
#include "jounce/stream/transport/link.hpp"
#include "jounce/stream/transport/transport.hpp"

/// State of the axes of executors, from their messages.
namespace jounce::dashboard {

/// An axis by its messages.
struct Watched {
  static constexpr std::size_t traced = 240;       ///< positions that are kept
  static constexpr std::size_t most_masters = 64;  ///< without a key, any sender can invent some

  std::string name;
  std::optional<wire::Status> status = std::nullopt;  ///< the newest; none: no message yet
  Nanos received{};                                   ///< its arrival
  std::deque<double> trace = {};                      ///< positions every 100 ms, the newest last
  Nanos traced_at{};                                  ///< arrival of the newest of them
  std::vector<wire::MasterStatus> masters = {};       ///< state of each, by name
};

/// Stores a status; a new axis gets its place by name.
void take(std::vector<Watched>& axes, const std::string& name, const wire::Status& status,
          Nanos now);

/// Stores the state of a master in an axis; without effect before the first status of the axis. If
/// there are too many, drops the one of the earliest cycle.
void take(std::vector<Watched>& axes, const std::string& name, const wire::MasterStatus& master);

struct WatchOptions {
  std::vector<std::string> names = {};  ///< the executors; empty: all that send messages
  std::optional<wire::Key> key = {};    ///< their key; nullopt: none
};

/// Receives the statuses of executors:
///
///     Watch watch(*link, {});
///     for (;;) {
///       watch.run(50ms);
///       if (!watch.silent(3s).empty()) break;
///       draw(watch.axes());
///     }
class Watch {
 public:
  /// Subscribes. The link must outlive it.
  Watch(Transport& link, WatchOptions options);

  /// Receives for this time. Calls the functions, if given, with each status of an axis and of a master.
  void run(
      Nanos time,
      const std::function<void(const std::string& axis, const wire::Status&)>& status = {},
      const std::function<void(const std::string& axis, const wire::MasterStatus&)>& master = {});

  /// The name of an executor in the options that has sent no message for this time, or "every
  /// executor"; "": none.
  [[nodiscard]] std::string silent(Nanos patience) const;
  [[nodiscard]] bool has_received() const;
  /// Sorted by name.
  [[nodiscard]] const std::vector<Watched>& axes() const { return axes_; }

 private:
  [[nodiscard]] bool is_wanted(const std::string& name) const;

  Transport& link_;
  WatchOptions options_;
  std::vector<Watched> axes_;
  Rejects rejects_;
  Nanos begun_ = steady_now();
};

}  // namespace jounce::dashboard
