// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "jounce/stream/message/message.hpp"

namespace jounce {

/// A refusal with its reason as text.
struct Refused {
  wire::Refusal refusal = wire::Refusal::none;  ///< none: accepted
  std::string reason;                           ///< may be empty
  std::int32_t cause = 0;                       ///< number of a Cause; 0: none

  /// True if the message was rejected.
  explicit operator bool() const { return refusal != wire::Refusal::none; }
};

/// Returns bad_header for an inconsistent header; otherwise none.
Refused contradiction(const wire::Header& header);

/// A table with its units.
struct TableInUnits {
  const Table& table;
  const Units& units;
};

/// Returns the reason why these tables cannot be armed in this mode, or none. The rules: the
/// slave's table is over time or over a master, as the mode requires. For follow_table, the
/// master's table is over time, and its position has the unit of x of the slave's table. Each table
/// over time is in s. `master` is null if the mode has no table of the master.
Refused misfit(wire::ArmMode mode, TableInUnits slave, const TableInUnits* master);

}  // namespace jounce
