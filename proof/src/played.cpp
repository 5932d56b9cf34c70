// SPDX-License-Identifier: Apache-2.0
#include "jounce/proof/played.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <string_view>
#include <utility>

#include "jounce/base/detail/csv.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;

struct LogPlace {
  const std::string& name;
  int line;

  [[noreturn]] void fail(const std::string& key, std::string_view value,
                         const std::string& rule) const {
    throw InputError(key, std::string(value), rule).at(name, line);
  }
};

double real(std::string_view cell, const char* column, const LogPlace& place) {
  const auto value = csv_number(cell);
  if (!value) place.fail(column, cell, "must be a finite number");
  return *value;
}

/// The index of the column whose heading begins with this name; nullopt if there is none.
std::optional<std::size_t> find_column(const std::vector<std::string_view>& header,
                                       std::string_view wanted) {
  const auto it = std::find_if(header.begin(), header.end(), [&](std::string_view cell) {
    return cell.substr(0, cell.find(' ')) == wanted;
  });
  if (it == header.end()) return std::nullopt;
  return static_cast<std::size_t>(it - header.begin());
}

std::size_t column(const std::vector<std::string_view>& header, std::string_view wanted,
                   const LogPlace& place) {
  const auto found = find_column(header, wanted);
  if (!found)
    place.fail("", "",
               "has no column " + std::string(wanted) +
                   ": the file is not a tick log of `jounce run --log`");
  return *found;
}

constexpr std::size_t ticks_on_table = 3;  ///< ticks in a row that show the end of a ramp

/// The place of a tick on its motion: the argument of the motion, and a shift of the position.
struct OnMotion {
  std::function<double(const PlayedTick&)> at;
  double shift = 0;        // u
  bool corrected = false;  // the position includes PlayedTick::correction
  /// Time or distance of the master since its zero, whose rounding shifts the argument.
  std::function<double(const PlayedTick&)> counted;
};

/// The position in a tick without its correction.
double own_position(const PlayedTick& tick, bool corrected) {
  return tick.position - (corrected ? tick.correction : 0);
}

/// The greatest deviation of a position from the commanded one.
template <class Position>
Deviation farthest(const std::vector<PlayedTick>& ticks, const OnMotion& on,
                   const Position& position) {
  Deviation most;
  for (const PlayedTick& tick : ticks) {
    const double error =
        std::abs(own_position(tick, on.corrected) - on.shift - position(on.at(tick)));
    if (error <= most.error) continue;
    most.error = error;
    most.where = tick.time;
  }
  return most;
}

double rounding(const std::vector<PlayedTick>& ticks, const OnMotion& on,
                const DesignedMotion& motion) {
  double position = 0;
  double velocity = 0;
  double counted = 0;
  for (const PlayedTick& tick : ticks) {
    const Motion now = motion.table(on.at(tick));
    position = std::max({position, std::abs(now.position), std::abs(tick.position)});
    velocity = std::max(velocity, std::abs(now.velocity));
    counted = std::max(counted, std::abs(on.counted(tick)));
  }
  const double unit = std::numeric_limits<double>::epsilon();
  return most_roundings * unit * (position + velocity * counted);
}

struct Deviations {
  Deviation table;
  std::optional<Deviation> curve = {};
  std::size_t left_out = 0;  // ticks of the ramp
  double shift = 0;          // the slave after the ramp, u
  bool live = false;         // compared over the master of the log
  [[nodiscard]] bool ok() const { return table.error <= table.limit; }
};

Deviations compare(const std::vector<PlayedTick>& ticks, const OnMotion& on,
                   const DesignedMotion& motion, double tolerance) {
  Deviations result{farthest(ticks, on, [&](double x) { return motion.table(x).position; })};
  result.table.limit = rounding(ticks, on, motion);
  if (motion.curve) {
    result.curve = farthest(ticks, on, motion.curve);
    result.curve->limit = tolerance + result.table.limit;
  }
  return result;
}

/// The correction of the ramp in a tick: the distance of the axis from its cam.
double correction_at(const PlayedTick& tick, const OnMotion& on, const DesignedMotion& motion) {
  return own_position(tick, on.corrected) - on.shift - motion.table(on.at(tick)).position;
}

/// Index of the first tick at which a ramp that began with the first tick has certainly ended. The
/// bound is twice the time of a move through the greatest correction that also brakes the greatest
/// velocity of the correction.
std::size_t longest_ramp(const std::vector<PlayedTick>& ticks, const OnMotion& on,
                         const Designed& designed, const DesignedMotion& motion) {
  constexpr std::int64_t cycles = 10;
  const CouplingSpec& ramp = *designed.ramp;
  const auto first = [&](const auto& over) {
    return static_cast<std::size_t>(std::find_if(ticks.begin(), ticks.end(), over) - ticks.begin());
  };
  if (ramp.start == StartMode::ramp_in_distance)
    return first([&](const PlayedTick& tick) {
      return tick.master && std::abs(*tick.master - *ticks.front().master) > 2 * *ramp.distance;
    });
  double distance = 0;
  double velocity = *ramp.velocity_diff;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const double now = correction_at(ticks[i], on, motion);
    distance = std::max(distance, std::abs(now));
    if (const std::size_t next = i + 1; i < 2 && next < ticks.size())
      velocity = std::max(velocity, std::abs(correction_at(ticks[next], on, motion) - now) /
                                        (ticks[next].time - ticks[i].time));
  }
  const double slowest =
      std::min(*ramp.acceleration, ramp.deceleration.value_or(*ramp.acceleration));
  const double growth = ramp.jerk ? 4 * slowest / *ramp.jerk : 0;
  const double longest = 2 * (distance / *ramp.velocity_diff + 3 * velocity / slowest + growth);
  return first([&](const PlayedTick& tick) {
    return tick.time > longest && tick.tick - ticks.front().tick > cycles;
  });
}

/// Number of ticks of the ramp: those before the first three ticks in a row on the table, at most
/// longest_ramp(). (The correction may cross zero in one tick, and may begin there.)
std::size_t ramp_ticks(const std::vector<PlayedTick>& ticks, const OnMotion& on,
                       const Designed& designed, const DesignedMotion& motion) {
  const std::size_t longest = longest_ramp(ticks, on, designed, motion);
  const double limit = rounding(ticks, on, motion);
  std::size_t in_a_row = 0;
  for (std::size_t i = 0; i < ticks.size() && i < longest + ticks_on_table; ++i) {
    in_a_row = std::abs(correction_at(ticks[i], on, motion)) <= limit ? in_a_row + 1 : 0;
    if (in_a_row == ticks_on_table) return i + 1 - ticks_on_table;
  }
  return longest;
}

/// The shift of a slave that is `shift` from its cam at the end of the motion: whole slave periods, if
/// there is one and the slave does not begin at its own position; otherwise this distance.
double permitted_shift(double shift, const CouplingSpec& coupling) {
  const bool own = coupling.start == StartMode::relative || !coupling.slave_absolute;
  const double period = own ? 0 : coupling.slave_period.value_or(0);
  return period > 0 ? std::round(shift / period) * period : shift;
}

/// Compares the ticks after the ramp, with the slave shifted as at the end of the motion.
/// nullopt: too few ticks come after the ramp.
std::optional<Deviations> compare_after_ramp(const std::vector<PlayedTick>& ticks, OnMotion on,
                                             const Designed& designed,
                                             const DesignedMotion& motion) {
  const double last = own_position(ticks.back(), on.corrected);
  on.shift = permitted_shift(last - motion.table(on.at(ticks.back())).position, *designed.ramp);
  const std::size_t ramp = ramp_ticks(ticks, on, designed, motion);
  if (ramp + ticks_on_table > ticks.size()) return std::nullopt;
  const std::vector<PlayedTick> after(ticks.begin() + static_cast<std::ptrdiff_t>(ramp),
                                      ticks.end());
  Deviations result = compare(after, on, motion, designed.tolerance);
  result.left_out = ramp;
  result.shift = on.shift;
  return result;
}

/// The place of a tick on the motion over time.
OnMotion over_time(const Designed& designed) {
  return {.at = [&](const PlayedTick& tick) { return std::min(tick.time, designed.duration); },
          .counted = [](const PlayedTick& tick) { return tick.clock; }};
}

/// The places of a tick on the cam over the master of the log: with the zero of the master, and
/// with the first tick as zero of master and slave.
std::vector<OnMotion> over_master(const std::vector<PlayedTick>& ticks, const Designed& designed) {
  const PlayedTick& first = ticks.front();
  if (!designed.over_master.table || !first.master) return {};
  const bool corrected = std::any_of(ticks.begin(), ticks.end(),
                                     [](const PlayedTick& tick) { return tick.correction != 0; });
  const double shift = own_position(first, corrected) - designed.over_master.table(0).position;
  std::vector<OnMotion> all;
  for (const auto& [origin, by] : {std::pair{0.0, 0.0}, {*first.master, shift}})
    all.push_back(
        {.at = [origin = origin](const PlayedTick& tick) { return *tick.master - origin; },
         .shift = by,
         .corrected = corrected,
         .counted = [](const PlayedTick& tick) { return *tick.master; }});
  return all;
}

/// Compares over time, or, if the positions do not agree, over the master of the log. Without a table
/// over time, returns the smallest deviations over the master.
Deviations compare_all(const std::vector<PlayedTick>& ticks, const Designed& designed) {
  std::optional<Deviations> least;
  if (designed.over_time.table)
    least = compare(ticks, over_time(designed), designed.over_time, designed.tolerance);
  if (least && least->ok()) return *least;
  for (const OnMotion& on : over_master(ticks, designed)) {
    Deviations result = compare(ticks, on, designed.over_master, designed.tolerance);
    result.live = true;
    if (result.ok()) return result;
    const bool is_less = least && least->live && result.table.error < least->table.error;
    if (!least || is_less) least = result;
  }
  return *least;
}

/// Compares the ticks after the ramp, over time and over the master of the log. Returns the
/// deviations that agree, or else the smallest ones.
Deviations compare_ramped(const std::vector<PlayedTick>& ticks, const Designed& designed) {
  std::optional<Deviations> least;
  const auto take = [&](const OnMotion& on, const DesignedMotion& motion, bool live) {
    auto result = compare_after_ramp(ticks, on, designed, motion);
    if (!result) return;
    result->live = live;
    if (!least || (result->ok() && !least->ok()) ||
        (result->ok() == least->ok() && result->table.error < least->table.error))
      least = result;
  };
  const std::vector<OnMotion> places = over_master(ticks, designed);
  for (const OnMotion& on : places) take(on, designed.over_master, true);
  if (places.empty() && designed.ramp->start != StartMode::ramp_in_distance)
    take(over_time(designed), designed.over_time, false);
  if (least) return *least;
  throw InputError(
      "", "",
      places.empty() && designed.ramp->start == StartMode::ramp_in_distance
          ? "contains no live master, over which the ramp of [coupling] ends: give the log of a "
            "motion that `jounce stream --live` has sent"
          : "cannot be compared with the table: all " + std::to_string(ticks.size()) +
                " ticks of the motion may belong to the ramp of [coupling]: give the log of a "
                "longer motion");
}

void add(Report& report, const char* rule, const Deviation& deviation, const char* advice) {
  const auto& [error, where, limit] = deviation;
  const bool broken = !(error <= limit);
  report.findings.push_back({.rule = rule,
                             .axis = "",
                             .quantity = "error of the position",
                             .where = where,
                             .value = error,
                             .limit = limit,
                             .margin = limit > 0 ? (limit - error) / limit : 0,
                             .broken = broken,
                             .segment = std::nullopt,
                             .advice = broken ? advice : ""});
}

/// Reports the gaps of the log: in the middle and, for a motion with a duration, at its end.
void add_gap(Report& report, const std::vector<PlayedTick>& ticks, const Designed& designed,
             bool live) {
  const auto add = [&](const char* rule, const char* quantity, double where, double value,
                       double bound, bool broken, const char* advice, const char* unit) {
    report.findings.push_back({.rule = rule,
                               .axis = "",
                               .quantity = quantity,
                               .where = where,
                               .value = value,
                               .limit = bound,
                               .margin = bound > 0 ? (bound - value) / bound : -1,
                               .broken = broken,
                               .segment = std::nullopt,
                               .advice = broken ? advice : "",
                               .unit = unit});
  };
  std::int64_t gap = 0;
  double gap_at = 0;
  for (std::size_t i = 1; i < ticks.size(); ++i)
    if (const auto left_out = ticks[i].tick - ticks[i - 1].tick - 1; left_out > gap) {
      gap = left_out;
      gap_at = ticks[i - 1].time;
    }
  const std::int64_t span = ticks.back().tick - ticks.front().tick;
  const double cycle = span > 0 ? ticks.back().time / static_cast<double>(span) : designed.duration;
  add("played/gap", "ticks left out", gap_at, static_cast<double>(gap), 0.1 / cycle,
      static_cast<double>(gap) * cycle > 0.1,
      "rows are missing from the log, or the executor was suspended", "ticks");
  if (live) {
    if (ticks.back().fault)
      add("played/fault", "faults", ticks.back().time, 1, 0, true,
          "the column fault of the log names the fault", "");
    return;
  }
  // The last tick of a motion may lie one cycle before its end.
  const double missing = std::max(0.0, designed.duration - ticks.back().time);
  add("played/complete", "time missing at the end", ticks.back().time, missing, cycle,
      missing > cycle * (1 + rounded_input), "the motion was stopped, or the log ends early", "s");
}

/// The column of the correction of a slave: one in the unit of the master is part of the master.
std::optional<std::size_t> correction_of_slave(const std::vector<std::string_view>& header) {
  const auto unit = [&](std::optional<std::size_t> at) {
    return at ? header[*at].substr(std::min(header[*at].find(' '), header[*at].size())) : "";
  };
  const auto found = find_column(header, "correction");
  const bool of_slave = found && unit(found) == unit(find_column(header, "position"));
  return of_slave ? found : std::nullopt;
}

/// True if the slave engages with a ramp.
bool is_ramp(StartMode start) {
  return start != StartMode::absolute && start != StartMode::relative;
}

/// The advice for a motion that is not that of the table.
const char* other_table(const Designed& designed) {
  if (designed.cutter)
    return "if the axis has a cutter, it plays a plan of cuts and not this table: its cuts come "
           "where the plan places them on the web, and this comparison does not include them. "
           "Otherwise the executor played another table than the one designed, a halt, a hold or a "
           "fault changed the motion (columns held and fault of the log), or the axis followed a "
           "live master with a start mode that is not in this spec, a phase shift or a motion on "
           "top, which this comparison does not include";
  if (designed.over_master.table)
    return "the executor played another table than the one designed, a halt, a hold, an override "
           "or a fault changed the motion (columns held and fault of the log), or the axis "
           "followed "
           "a live master with a start mode that is not in this spec, a phase shift or a motion on "
           "top, which this comparison does not include";
  return "the executor played another table than the one designed, or a halt, a hold, an override "
         "or a fault changed the motion (columns held and fault of the log)";
}

}  // namespace

std::vector<PlayedTick> read_played(const std::string& csv, const std::string& name) {
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  LogPlace place{name, 1};
  const auto header = csv_cells(line);
  const std::size_t number_of_tick = column(header, "tick", place);
  const std::size_t time = column(header, "time", place);
  const std::size_t position = column(header, "position", place);
  const std::size_t job = column(header, "job", place);
  const bool live = find_column(header, "profile").has_value();
  const auto correction_column = correction_of_slave(header);
  const auto master_column = live ? find_column(header, "master") : std::nullopt;
  const auto fault_column = find_column(header, "fault");
  const std::size_t width = header.size();

  std::vector<PlayedTick> ticks;
  std::string current = "0";
  double start = 0;
  std::int64_t number_of_job = 0;
  for (std::string row; std::getline(lines, row);) {
    ++place.line;
    const auto row_cells = csv_cells(row);
    if (row_cells.size() != width) place.fail("row", row, "must have as many values as the header");
    const auto tick = static_cast<std::int64_t>(real(row_cells[number_of_tick], "tick", place));
    const double now = real(row_cells[time], "time", place);
    const double at = real(row_cells[position], "position", place);
    const auto master = master_column
                            ? std::optional(real(row_cells[*master_column], "master", place))
                            : std::nullopt;
    if (row_cells[job] != "0")
      number_of_job = static_cast<std::int64_t>(real(row_cells[job], "job", place));
    if (row_cells[job] != current && row_cells[job] != "0") {  // another motion begins
      ticks.clear();
      start = now;
    }
    const bool has_ended = row_cells[job] == "0" && current != "0";
    current = row_cells[job];
    if (has_ended && !ticks.empty())
      ticks.back().fault = fault_column && row_cells[*fault_column] != "none";
    // A late cycle may skip the end: the first tick at rest then shows it.
    const bool shows_end = has_ended && !ticks.empty() && tick > ticks.back().tick + 1;
    const double correction =
        correction_column ? real(row_cells[*correction_column], "correction", place) : 0;
    if (current != "0" || shows_end)
      ticks.push_back({tick, now - start, at, now, master, correction, false, number_of_job});
  }
  if (ticks.empty())
    throw InputError(
        "", "", "contains no motion of a table: give the log of the axis that played the table")
        .at(name);
  return ticks;
}

Played compare_played(const std::vector<PlayedTick>& ticks, const Designed& designed) {
  assert(!ticks.empty() &&
         (designed.over_time.table || (designed.over_master.table && ticks.front().master)));
  const bool ramped = designed.ramp && is_ramp(designed.ramp->start);
  const Deviations compared =
      ramped ? compare_ramped(ticks, designed) : compare_all(ticks, designed);
  Played played{.ticks = ticks.size() - compared.left_out,
                .left_out = compared.left_out,
                .shift = std::abs(compared.shift) <= compared.table.limit ? 0 : compared.shift,
                .job = ticks.front().job,
                .start = ticks.front().clock,
                .live = compared.live,
                .table = compared.table,
                .curve = compared.curve,
                .report = {}};
  add(played.report, "played/table", played.table, other_table(designed));
  if (played.curve)
    add(played.report, "played/curve", *played.curve,
        "the executor played another table, or the table exceeds its tolerance");
  add_gap(played.report, ticks, designed, played.live);
  sort(played.report);
  return played;
}

}  // namespace jounce
