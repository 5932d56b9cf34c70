// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace jounce {

/// The present challenges of an executor: one for its session, and one for operators. All
/// challenges are greater than 0 and different, within a boot and between boots.
///
///     Challenges challenges(boot);
///     if (message.challenge == challenges.operators()) challenges.renew_operators();
class Challenges {
 public:
  /// `boot` > 0: a random number, different at every start.
  explicit Challenges(std::int64_t boot) : boot_(boot) {}

  [[nodiscard]] std::int64_t session() const { return session_; }
  [[nodiscard]] std::int64_t operators() const { return operators_; }

  /// Draws a new challenge. Messages with the previous challenge then have no effect.
  void renew_session() { session_ = draw(); }
  void renew_operators() { operators_ = draw(); }

 private:
  [[nodiscard]] std::int64_t draw();

  std::int64_t boot_;
  std::int64_t drawn_ = 0;  // number of challenges drawn
  std::int64_t session_ = draw();
  std::int64_t operators_ = draw();
};

}  // namespace jounce
