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

struct ClaimOptions {
  Nanos repeat = std::chrono::milliseconds(30);  ///< during the start
  int asked = 10;                                ///< number of requests before it is up
  Nanos again = std::chrono::seconds(1);         ///< after it is up
};

/// The claim of an executor to its names: a pure state machine without thread, clock or link. All
/// executors of one network run it, each with the names of its axes and its boot.
///
///     Claim claim({"feeder", "knife"}, random_id());
///     claim.receive(message, now);                       // each arrived message
///     for (const auto& m : claim.poll(now)) ...          // to be sent
///     if (claim.lost()) ...                              // another executor has this name
///     if (claim.up()) ...                                // all names are this executor's
///
/// **The rule.** Of two executors, one that is up wins over one that starts; otherwise the smaller
/// boot wins. An executor asks before it is up, and continues to ask afterwards: two networks may
/// be joined, or neither may have received messages before.
///
/// **Exactly one.** An executor gives up only if a claim names its boot: the other one has then
/// received its claim, applies the same rule and wins. Messages recorded from an earlier run never
/// name this boot. Decision 0063 has the argument.
class Claim {
 public:
  /// `boot` > 0: a random number, different at every start.
  Claim(std::vector<std::string> names, std::int64_t boot, ClaimOptions options = {});

  void receive(const wire::Message& message, Nanos now);
  [[nodiscard]] std::vector<wire::Message> poll(Nanos now);

  /// True if it has asked as often as required, and waited for the answers. All messages waiting on
  /// the link must have been received before.
  [[nodiscard]] bool up() const { return up_; }
  /// The name that another executor owns.
  [[nodiscard]] const std::optional<std::string>& lost() const { return lost_; }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
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

/// Claims the names over the link until this executor owns them, or has lost them. Drops messages
/// on other channels meanwhile. Returns true if it is up.
bool claim_names(Transport& link, Claim& claim, const std::optional<wire::Key>& key,
                 const Clock& clock);

}  // namespace jounce
