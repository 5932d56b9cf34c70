// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "jounce/base/file.hpp"
#include "jounce/base/units.hpp"
#include "jounce/design/cut_lengths.hpp"
#include "jounce/report/report_text.hpp"

#include "cli/common/picture.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct MapArguments {
  std::string file;
  std::string from;
  std::string to;
  std::size_t steps = 91;
  std::string line_speed;
  std::string output = "-";
};

struct Map {
  Spec spec;
  CutLengths cuts;
  CutLimits limits;
  std::vector<CutSpeed> speeds;
  std::vector<LimitChange> changes;
  double running = 0;              ///< the line's speed: of [master], or the most it does
  std::optional<double> shortest;  ///< at that speed
  double per_minute = 60;          ///< cuts in a minute of one in a time unit
};

double option(const char* name, const std::string& text, const std::string& unit, double fallback) {
  if (text.empty()) return fallback;
  double value = 0;
  try {
    value = quantity(text, unit);
  } catch (const InputError& error) {
    throw InputError(name, error.value(), error.rule());
  }
  require_positive(name, value);
  return value;
}

std::string speed_unit(const Spec& spec) {
  return rate_unit(spec.units.x, spec.time_unit, 1);
}

CutLimits limits_of(const Spec& spec, const MapArguments& options) {
  const double own = spec.master ? spec.master->velocity : std::numeric_limits<double>::infinity();
  const Limits& slave = spec.slave;
  const bool none = !slave.velocity && !slave.acceleration && !slave.jerk;
  if (none && std::isinf(own) && options.line_speed.empty())
    throw spec.document.located(InputError(
        "limits.slave", "", "is missing: without a limit, the speed of the line is unlimited"));
  return {slave, option("--line-speed", options.line_speed, speed_unit(spec), own)};
}

std::vector<double> grid(double from, double to, std::size_t steps) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < steps; ++i)
    lengths.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(steps - 1));
  return lengths;
}

Map map_of(const MapArguments& options) {
  Spec spec = parse_spec(read_file(options.file), options.file);
  CutLengths cuts = cut_lengths(spec);
  const double from = option("--from", options.from, spec.units.x, cuts.from);
  const double to = option("--to", options.to, spec.units.x, cuts.to);
  if (!(to > from)) throw InputError("--to", to, "must be greater than --from, " + number(from));
  const CutLimits limits = limits_of(spec, options);
  const CutSpeedOfLength fastest = [&](double length) { return cuts.fastest(length, limits); };
  std::vector<CutSpeed> speeds = cut_length_map(fastest, grid(from, to, options.steps));
  std::vector<LimitChange> changes = limit_changes(fastest, speeds);
  const double running =
      spec.master ? std::min(spec.master->velocity, limits.line_speed) : limits.line_speed;
  std::optional<double> shortest;
  if (std::isfinite(running)) shortest = cuts.shortest(running, limits);
  const double per_minute = 60 / seconds_per_unit(spec);
  return {std::move(spec),    std::move(cuts), limits,   std::move(speeds),
          std::move(changes), running,         shortest, per_minute};
}

/// The one short word that table, legend and strip have for it.
std::string told(const std::string& limit) {
  return limit.empty() ? "none" : limit;
}

/// No number where nothing limits the speed, or no cut can be made.
std::string finite(double value) {
  return std::isfinite(value) && value > 0 ? number(value) : "";
}

constexpr const char* needs_dwell = "reverses: needs dwell";

std::string csv_of(const Map& map) {
  const std::string& m = map.spec.units.x;
  std::string text = fmt::format("# jounce map of {}\n", map.spec.document.name);
  for (const auto& [length, name] : map.cuts.marks)
    text += fmt::format("# {}: {} {}\n", name, number(length), m);
  if (map.shortest)
    text += fmt::format("# shortest at {} {}: {} {}\n", rounded(map.running), speed_unit(map.spec),
                        number(*map.shortest), m);
  if (map.cuts.turns_back < map.speeds.back().length)
    text += fmt::format("# reversal: {}\n", needs_dwell);
  for (const LimitChange& change : map.changes)
    text += fmt::format("# from {} {}: {}\n", number(change.length), m, told(change.after));
  text +=
      fmt::format("cut_length [{}],line_speed [{}],cuts [1/min],limit\n", m, speed_unit(map.spec));
  for (const CutSpeed& s : map.speeds)
    text += fmt::format("{},{},{},{}\n", number(s.length), finite(s.speed),
                        finite(s.speed / s.length * map.per_minute), told(s.limit));
  return text;
}

/// The map's points, and those at which a limit takes over or that are marked, ascending.
std::vector<CutSpeed> points_of(const Map& map) {
  std::vector<CutSpeed> all = map.speeds;
  const auto add = [&](double length) {
    if (length > all.front().length && length < map.speeds.back().length)
      all.push_back(map.cuts.fastest(length, map.limits));
  };
  for (const LimitChange& change : map.changes) {
    add(change.length * (1 - 1e-9));
    add(change.length);
  }
  for (const auto& mark : map.cuts.marks) add(mark.length);
  if (map.shortest) add(*map.shortest);
  std::sort(all.begin(), all.end(),
            [](const CutSpeed& a, const CutSpeed& b) { return a.length < b.length; });
  return all;
}

/// One line for each limit, coloured and named by it, joined where the next one takes over.
std::vector<Series> lines_of(const std::vector<CutSpeed>& points, double per_minute, bool rate) {
  std::vector<Series> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CutSpeed& p = points[i];
    // Where there is no cut there is no line: a gap at the end of another is all that it takes.
    const bool drawn = p.speed > 0 || all.empty();
    const std::string label = drawn ? told(p.limit) : all.back().label;
    auto own = std::find_if(all.begin(), all.end(),
                            [&](const Series& series) { return series.label == label; });
    if (own == all.end()) own = all.insert(all.end(), {label, {}, {}, Style::line});
    const bool resumed = i > 0 && points[i - 1].limit != p.limit && !own->x.empty();
    if (resumed) {
      own->x.push_back(p.length);
      own->y.push_back(std::nan(""));
    }
    own->x.push_back(p.length);
    const double shown = p.speed > 0 ? p.speed : std::nan("");
    own->y.push_back(rate ? shown / p.length * per_minute : shown);
  }
  return all;
}

std::vector<Marker> markers_of(const Map& map) {
  std::vector<Marker> markers;
  const auto add = [&](double length, const std::string& name) {
    if (length < map.speeds.front().length || length > map.speeds.back().length) return;
    const CutSpeed at = map.cuts.fastest(length, map.limits);
    if (!std::isfinite(at.speed) || at.speed == 0) return;
    markers.push_back({length, at.speed, fmt::format("{} {}", name, rounded(length)),
                       fmt::format("{}: {} {}", name, number(length), map.spec.units.x)});
  };
  if (map.shortest) add(*map.shortest, fmt::format("shortest at {}:", rounded(map.running)));
  for (const auto& mark : map.cuts.marks) add(mark.length, mark.name);
  return markers;
}

/// Where which limit binds, for the strip above.
std::vector<Shade> strip_of(const Map& map) {
  std::vector<Shade> strip;
  double from = map.speeds.front().length;
  std::string limit = map.speeds.front().limit;
  for (const LimitChange& change : map.changes) {
    strip.push_back({from, change.length, told(limit)});
    from = change.length;
    limit = change.after;
  }
  strip.push_back({from, map.speeds.back().length, told(limit)});
  return strip;
}

Figure figure_of_map(const Map& map) {
  const std::vector<CutSpeed> points = points_of(map);
  Figure figure;
  figure.title = map.spec.name.empty() ? map.spec.document.name : map.spec.name;
  figure.x_label = "cut length [" + map.spec.units.x + "]";
  figure.strips = {strip_of(map)};
  if (const double end = map.speeds.back().length; map.cuts.turns_back < end)
    figure.strips.push_back(
        {{std::max(map.cuts.turns_back, map.speeds.front().length), end, needs_dwell}});
  Panel speed;
  speed.y_label = "line speed [" + speed_unit(map.spec) + "]";
  speed.series = lines_of(points, map.per_minute, false);
  speed.markers = markers_of(map);
  Panel rate;
  rate.y_label = "cuts [1/min]";
  rate.series = lines_of(points, map.per_minute, true);
  for (const auto& change : map.changes) figure.knots.push_back(change.length);
  figure.panels = {std::move(speed), std::move(rate)};
  return figure;
}

int run_map(const MapArguments& options) {
  require_other_file(options.file, options.output);
  const Map map = map_of(options);
  const bool picture = options.output.ends_with(".svg") || options.output.ends_with(".png");
  if (picture)
    write_picture(options.output, figure_of_map(map));
  else
    write_file(options.output, csv_of(map));
  return fine;
}

}  // namespace

void add_map(CommandLine& line) {
  const auto options = std::make_shared<MapArguments>();
  const Verb verb =
      line.verb("map", "Show the fastest line for each cut length, and the limit that binds",
                "jounce map knife.toml --from 100 --to 1000 -o map.png");
  verb.option("FILE", options->file, "Spec of a knife or a shear; - is standard input").required();
  verb.option("--from", options->from, "Shortest cut; default: the whole range of interest");
  verb.option("--to", options->to, "Longest cut");
  verb.option("--steps", options->steps, "Number of lengths, both ends included")
      .check(whole(2, 100000));
  verb.option("--line-speed", options->line_speed,
              "Speed of the line; default: the velocity of [master], or line_speed of a shear");
  verb.option("-o,--output", options->output, ".csv, .svg or .png; - is CSV on standard output");
  verb.work([options] { return run_map(*options); });
}

}  // namespace jounce::cli
