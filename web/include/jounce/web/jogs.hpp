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

/// Makes a link of its own for each thread that needs one; called from several threads.
using MakeLink = std::function<std::unique_ptr<Transport>()>;

/// The hold-to-run jogs of a page. A browser asks for one, again and again, as long as its button is held; each has a
/// number that the browser has drawn. So long as it asks, a thread of the jog sends the heartbeats that the axis needs.
///
///     Jogs jogs(make_link, key);
///     jogs.jog("feeder", -20, 4711);    // begins; the same again within 0.3 s: it goes on
///     jogs.release("feeder", 4711);     // the button was let go: the axis stops
///
/// Where the browser falls silent, the jog ends after 0.3 s. Where this process dies, the executor stops the axis after
/// 0.2 s. A jog that has ended does not begin again by its number: a late request moves nothing.
class Jogs {
 public:
  static constexpr Nanos patience = std::chrono::milliseconds(300);  ///< the browser's silence
  static constexpr Nanos beat = std::chrono::milliseconds(50);

  Jogs(MakeLink make_link, std::optional<wire::Key> key);
  /// Ends all of them.
  ~Jogs();
  Jogs(const Jogs&) = delete;
  Jogs& operator=(const Jogs&) = delete;

  /// Begins the jog of this number with a velocity in the axis's unit, or keeps it. Refused: the axis's reason, or it
  /// has ended. Throws TransportError.
  CallOutcome jog(const std::string& axis, double velocity, std::int64_t number);
  void release(const std::string& axis, std::int64_t number);

 private:
  struct Held;

  std::shared_ptr<Held> begun(const std::string& axis, std::int64_t number);
  void end(const std::string& axis, std::int64_t number);
  void forget(const std::string& axis, std::int64_t number);

  MakeLink make_link_;
  std::optional<wire::Key> key_;
  std::mutex mutex_;                                         // guards all below
  std::map<std::string, std::shared_ptr<Held>> held_;        // by axis
  std::set<std::pair<std::string, std::int64_t>> over_;      // numbers of those that have ended
  std::deque<std::pair<std::string, std::int64_t>> oldest_;  // the same, the oldest first
};

}  // namespace jounce::web
