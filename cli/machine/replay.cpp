// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/replay.hpp"

#include <algorithm>
#include <deque>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/printable.hpp"
#include "jounce/executor/log.hpp"
#include "jounce/plot/figure.hpp"
#include "jounce/profiles/error.hpp"

#include "cli/common/picture.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct ReplayArguments {
  std::string file;
  std::string axis;
  std::string plot;
  std::string csv;
  std::optional<std::size_t> last;
  bool json = false;
};

constexpr std::size_t default_cycles = 5000;  // drawn and listed without --last

/// The ticks of one axis, the last ones.
class Ticks {
 public:
  Ticks(std::size_t axis, std::size_t most) : axis_(axis), most_(most) {}

  void add(const RecordedCycle& cycle) {
    if (cycle.axis != axis_) return;
    kept_.push_back(cycle.tick);
    if (kept_.size() > most_) kept_.pop_front();
  }
  [[nodiscard]] const std::deque<Tick>& kept() const { return kept_; }

 private:
  std::size_t axis_;
  std::size_t most_;
  std::deque<Tick> kept_;
};

Figure figure_of(const std::deque<Tick>& ticks, const RecordedAxis& axis) {
  const std::string u = axis.units.position.empty() ? "u" : axis.units.position;
  Series set{.label = "set"};
  Series actual{.label = "actual"};
  Series velocity{.label = "velocity"};
  Series error{.label = "following error"};
  Series torque{.label = "torque"};
  set.style = Style::under;
  Figure figure{.title = axis.name, .x_label = "time [s]"};
  for (const Tick& tick : ticks) {
    for (Series* s : {&set, &actual, &velocity, &error, &torque}) s->x.push_back(tick.time);
    set.y.push_back(tick.position);
    actual.y.push_back(tick.actual_position);
    velocity.y.push_back(tick.velocity);
    error.y.push_back(tick.following_error);
    torque.y.push_back(tick.torque);
  }
  for (std::size_t i = 1; i < ticks.size(); ++i)
    if (ticks[i].fault != Cause::none && ticks[i - 1].fault == Cause::none) {
      figure.knots.push_back(ticks[i].time);
      figure.title +=
          std::string(": ") + name(ticks[i].fault) + " at tick " + std::to_string(ticks[i].tick);
    }
  const auto told = [](const Series& s) {
    return std::any_of(s.y.begin(), s.y.end(), [](double y) { return y == y; });
  };
  figure.panels = {{.y_label = "position [" + u + "]", .series = {set}},
                   {.y_label = "velocity [" + u + "/s]", .series = {velocity}}};
  if (told(actual)) figure.panels[0].series.push_back(actual);
  if (told(error))
    figure.panels.push_back({.y_label = "following error [" + u + "]", .series = {error}});
  if (told(torque)) figure.panels.push_back({.y_label = "torque [rated]", .series = {torque}});
  return figure;
}

/// The axis that is drawn and listed: the first one, unless named. It needs a pass of its own: names and units
/// come first in a record, but the whole file must be a record.
RecordedAxis axis_of(const std::string& file, const std::string& wanted) {
  std::ifstream in(file, std::ios::binary);
  const Replay names = replay(in, file);
  for (const RecordedAxis& axis : names.axes)
    if (wanted.empty() || axis.name == wanted) return axis;
  throw InputError("--axis", wanted, "is not an axis of the record").at(file);
}

/// The name of the axis, or the master, that came out otherwise.
const std::string& whose(const Replay& r) {
  const Replay::Difference& d = *r.difference;
  return d.of_master ? r.masters[d.axis].name : r.axes[d.axis].name;
}

void print(const Replay& r, const std::string& file) {
  fmt::print("{}: {} {}, {} cycles, ticks {} to {}\n", printable(file), r.axes.size(),
             r.axes.size() == 1 ? "axis" : "axes", r.cycles, r.first_tick.value_or(0), r.last_tick);
  for (const Replay::Master& master : r.masters)
    fmt::print("master {}: {} cycles, lost in {}\n", master.name, master.cycles, master.lost);
  if (r.difference) {
    const Replay::Difference& d = *r.difference;
    fmt::print("differs: {} {}, tick {}: {} is {} in the record, {} replayed\n",
               d.of_master ? "master" : "axis", whose(r), d.tick, d.what.field,
               number(d.what.recorded), number(d.what.replayed));
  } else if (r.compared > 0) {
    fmt::print("replayed: {} cycles, identical to the last bit\n", r.compared);
  }
  if (!r.shorter.empty()) fmt::print("not replayed to its end: {}\n", r.shorter);
}

nlohmann::ordered_json json_of(const Replay& r) {
  nlohmann::ordered_json axes = nlohmann::ordered_json::array();
  for (const RecordedAxis& axis : r.axes) axes.push_back(axis.name);
  nlohmann::ordered_json document{{"axes", axes},           {"cycles", r.cycles},
                                  {"compared", r.compared}, {"same", r.same()},
                                  {"shorter", r.shorter},   {"last_tick", r.last_tick}};
  for (const Replay::Master& master : r.masters)
    document["masters"].push_back(
        {{"name", master.name}, {"cycles", master.cycles}, {"lost", master.lost}});
  if (r.difference)
    document["difference"] = {{r.difference->of_master ? "master" : "axis", whose(r)},
                              {"tick", r.difference->tick},
                              {"field", r.difference->what.field},
                              {"recorded", r.difference->what.recorded},
                              {"replayed", r.difference->what.replayed}};
  return document;
}

void require_others(const ReplayArguments& options) {
  for (const auto& [option, path] : {std::pair{"--plot", options.plot}, {"--csv", options.csv}})
    if (!path.empty()) require_other_file(options.file, path);
  if (!options.plot.empty()) require_picture("--plot", options.plot);
}

int run_replay(const ReplayArguments& options) {
  require_others(options);
  std::ifstream in(options.file, std::ios::binary);
  if (!in) throw InputError("FILE", options.file, "cannot be read: does the file exist?");
  const bool shown = !options.plot.empty();
  const bool listed = !options.csv.empty();
  RecordedAxis axis;
  if (shown || listed) axis = axis_of(options.file, options.axis);
  Ticks ticks(axis.axis, options.last.value_or(default_cycles));
  // A list of all of them is written as they come: a record may be longer than memory.
  std::optional<TickLog> csv;
  if (listed) csv.emplace(options.csv, axis.units);
  const Replay result = replay(in, options.file, [&](const RecordedCycle& cycle) {
    if (shown || options.last) ticks.add(cycle);
    if (csv && !options.last && cycle.axis == axis.axis) csv->add(cycle.tick);
  });
  if (csv && options.last)
    for (const Tick& tick : ticks.kept()) csv->add(tick);
  if (csv) csv->close();
  if (shown) write_picture(options.plot, figure_of(ticks.kept(), axis));
  if (options.json)
    fmt::print("{}\n", json_of(result).dump(1));
  else
    print(result, options.file);
  const bool box = !result.axes.front().whole;
  return result.same() || (box && !result.difference) ? fine : finding;
}

}  // namespace

void add_replay(CommandLine& line) {
  const auto options = std::make_shared<ReplayArguments>();
  const Verb verb =
      line.verb("replay", "Execute a recorded run again and compare every cycle bit for bit",
                "jounce replay run.lcmlog --plot run.svg --last 2000");
  verb.option("FILE", options->file, "Record of `jounce run --record`, or a black box").required();
  verb.option("--axis", options->axis, "Name of the axis for --plot and --csv; default: the first");
  verb.option("--plot", options->plot,
              "Picture of set and actual position, following error and torque (.svg, .png)");
  verb.option("--csv", options->csv,
              "Recorded ticks to write, in the format of `jounce run --log`");
  verb.option("--last", options->last,
              "Number of last cycles to write; default: 5000 for --plot, all for --csv")
      .check(whole(1, 10'000'000));
  verb.flag("--json", options->json, "Result as JSON");
  verb.work([options] { return run_replay(*options); });
}

}  // namespace jounce::cli
