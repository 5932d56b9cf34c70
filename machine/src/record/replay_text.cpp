// SPDX-License-Identifier: Apache-2.0
#include "jounce/machine/detail/replay_text.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/detail/printable.hpp"
#include "jounce/command/state.hpp"
#include "jounce/executor/detail/log.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

std::ifstream opened(const std::string& file) {
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw InputError("", "", "cannot be read: " + std::generic_category().message(errno)).at(file);
  std::error_code none;
  if (std::filesystem::is_directory(file, none))
    throw InputError("", "", "is a folder: name a file").at(file);
  if (in.peek() == std::ifstream::traits_type::eof())
    throw InputError("", "", "is empty: name a record of `jounce run --record`").at(file);
  return in;
}

/// An axis of a record, and the feedback that its drive reported.
struct WithFeedback {
  RecordedAxis axis = {};
  bool position = false;
  bool torque = false;
};

WithFeedback axis_in(std::istream& in, const std::string& file, const std::string& wanted) {
  std::set<std::size_t> positions;
  std::set<std::size_t> torques;
  const Replay names = replay(in, file, [&](const RecordedCycle& cycle) {
    if (!std::isnan(cycle.tick.actual_position)) positions.insert(cycle.axis);
    if (!std::isnan(cycle.tick.torque)) torques.insert(cycle.axis);
  });
  for (const RecordedAxis& axis : names.axes)
    if (wanted.empty() || axis.name == wanted)
      return {axis, positions.contains(axis.axis), torques.contains(axis.axis)};
  std::string known;
  for (const RecordedAxis& axis : names.axes) known += (known.empty() ? "" : ", ") + axis.name;
  throw InputError("axis", wanted, "is not an axis of the record, which has: " + known).at(file);
}

/// The name of the axis, or the master, that came out otherwise.
const std::string& whose(const Replay& r) {
  const Replay::Difference& d = *r.difference;
  return d.of_master ? r.masters[d.axis].name : r.axes[d.axis].name;
}

}  // namespace

std::string replay_text(const Replay& r, const std::string& file) {
  std::string text = fmt::format("{}: {} {}, {}, ticks {} to {}\n", printable(file), r.axes.size(),
                                 r.axes.size() == 1 ? "axis" : "axes", counted(r.cycles, "cycle"),
                                 r.first_tick.value_or(0), r.last_tick);
  for (const Replay::Master& master : r.masters)
    text += fmt::format("master {}: {}, lost in {}\n", master.name, counted(master.cycles, "cycle"),
                        master.lost);
  if (!r.damage.empty())
    text += fmt::format("damaged: {}: copy the record again from the machine\n", r.damage);
  if (r.difference) {
    const Replay::Difference& d = *r.difference;
    const auto value = [&](double x) {
      return std::string_view(d.what.field) == "state" ? std::string(name(static_cast<State>(x)))
                                                       : number(x);
    };
    text += fmt::format("differs: {} {}, tick {}: {} is {} in the record, {} replayed\n",
                        d.of_master ? "master" : "axis", whose(r), d.tick, d.what.field,
                        value(d.what.recorded), value(d.what.replayed));
  } else if (r.compared > 0) {
    text += fmt::format("replayed: {}, identical to the last bit\n", counted(r.compared, "cycle"));
  }
  if (r.damage.empty() && !r.has_checksums)
    text +=
        "no checksums: an older jounce wrote this record, so damage to its inputs may be missed\n";
  if (!r.shorter.empty()) text += fmt::format("not replayed to its end: {}\n", r.shorter);
  return text;
}

std::string replay_json(const Replay& r) {
  using Json = nlohmann::ordered_json;
  Json axes = Json::array();
  for (const RecordedAxis& axis : r.axes) axes.push_back(axis.name);
  Json document{{"axes", axes},
                {"cycles", r.cycles},
                {"compared", r.compared},
                {"same", r.same()},
                {"shorter", r.shorter},
                {"last_tick", r.last_tick},
                {"checksums", r.has_checksums},
                {"damage", r.damage}};
  for (const Replay::Master& master : r.masters)
    document["masters"].push_back(
        {{"name", master.name}, {"cycles", master.cycles}, {"lost", master.lost}});
  if (r.difference)
    document["difference"] = {{r.difference->of_master ? "master" : "axis", whose(r)},
                              {"tick", r.difference->tick},
                              {"field", r.difference->what.field},
                              {"recorded", r.difference->what.recorded},
                              {"replayed", r.difference->what.replayed}};
  return document.dump();
}

void LastMotion::add(const RecordedCycle& cycle) {
  if (cycle.axis != axis_) return;
  const Tick& tick = cycle.tick;
  last_.add(cycle);
  const bool moves = tick.velocity != 0 || (tick.fault != Cause::none && fault_ == Cause::none);
  fault_ = tick.fault;
  if (moves)
    rest_ = 0;
  else if (rest_ && ++*rest_ == after)
    motion_ = last_.kept();
}

std::deque<Tick> LastMotion::kept() const {
  if (!rest_) {
    const std::deque<Tick>& all = last_.kept();
    return {all.end() - static_cast<std::ptrdiff_t>(std::min(all.size(), most)), all.end()};
  }
  std::deque<Tick> ticks = *rest_ >= after ? motion_ : last_.kept();
  const auto first =
      std::find_if(ticks.begin(), ticks.end(), [](const Tick& tick) { return tick.velocity != 0; });
  const auto rest = first - ticks.begin();
  if (first != ticks.end() && rest > static_cast<std::ptrdiff_t>(before))
    ticks.erase(ticks.begin(), first - static_cast<std::ptrdiff_t>(before));
  return ticks;
}

Figure tick_figure(const std::deque<Tick>& ticks, const RecordedAxis& axis) {
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
  const auto is_measured = [](const Series& s) {
    return std::any_of(s.y.begin(), s.y.end(), [](double y) { return y == y; });
  };
  figure.panels = {{.y_label = "position [" + u + "]", .series = {set}},
                   {.y_label = "velocity [" + u + "/s]", .series = {velocity}}};
  if (is_measured(actual)) figure.panels[0].series.push_back(actual);
  if (is_measured(error))
    figure.panels.push_back({.y_label = "following error [" + u + "]", .series = {error}});
  if (is_measured(torque))
    figure.panels.push_back({.y_label = "torque [rated]", .series = {torque}});
  return figure;
}

ReplayedFile replay_file(const std::string& path, const ReplayFileOptions& options) {
  std::ifstream in = opened(path);
  WithFeedback found;
  const RecordedAxis& axis = found.axis;
  const bool is_listed = !options.csv.empty();
  if (options.ticks || is_listed) {
    found = axis_in(in, path, options.axis);
    in.clear();
    if (!in.seekg(0))
      throw InputError("", "", "is a pipe, but the ticks of an axis need two passes: give a file")
          .at(path);
  }
  LastTicks ticks(axis.axis, options.last.value_or(0));
  LastMotion motion(axis.axis);
  std::optional<TickLog> csv;
  if (is_listed)
    csv.emplace(options.csv, axis.units,
                LogColumns{.compensation = axis.config.compensation.has_value(),
                           .feedback = found.position,
                           .torque = found.torque});
  Replay result = replay(in, path, [&](const RecordedCycle& cycle) {
    if (options.last) ticks.add(cycle);
    if (options.ticks && !options.last) motion.add(cycle);
    if (csv && !options.last && cycle.axis == axis.axis) csv->add(cycle.tick);
  });
  if (csv && options.last)
    for (const Tick& tick : ticks.kept()) csv->add(tick);
  if (csv) csv->close();
  return {std::move(result), std::move(found.axis), options.last ? ticks.kept() : motion.kept()};
}

}  // namespace jounce
