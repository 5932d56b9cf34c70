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
  Nanos repeat = std::chrono::milliseconds(30);  ///< while it starts
  int asked = 10;                                ///< so often before it is up
  Nanos again = std::chrono::seconds(1);         ///< once it is up
};

/// The claim of an executor to a name: a pure state machine without thread, clock or link. All executors of
/// one network run it, each with the names of its axes and its boot.
///
///     Claim claim({"feeder", "knife"}, random_id());
///     claim.receive(message, now);                       // each arrived message
///     for (const auto& m : claim.poll(now)) ...          // to be sent
///     if (claim.lost()) ...                              // another executor has this name
///     if (claim.up()) ...                                // all names are this executor's
///
/// **The rule.** Of two, the one that is up wins over the one that starts; otherwise the one with the
/// smaller boot. An executor asks before it is up, and goes on to ask once it is: two networks may be
/// joined, or both may have been deaf.
///
/// **Exactly one.** An executor gives up only where a claim names its boot: then the other one has
/// received its claim, judges by the same rule and is the one that wins. Nothing that was recorded
/// from an earlier run names this boot. See decision 0063 for the argument.
class Claim {
 public:
  /// `boot` > 0: a random number, another one at every start.
  Claim(std::vector<std::string> names, std::int64_t boot, ClaimOptions options = {});

  void receive(const wire::Message& message, Nanos now);
  [[nodiscard]] std::vector<wire::Message> poll(Nanos now);

  /// It has asked as often as it must, and waited for the answers: all that waits on the link has
  /// been received before.
  [[nodiscard]] bool up() const { return up_; }
  /// The name that another executor has.
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

/// Claims the names over the link until they are this executor's, or lost. Messages on other
/// channels meanwhile is dropped. True: it is up.
bool claim_names(Transport& link, Claim& claim, const std::optional<wire::Key>& key,
                 const Clock& clock);

}  // namespace jounce
