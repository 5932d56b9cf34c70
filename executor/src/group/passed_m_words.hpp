// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "jounce/axis/detail/group_program.hpp"
#include "jounce/axis/tick.hpp"
#include "jounce/stream/message/message.hpp"

namespace jounce {

/// The M words that a group passes without a wait, as events with their instants.
class PassedMWords {
 public:
  /// The group plays this program from a path time on, s; null: it has no M words.
  void begin(std::shared_ptr<const GroupProgram> program, double path_time);
  /// Returns the events between two ticks of the group, without their counts. `period`: ns. At the end of
  /// the program, `now` has no path.
  [[nodiscard]] std::vector<wire::Event> passed(const Tick& before, const Tick& now,
                                                std::int64_t period);

 private:
  std::shared_ptr<const GroupProgram> program_;
  std::size_t next_ = 0;
};

}  // namespace jounce
