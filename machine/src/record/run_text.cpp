// SPDX-License-Identifier: Apache-2.0
#include "jounce/machine/detail/run_text.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "jounce/base/detail/printable.hpp"
#include "jounce/command/cause.hpp"
#include "jounce/machine/machine_parts.hpp"
#include "jounce/profiles/detail/six_digits.hpp"

namespace jounce {
namespace {

std::string axis_text(const AxisSummary& axis, bool alone) {
  const std::string whose = alone ? "" : axis.name + ": ";
  std::string text = fmt::format("{}{} finished, {} stopped; position {:.9g}{}\n", whose,
                                 counted(axis.finished, "motion"), axis.stopped, axis.position,
                                 axis.unit.empty() ? "" : " " + axis.unit);
  if (axis.fault != Cause::none)
    text += fmt::format("{}fault: {}: {}\n", whose, name(axis.fault), meaning(axis.fault));
  return text;
}

/// When the ticks began, and how long they took.
std::string timing(const ExecutorSummary& summary) {
  const double late = upper_bound(summary.lateness, 0.999);
  const double took = upper_bound(summary.computing, 0.999);
  const std::string began =
      std::isinf(late) ? "some ticks began more than 16384 us late"
                       : fmt::format("99.9 % of the ticks began within {} us of their time", late);
  return began + (std::isinf(took) ? ", and some took more than 16384 us"
                                   : fmt::format(", and 99.9 % took at most {} us", took));
}

}  // namespace

namespace {

/// "; the positions are those of the specs, not measured: feeder 0 mm": an axis may have stood
/// elsewhere when its executor ended.
std::string assumed_text(const std::vector<ExecutorOptions>& axes) {
  std::vector<std::string> all;
  for (const auto& axis : axes)
    if (!axis.group && axis.drive)
      all.push_back(fmt::format("{} {} {}", axis.receiver.executor, six_digits(axis.axis.position),
                                axis.units.position));
  if (all.empty()) return "";
  return fmt::format("; {} of the spec, not measured: {}",
                     all.size() == 1 ? "the position is that" : "the positions are those",
                     fmt::join(all, ", "));
}

}  // namespace

std::string up_text(const std::vector<ExecutorOptions>& axes, bool enabled) {
  std::vector<std::string> on;
  std::vector<std::string> off;
  for (const auto& axis : axes)
    (enabled && axis.enable ? on : off).push_back(axis.receiver.executor);
  std::string text;
  if (!on.empty())
    text = fmt::format("{}: up, enabled{}", fmt::join(on, ", "), off.empty() ? "" : "; ");
  if (!off.empty())
    text += fmt::format("{}: up, disabled; enable {}: jounce order {} enable", fmt::join(off, ", "),
                        off.size() == 1 ? "it with" : "each, in this order",
                        fmt::join(off, " enable, jounce order "));
  return text + assumed_text(axes);
}

std::string summary_text(const ExecutorSummary& summary) {
  std::string text;
  for (const AxisSummary& axis : summary.axes) text += axis_text(axis, summary.axes.size() == 1);
  const CycleCounts& cycle = summary.cycle;
  text += fmt::format("{}, {} of them late; largest delay {:.3f} ms; {}\n",
                      counted(cycle.ticks, "tick"), cycle.late,
                      static_cast<double>(cycle.latest_ns) * 1e-6, timing(summary));
  if (!summary.realtime.empty()) text += summary.realtime + "\n";
  return text;
}

std::string summary_json(const ExecutorSummary& summary) {
  using Json = nlohmann::ordered_json;
  Json axes = Json::array();
  for (const AxisSummary& axis : summary.axes)
    axes.push_back({{"name", axis.name},
                    {"finished", axis.finished},
                    {"stopped", axis.stopped},
                    {"fault", name(axis.fault)},
                    {"position", axis.position}});
  const Json document{{"axes", axes},
                      {"realtime", summary.realtime},
                      {"ticks", summary.cycle.ticks},
                      {"late", summary.cycle.late},
                      {"skipped", summary.cycle.skipped},
                      {"latest_ns", summary.cycle.latest_ns},
                      {"computed_ns", summary.cycle.computed_ns},
                      {"lateness_us", summary.lateness},
                      {"computing_us", summary.computing},
                      {"log_lost", summary.cycle.lost},
                      {"record_lost", summary.record_lost}};
  return document.dump();
}

std::vector<std::string> missing_parts(const ExecutorSummary& summary, const std::string& log) {
  if (!summary.lost_name.empty())
    return {"name_taken: another executor on this --url has the name " + summary.lost_name +
            ": this executor stopped its axes and ended"};
  std::vector<std::string> missing;
  if (!log.empty() && summary.cycle.lost > 0)
    missing.push_back(fmt::format("the log lacks {}: they could not be written in time",
                                  counted(summary.cycle.lost, "tick")));
  for (const AxisSummary& axis : summary.axes)
    if (!log.empty() && axis.log_truncated)
      missing.push_back(fmt::format("the log of {} is cut off: {}.truncated", axis.name,
                                    printable(log_of(log, axis.name, summary.axes.size()))));
  if (missing.empty() && !summary.record_trouble.empty())
    missing.push_back("the record is incomplete: " + printable(summary.record_trouble));
  else if (missing.empty() && summary.record_lost > 0)
    missing.push_back(
        fmt::format("the record is incomplete: {} cycles are missing", summary.record_lost));
  return missing;
}

}  // namespace jounce
