// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/stream/message/message.hpp"

namespace jounce {

/// A refusal with its reason in words; none: accepted.
struct Refused {
  wire::Refusal refusal = wire::Refusal::none;
  std::string reason;

  explicit operator bool() const { return refusal != wire::Refusal::none; }
};

/// Error of a header: bad_header, or none.
Refused contradiction(const wire::Header& header);

/// A table with the units of its axes.
struct TableInUnits {
  const Table& table;
  const Units& units;
};

/// The reason why these tables cannot be armed in this mode, or none. Checks the slave's axis and,
/// in follow_table, that the master is over time and in the unit of the slave table's x. Every
/// table over time is in s.
Refused misfit(wire::ArmMode mode, TableInUnits slave, const TableInUnits* master);

}  // namespace jounce
