// SPDX-License-Identifier: Apache-2.0
#include "web/src/scope.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "jounce/base/detail/csv.hpp"
#include "jounce/plot/label.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::web {
namespace {

using nlohmann::ordered_json;

constexpr double longest_span = 3600;  // s
constexpr double shortest_span = 1e-6;
constexpr double least_modulo = 1e-9;
constexpr double most_modulo = 1e12;
constexpr std::size_t most_buckets = 4000;
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

double number_in(const Request& request, const char* key, double otherwise, double least,
                 double greatest) {
  const std::string text = request.value(key);
  if (text.empty()) return otherwise;
  const auto number = csv_number(text);
  if (!number || !(*number >= least && *number <= greatest))
    throw InputError(
        key, text,
        "must be a number from " + short_number(least) + " to " + short_number(greatest));
  return *number;
}

std::optional<std::int64_t> tick_in(const Request& request, const char* key) {
  constexpr double most = 9007199254740992;  // 2^53: integers of a browser are exact up to it
  const double number = number_in(request, key, no_number, -1, most);
  if (std::isnan(number)) return std::nullopt;
  return static_cast<std::int64_t>(number);
}

std::size_t signal_named(const std::string& name) {
  const auto& all = TraceTick::signals;
  const auto* const at = std::find_if(all.begin(), all.end(),
                                      [&](const Field& signal) { return signal.name == name; });
  if (at != all.end()) return static_cast<std::size_t>(at - all.begin());
  std::string names;
  for (const Field& signal : all) names += (names.empty() ? "" : ", ") + std::string(signal.name);
  throw InputError("signal", name, "must be one of " + names);
}

bool passes_level(const ScopeTrigger& trigger, double before, double now) {
  return trigger.rising ? before < trigger.level && now >= trigger.level
                        : before > trigger.level && now <= trigger.level;
}

/// The ticks of a window, with the master in its period.
std::vector<TraceTick> window_of(const Trace& trace, std::size_t axis, std::int64_t first,
                                 std::int64_t last, const std::optional<double>& modulo) {
  constexpr std::size_t master = 6;
  static_assert(TraceTick::signals[master].quantity == Quantity::master);
  auto ticks = trace.ticks(axis, first, last);
  if (modulo)
    for (TraceTick& tick : ticks) {
      double& position = tick.values[master];
      position -= *modulo * std::floor(position / *modulo);
    }
  return ticks;
}

/// The trigger whose window is complete; nullopt: there is none.
std::optional<std::int64_t> trigger_in(const Trace& trace, std::size_t axis,
                                       const ScopeTrigger& trigger, std::int64_t last,
                                       const std::optional<double>& modulo) {
  std::optional<std::int64_t> at;
  const auto ticks = window_of(trace, axis, trigger.after, last, modulo);
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    if (!passes_level(trigger, ticks[i - 1].values[trigger.signal],
                      ticks[i].values[trigger.signal]))
      continue;
    if (ticks[i].tick <= trigger.after) continue;
    at = ticks[i].tick;
    if (trigger.first) break;
  }
  return at;
}

/// The least and greatest values of one signal in each bucket.
struct Extremes {
  std::vector<double> low, high;
  bool known = false;

  void begin() {
    low.push_back(no_number);
    high.push_back(no_number);
  }
  void add(double value) {
    if (std::isnan(value)) return;
    known = true;
    low.back() = std::fmin(low.back(), value);  // fmin ignores NaN
    high.back() = std::fmax(high.back(), value);
  }
};

std::string unit_text(const std::array<char, TraceTable::most_unit>& unit) {
  return {unit.data()};
}

std::string utf8_dump(const ordered_json& json) {
  return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace

ScopeQuery scope_query(const Request& request) {
  ScopeQuery query;
  query.span = number_in(request, "span", query.span, shortest_span, longest_span);
  query.buckets = static_cast<std::size_t>(
      number_in(request, "buckets", static_cast<double>(query.buckets), 0, most_buckets));
  query.until = tick_in(request, "until");
  if (!request.value("modulo").empty())
    query.modulo = number_in(request, "modulo", 0, least_modulo, most_modulo);
  const std::string signal = request.value("signal");
  if (signal.empty()) return query;
  ScopeTrigger& trigger = query.trigger.emplace();
  trigger.signal = signal_named(signal);
  trigger.level = number_in(request, "level", 0, std::numeric_limits<double>::lowest(),
                            std::numeric_limits<double>::max());
  const std::string edge = request.value("edge");
  if (!edge.empty() && edge != "rising" && edge != "falling")
    throw InputError("edge", edge, "must be rising or falling");
  trigger.rising = edge != "falling";
  trigger.before = number_in(request, "before", 0, 0, query.span);
  trigger.after = tick_in(request, "after").value_or(-1);
  trigger.first = request.value("pick") == "first";
  return query;
}

std::string scope_json(const Trace& trace, std::size_t axis, const ScopeQuery& query,
                       bool every_cycle) {
  const double period = static_cast<double>(trace.period(axis)) * 1e-9;
  const auto newest = trace.newest(axis);
  ordered_json out{{"ok", true},
                   {"period", period},
                   {"source", every_cycle ? "cycle" : "status"},
                   {"newest", nullptr},
                   {"trigger", nullptr}};
  const auto length = static_cast<std::int64_t>(std::ceil(query.span / period));
  std::int64_t last = query.until.value_or(newest.value_or(0));
  if (newest) out["newest"] = *newest;
  if (query.trigger && newest) {
    const auto before = static_cast<std::int64_t>(std::llround(query.trigger->before / period));
    const std::int64_t behind = length - before;
    if (const auto at = trigger_in(trace, axis, *query.trigger, last - behind, query.modulo)) {
      out["trigger"] = *at;
      last = *at + behind;
    }
  }
  const auto ticks = window_of(trace, axis, last - length, last, query.modulo);
  const std::int64_t covered = ticks.empty() ? 0 : ticks.back().tick - ticks.front().tick + 1;
  const std::int64_t each =
      query.buckets == 0
          ? 1
          : std::max<std::int64_t>(1, length / static_cast<std::int64_t>(query.buckets) +
                                          (length % static_cast<std::int64_t>(query.buckets) != 0));
  out["first"] = last - length;
  out["last"] = last;
  out["missing"] = covered - static_cast<std::int64_t>(ticks.size());
  out["each"] = each;
  std::vector<std::int64_t> begins;
  std::array<Extremes, TraceTick::signals.size()> signals;
  std::int64_t bucket = std::numeric_limits<std::int64_t>::min();
  for (const TraceTick& tick : ticks) {
    if (tick.tick / each != bucket) {
      bucket = tick.tick / each;
      begins.push_back(tick.tick);
      for (Extremes& signal : signals) signal.begin();
    }
    for (std::size_t k = 0; k < signals.size(); ++k) signals[k].add(tick.values[k]);
  }
  out["ticks"] = std::move(begins);
  for (std::size_t k = 0; k < signals.size(); ++k) {
    if (!signals[k].known) continue;
    out["low"][TraceTick::signals[k].name] = std::move(signals[k].low);
    if (each > 1) out["high"][TraceTick::signals[k].name] = std::move(signals[k].high);
  }
  return utf8_dump(out);
}

std::string path_json(const Trace& trace, std::size_t group, const Request& request) {
  const auto seen = static_cast<std::uint64_t>(tick_in(request, "seen").value_or(0));
  const std::uint64_t number = trace.path_number(group);
  ordered_json out{{"ok", true}, {"number", number}};
  const auto path = number == 0 || number == seen ? nullptr : trace.path(group);
  if (!path) return utf8_dump(out);
  out["number"] = path->number;
  out["unit"] = unit_text(path->unit);
  out["origin"] = path->origin;
  out["names"] = ordered_json::array();
  out["places"] = ordered_json::array();
  const auto count = static_cast<std::ptrdiff_t>(path->points);
  out["at"] = std::vector<double>(path->at.begin(), path->at.begin() + count);
  for (std::size_t k = 0; k < path->coordinates; ++k) {
    out["names"].push_back(unit_text(path->names[k]));
    out["places"].push_back(
        std::vector<double>(path->places[k].begin(), path->places[k].begin() + count));
  }
  return utf8_dump(out);
}

std::string tables_json(const Trace& trace, const std::vector<std::string>& axes) {
  ordered_json all = ordered_json::array();
  for (const TraceTable& table : trace.last_tables())
    all.push_back({{"number", table.number},
                   {"axis", table.axis < axes.size() ? axes[table.axis] : ""},
                   {"hash", hex(table.hash)},
                   {"knots", table.knots},
                   {"over", name(table.over)},
                   {"start", table.start},
                   {"end", table.end},
                   {"x_unit", unit_text(table.x_unit)},
                   {"unit", unit_text(table.unit)},
                   {"position", table.position}});
  return utf8_dump({{"ok", true}, {"tables", std::move(all)}});
}

}  // namespace jounce::web
