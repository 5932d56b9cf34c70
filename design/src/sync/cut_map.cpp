// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/cut_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "jounce/base/file.hpp"
#include "jounce/base/units.hpp"
#include "jounce/design/make.hpp"
#include "jounce/report/report_text.hpp"

namespace jounce {
namespace {

std::vector<double> grid(double from, double to, std::size_t steps) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < steps; ++i)
    lengths.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(steps - 1));
  return lengths;
}

/// The number as text; "" if nothing limits the speed or if no cut is possible.
std::string finite(double value) {
  return std::isfinite(value) && value > 0 ? number(value) : "";
}

}  // namespace

std::string CutMap::speed_unit() const {
  return rate_unit(spec.units.x, spec.time_unit, 1);
}

CutLimits cut_limits(const Spec& spec, const std::optional<double>& line_speed) {
  const double own = spec.master ? spec.master->velocity : std::numeric_limits<double>::infinity();
  const Limits& slave = spec.slave;
  const bool none = !slave.velocity && !slave.acceleration && !slave.jerk;
  if (none && std::isinf(own) && !line_speed)
    throw spec.document.located(InputError(
        "limits.slave", "", "is missing: without a limit, the speed of the line is unlimited"));
  return {slave, line_speed.value_or(own)};
}

CutMap cut_map(Spec spec, CutLengths cuts, const CutLimits& limits, double from, double to,
               std::size_t steps) {
  const CutSpeedOfLength fastest = [&](double length) { return cuts.fastest(length, limits); };
  std::vector<CutSpeed> speeds = cut_length_map(fastest, grid(from, to, steps));
  std::vector<LimitChange> changes = limit_changes(fastest, speeds);
  const double running =
      spec.master ? std::min(spec.master->velocity, limits.line_speed) : limits.line_speed;
  std::optional<double> shortest;
  if (std::isfinite(running)) shortest = cuts.shortest(running, limits);
  const double per_minute = 60 / seconds_per_unit(spec);
  return {std::move(spec),    std::move(cuts), limits,   std::move(speeds),
          std::move(changes), running,         shortest, per_minute};
}

namespace {

/// A positive quantity; none if its text is empty.
std::optional<double> positive(const char* key, const std::string& text, const std::string& unit) {
  if (text.empty()) return std::nullopt;
  try {
    const double value = quantity(text, unit);
    require_positive(key, value);
    return value;
  } catch (const InputError& error) {
    throw InputError(key, error.key() == key ? error.value() : text, error.rule());
  }
}

}  // namespace

CutMap cut_map(const std::string& path, const CutMapTexts& texts) {
  Spec spec = parse_spec(read_file(path), path);
  CutLengths cuts = cut_lengths(spec);
  const double from = positive("from", texts.from, spec.units.x).value_or(cuts.from);
  const double to = positive("to", texts.to, spec.units.x).value_or(cuts.to);
  if (!(to > from) && texts.to.empty())
    throw InputError("from", number(from) + " " + spec.units.x,
                     "must be less than " + rounded(to) + " " + spec.units.x +
                         ", the default of --to: add --to, or give a lower --from");
  if (!(to > from))
    throw InputError("to", number(to) + " " + spec.units.x,
                     "must be greater than --from = " + number(from) + " " + spec.units.x);
  const CutLimits limits = cut_limits(
      spec, positive("line_speed", texts.line_speed, rate_unit(spec.units.x, spec.time_unit, 1)));
  return cut_map(std::move(spec), std::move(cuts), limits, from, to, texts.steps);
}

std::string limit_word(const std::string& limit) {
  return limit.empty() ? "none" : limit;
}

std::string to_csv(const CutMap& map) {
  const std::string& m = map.spec.units.x;
  std::string text = fmt::format("# jounce map of {}\n", map.spec.document.name);
  for (const auto& [length, name] : map.cuts.marks)
    text += fmt::format("# {}: {} {}\n", name, number(length), m);
  if (const auto& master = map.spec.master; master && master->acceleration.value_or(0) > 0)
    text += fmt::format(
        "# for a line at constant speed: `jounce check` also includes the acceleration of "
        "[master], "
        "{} {}, with which the speeds are lower\n",
        rounded(*master->acceleration), rate_unit(m, map.spec.time_unit, 2));
  if (map.shortest)
    text += fmt::format("# shortest at {} {}: {} {}\n", rounded(map.running), map.speed_unit(),
                        number(*map.shortest), m);
  if (map.cuts.turns_back < map.speeds.back().length)
    text += fmt::format(
        "# reversal: above {} {}, the knife would reverse between two cuts: add dwell = true to "
        "[knife]\n",
        number(map.cuts.turns_back), m);
  for (const LimitChange& change : map.changes)
    text += fmt::format("# from {} {}: {}\n", number(change.length), m, limit_word(change.after));
  text += fmt::format("cut_length [{}],line_speed [{}],cuts [1/min],limit\n", m, map.speed_unit());
  for (const CutSpeed& s : map.speeds)
    text += fmt::format("{},{},{},{}\n", number(s.length), finite(s.speed),
                        finite(s.speed / s.length * map.per_minute), limit_word(s.limit));
  return text;
}

}  // namespace jounce
