// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "jounce/executor/detail/trace.hpp"
#include "jounce/web/server.hpp"

namespace jounce::web {

/// Start of a window: the signal passes the level, as on an oscilloscope.
struct ScopeTrigger {
  std::size_t signal = 0;   ///< index in TraceTick::signals
  double level = 0;         ///< in the unit of the signal
  bool rising = true;       ///< direction
  double before = 0;        ///< part of the window before the trigger, s
  std::int64_t after = -1;  ///< only later ticks are searched
  bool first = false;       ///< true: the first such tick; false: the last one
};

/// A window of the trace of an axis.
struct ScopeQuery {
  double span = 2;                        ///< length of the window, s
  std::size_t buckets = 800;              ///< greatest number of its parts; 0: every tick
  std::optional<std::int64_t> until{};    ///< last tick; nullopt: the newest one
  std::optional<double> modulo{};         ///< period of the master position, > 0; nullopt: none
  std::optional<ScopeTrigger> trigger{};  ///< nullopt: no trigger
};

/// Reads a query such as "span=2&buckets=800&signal=position&level=10&edge=rising&before=0.5".
/// Throws InputError for a value out of range.
ScopeQuery scope_query(const Request& request);

/// Returns a window as JSON: {"period", "source", "newest", "first", "last", "trigger", "missing", "each",
/// "ticks": [...], "low": {signal: [...]}, "high": {signal: [...]}}.
///
/// A bucket has the ticks whose numbers have the same quotient by `each`. Its `low` and `high` are
/// the least and greatest values of all its ticks, so no extreme value is lost. If `each` is 1,
/// `high` is missing. A signal is missing if its values are unknown. With a trigger whose window is
/// not complete yet, `trigger` is null, and the window is the newest one. `every_cycle`: false if
/// the ticks come from status messages.
std::string scope_json(const Trace& trace, std::size_t axis, const ScopeQuery& query,
                       bool every_cycle = true);

/// Returns the planned path of a group as JSON: {"number", "names", "unit", "origin", "at": [...],
/// "places": [[...], ...]} with one list of places for each name; see TracePath. If the number is
/// the key "seen" of the request, or 0 (no path), the object has only the number.
std::string path_json(const Trace& trace, std::size_t group, const Request& request);

/// Returns the tables of an executor as JSON, the newest first. `axes`: names of the axes.
std::string tables_json(const Trace& trace, const std::vector<std::string>& axes);

}  // namespace jounce::web
