// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "jounce/stream/security/key.hpp"
#include "jounce/stream/sender/client.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce::web {

/// Makes a new link; called for each thread that needs a link. Several threads call it.
using MakeLink = std::function<std::unique_ptr<Transport>()>;

/// The hold-to-run jogs of a live page. While the button of a jog is held, the browser repeats its
/// request. Each jog has a random number from the browser. As long as the requests continue, a
/// thread sends the heartbeats that the axis needs.
///
///     Jogs jogs(make_link, key);
///     jogs.jog("feeder", -20, 4711);    // begins; the same again within 0.3 s: it continues
///     jogs.release("feeder", 4711);     // the button was released: the axis stops
///
/// If the requests stop, the jog ends after 0.3 s. If this process ends, the executor stops the
/// axis after 0.2 s. The number of a jog that has ended does not begin another jog, so a late
/// request causes no motion.
class Jogs {
 public:
  /// Time after the last request at which a jog ends.
  static constexpr Nanos patience = std::chrono::milliseconds(300);
  static constexpr Nanos beat = std::chrono::milliseconds(50);  ///< time between two heartbeats

  /// `key`: key of the executors; nullopt: none.
  Jogs(MakeLink make_link, std::optional<wire::Key> key);
  /// Ends all jogs.
  ~Jogs();
  Jogs(const Jogs&) = delete;
  Jogs& operator=(const Jogs&) = delete;

  /// Begins the jog with this number, or continues it. A new number ends the previous jog of the
  /// axis. `velocity`: signed, in the unit of the axis. Returns the answer of the axis; a jog that
  /// has ended is rejected. Throws TransportError.
  CallOutcome jog(const std::string& axis, double velocity, std::int64_t number);
  /// Ends the jog with this number.
  void release(const std::string& axis, std::int64_t number);

 private:
  struct Held;

  std::shared_ptr<Held> begun(const std::string& axis, std::int64_t number);
  void end(const std::string& axis, std::int64_t number);
  void forget(const std::string& axis, std::int64_t number);

  MakeLink make_link_;
  std::optional<wire::Key> key_;
  std::mutex mutex_;                                         // guards the members below
  std::map<std::string, std::shared_ptr<Held>> held_;        // by axis
  std::set<std::pair<std::string, std::int64_t>> over_;      // numbers of finished jogs
  std::deque<std::pair<std::string, std::int64_t>> oldest_;  // contents of over_, the oldest first
};

}  // namespace jounce::web
