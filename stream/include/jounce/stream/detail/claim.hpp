// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "jounce/stream/message/message.hpp"
#include "jounce/stream/security/key.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// Times of a claim. A claim is *up* when its executor owns the names (Claim::up()).
struct ClaimOptions {
  /// Time between two requests before the claim is up.
  Nanos repeat = std::chrono::milliseconds(30);
  int asked = 10;                         ///< number of requests before the claim is up, > 0
  Nanos again = std::chrono::seconds(1);  ///< time between two requests when the claim is up
};

/// The claim of an executor to its names, as a pure state machine without thread, clock or link.
/// Every executor of a network has one claim. The claim contains the names of the axes and the
/// *boot*: a random number for this start of the executor.
///
///     Claim claim({"feeder", "knife"}, random_id());
///     claim.receive(message, now);                       // each arrived message
///     for (const auto& m : claim.poll(now)) ...          // send each one
///     if (claim.lost()) ...                              // another executor has this name
///     if (claim.up()) ...                                // all names are this executor's
///
/// **The rule.** If two executors have the same name, an executor that is up wins over one that
/// starts; otherwise the smaller boot wins. An executor sends requests before it is up. The
/// executor continues to send requests afterwards, because two networks may be connected later, or
/// messages may have been lost.
///
/// **Exactly one** executor wins. Executor A gives up only if it receives a claim of an executor B
/// that contains the boot of A. So B has received the claim of A, applies the same rule, and wins.
/// Messages recorded in an earlier run never contain the present boot of A. Decision 0063 gives the
/// proof.
class Claim {
 public:
  /// `names`: names of the axes. `boot` > 0: a random number, different at each start.
  Claim(std::vector<std::string> names, std::int64_t boot, ClaimOptions options = {});

  /// Processes a message that has arrived.
  void receive(const wire::Message& message, Nanos now);
  /// Returns the messages to send now. Decides whether the claim is up.
  [[nodiscard]] std::vector<wire::Message> poll(Nanos now);

  /// True if the claim is up: poll() has sent `asked` requests, and the time for answers is over.
  /// Before each poll(now), receive all messages that arrived before `now`; otherwise unread
  /// answers count as silence.
  [[nodiscard]] bool up() const { return up_; }
  /// The name that another executor owns; nullopt: none.
  [[nodiscard]] const std::optional<std::string>& lost() const { return lost_; }
  /// The claimed names.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// The number of this start of the executor.
  [[nodiscard]] std::int64_t boot() const { return boot_; }

 private:
  void ask(Nanos now);

  std::vector<std::string> names_;
  std::int64_t boot_;
  ClaimOptions options_;
  int asked_ = 0;
  std::optional<Nanos> asked_at_{};
  bool up_ = false;
  std::optional<std::string> lost_{};
  std::vector<wire::Message> outgoing_;
};

/// Claims the names over the link. Returns true if this executor owns all names, and false if
/// another executor owns one of them. Drops messages on other channels in the meantime.
bool claim_names(Transport& link, Claim& claim, const std::optional<wire::Key>& key,
                 const Clock& clock);

}  // namespace jounce
