// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jounce {

/// An event of a cam or a follow table that plays on the live master. m is the unit of the master.
struct ProfileEvent {
  enum class Kind : std::uint8_t {
    begin,     ///< a follow table begins: at its start event, or at the end of the table before it
    pass_end,  ///< a pass (one run of a cam or table) has ended: EndOfProfile of MC_CamIn
  };
  Kind kind = Kind::pass_end;
  /// begin: the FIFO of the table, 1 or 2. pass_end: number of passes that have ended, of the cam
  /// since its start, or of the table (GT_GetFollowLoop of Googol).
  std::int64_t number = 1;
  double t = 0;       ///< instant of the event, s; in a Tick: counted from the tick, <= 0
  double master = 0;  ///< position of the master at this instant, m
};

/// The events of one tick, in their order. A pass that ends replaces the event of the pass before
/// it, if both end in one tick; its number shows this.
class ProfileStep {
 public:
  /// Two for each of two successive tables: it begins, and its last pass ends.
  static constexpr std::size_t most = 4;

  void clear() noexcept { count_ = 0; }
  /// Adds an event; drops it if there are already `most`.
  void add(const ProfileEvent& event) noexcept {
    if (count_ < most) events_[count_++] = event;
  }
  [[nodiscard]] std::span<const ProfileEvent> events() const noexcept {
    return {events_.data(), count_};
  }

 private:
  std::array<ProfileEvent, most> events_{};
  std::size_t count_ = 0;
};

}  // namespace jounce
