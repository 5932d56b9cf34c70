// SPDX-License-Identifier: Apache-2.0
#include "executor/src/server/notices.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "jounce/command/detail/command_table.hpp"
#include "jounce/command/detail/refusal_text.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/message/message.hpp"

namespace jounce {
namespace {

/// Returns the numbers of a fault, each with its limit: " The following error is 0.31 mm; ...". "" for a
/// fault without numbers. `now`: the tick of the fault, or a later one (`later`), which has the limits
/// only.
std::string numbers_of(const Tick& now, const std::string& unit, const AxisConfig& config,
                       std::span<const std::string> axes, bool later) {
  const auto valued = [&](double number, const char* per = "") {
    return six_digits(number) + (unit.empty() ? "" : " " + unit + per);
  };
  const auto limit = [&](const char* key, const std::optional<double>& value,
                         const char* per = "") {
    return value ? std::string(" The limit is ") + key + " = " + valued(*value, per) + "." : "";
  };
  const auto required = [&](const char* per) {
    return std::isfinite(now.fault_value)
               ? " The motion requires " + valued(now.fault_value, per) + "."
               : "";
  };
  switch (now.fault) {
    case Cause::following_error:
      return " The following error was " + valued(now.fault_value) +
             "; the limits are following_error = " + valued(config.following_error) +
             " and following_time = " + six_digits(config.following_time) + " s.";
    case Cause::overspeed:
      return required("/s") + limit("velocity", config.limits.velocity, "/s");
    case Cause::overacceleration:
      return required("/s^2") + limit("acceleration", config.limits.acceleration, "/s^2");
    case Cause::jump: {
      auto most = config.limits.acceleration;
      if (most) *most *= 2;  // the default of stop_acceleration
      if (config.stop_acceleration > 0) most = config.stop_acceleration;
      return required("/s^2") + limit("stop_acceleration", most, "/s^2");
    }
    case Cause::positive_soft_limit:
      return limit("position_max", config.limits.position_max);
    case Cause::negative_soft_limit:
      return limit("position_min", config.limits.position_min);
    case Cause::out_of_range:
      return limit("position_min", config.limits.position_min) +
             limit("position_max", config.limits.position_max);
    case Cause::stalled:
      return (later ? std::string(" The limit")
                    : " It was late by " + std::to_string(now.skipped) + " cycles;") +
             " longest_gap is " + std::to_string(config.longest_gap) + " cycles.";
    case Cause::home_timeout:
      return std::isfinite(now.fault_value)
                 ? " The limit is timeout = " + six_digits(now.fault_value) + " s."
                 : "";
    case Cause::search_distance:
    case Cause::index_not_found:
      return std::isfinite(now.fault_value) ? limit("distance", now.fault_value) : "";
    case Cause::axis_fault:
      return now.failed_axis ? " " + unready_axis_text(*now.failed_axis, axes) : "";
    default:
      return "";
  }
}

}  // namespace

std::span<const std::string> group_names(const ExecutorOptions& options) {
  if (!options.group) return {};
  return options.group->names;
}

std::string fault_text(const Tick& now, const std::string& unit, const AxisConfig& config,
                       std::span<const std::string> axes) {
  return std::string(name(now.fault)) + ": " + meaning(now.fault) +
         numbers_of(now, unit, config, axes, false);
}

namespace {

/// The first of these texts, from the most complete one, that fits into the field of the reason; the
/// last one if none fits.
std::string fitting(std::initializer_list<std::string> texts) {
  const auto* const fits = std::find_if(texts.begin(), texts.end() - 1, [](const auto& text) {
    return text.size() < wire::reason_bytes;
  });
  return *fits;
}

/// The text of a refusal without the meaning of its cause: "axis_away: x is at 3 mm instead of 5 mm."
std::string without_meaning(Cause cause, const std::string& words) {
  const std::string head = std::string(name(cause)) + ": ";
  std::string meant = head + meaning(cause);
  meant.pop_back();  // the full stop
  if (!words.starts_with(meant)) return words;
  const std::size_t rest = words.find_first_not_of(".: ", meant.size());
  return rest == std::string::npos ? words : head + words.substr(rest);
}

/// A reason with its remedy, for an axis of these groups.
std::string in_group_text(const std::vector<std::string>& groups, CommandKind order) {
  std::string names;
  for (const std::string& group : groups) names += (names.empty() ? "" : " or ") + group;
  const std::string reason = "the enabled group " + names + " alone moves this axis: ";
  const std::string to_group = "`jounce order " + groups.front();
  if (order == CommandKind::hold || order == CommandKind::resume || order == CommandKind::halt)
    return reason + "send " + to_group + " " + info(order).word + "`";
  const std::string disable =
      "command the group, or stop it and send " + to_group + " disable` first";
  return fitting({reason + disable, "one of its enabled groups alone moves this axis: " + disable});
}

}  // namespace

namespace {

std::string in_units(double number, const ExecutorOptions& options) {
  const std::string& unit = options.units.position;
  return six_digits(number) + (unit.empty() ? "" : " " + unit);
}

/// A place to which an order of the reason moves the axis.
std::string place_in_units(double place, const ExecutorOptions& options) {
  const std::string& unit = options.units.position;
  return place_text(place) + (unit.empty() ? "" : " " + unit);
}

/// The reason and its remedy, for a relative move of an axis at rest that leaves the position range:
/// the distances to its ends. "" for another refusal, or outside the range.
std::string distance_text(const Refusal& refusal, const Tick& now, const ExecutorOptions& options,
                          CommandKind order) {
  const bool relative = order == CommandKind::move_relative || order == CommandKind::move_additive;
  const Limits& limits = options.axis.limits;
  if (refusal.cause != Cause::position_limit || !relative || now.state != State::standstill ||
      !limits.position_min || !limits.position_max)
    return "";
  const double forward = *limits.position_max - now.position;
  const double back = now.position - *limits.position_min;
  if (!(forward >= 0) || !(back >= 0)) return "";
  std::string most;
  if (forward > 0) most = in_units(forward, options) + " forward";
  if (back > 0) most += (most.empty() ? "" : ", or ") + in_units(back, options) + " back";
  const std::string outside = in_units(refusal.value, options) + " is outside the position range";
  const std::string give = ": give at most " + most;
  return fitting({outside + ", " + in_units(*limits.position_min, options) + " to " +
                      in_units(*limits.position_max, options) + give,
                  outside + give});
}

/// The reason and its remedy, for what the spec of the axis lacks; "" for another refusal.
std::string missing_part_text(Cause cause, const ExecutorOptions& options) {
  if (options.group)
    return cause == Cause::no_trigger_input
               ? "a group has no inputs: send the command to one of its axes"
               : "";
  if (cause == Cause::no_cut_plan && !options.cutter)
    return "the axis has no cutter: send the command to an axis that has one, or add cutter = "
           "\"FILE\" (kind knife or shear) to [axis], and [follow] with its line";
  if (cause == Cause::no_trigger_input && !options.drive)
    return "the axis has no drive that reports inputs: add [drive] to its spec, and the input to "
           "[drive.machine] if the drive is simulated";
  if (cause != Cause::no_master_input) return "";
  if (options.follow.what == Follow::What::nothing)
    return "the axis has no live master: add follow = { axis = \"NAME\" } to its [[axis]] in the "
           "machine spec, or [follow] to its own spec, and start the executor again";
  const std::string what = "the master of the axis sends no valid position: ";
  const std::string remedy =
      "if it is an axis or a virtual master, enable it; otherwise start its program, or correct "
      "its unit";
  return fitting(
      {what + remedy + ". `jounce monitor " + options.receiver.executor + "` shows the master",
       what + remedy});
}

/// The reason and its remedy, for an order that an endless or a held motion prevents: the order that
/// ends this motion. "" for another refusal. Without the name of the cause: `jounce order` adds no second remedy.
std::string endless_text(Cause cause, const Tick& now, const ExecutorOptions& options,
                         CommandKind order) {
  const std::string halt = "`jounce order " + options.receiver.executor + " halt`";
  const bool endless = now.state == State::continuous_motion;
  if (endless && order == CommandKind::finish && cause == Cause::no_movement)
    return "a motion at constant velocity has no end to finish: end it with " + halt;
  if (cause != Cause::in_motion && cause != Cause::synchronized) return "";
  if (now.override_ == 0 && now.velocity == 0 && cause == Cause::in_motion)
    return "the motion waits, because the override is 0 %: end it with " + halt +
           ", or raise the override";
  if (now.held && cause == Cause::in_motion)
    return std::string("the ") + (options.group ? "group" : "axis") +
           " is held on its path: end the motion with " + halt + ", or continue it with `resume`";
  const bool starts = order == CommandKind::arm || order == CommandKind::start;
  // Otherwise only a part of the motion prevents it, such as a clutch.
  if (permitted(now.state, order) != cause && !(endless && starts)) return "";
  if (!endless && now.state != State::synchronized_motion) return "";
  if (endless) return "the axis keeps a constant velocity: end the motion with " + halt;
  if (now.ratio != 0) return "the axis follows its master by a gear: end the gear with " + halt;
  const std::string follows = "the axis follows its master: end the coupling with ";
  return options.cutter ? follows + "`jounce order " + options.receiver.executor +
                              " park`, or `halt` without a plan of cuts"
                        : follows + halt;
}

/// The places of a table and of the axis, as text; with twelve digits if six look equal.
struct StartPlaces {
  std::string table, axis;
  std::string move;  ///< the order that moves the axis to the table
};

StartPlaces start_places(const Refusal& refusal, const ExecutorOptions& options) {
  StartPlaces is{.table = place_in_units(refusal.value, options), .axis = {}, .move = {}};
  const bool close = in_units(refusal.value, options) == in_units(refusal.limit, options);
  is.axis = close ? place_in_units(refusal.limit, options) : in_units(refusal.limit, options);
  std::string place = is.table;
  std::erase(place, ' ');
  is.move = "`jounce order " + options.receiver.executor + " move --to " + place + "`";
  return is;
}

/// A cam on a live master that is elsewhere than the axis. --adopt-start has no effect on it, so the
/// text has no name of the cause: `jounce stream` adds no remedy. While the master moves, the place
/// of the cam is no remedy: after a move to it, the master is elsewhere.
std::string live_start_text(const StartPlaces& at, const Tick& now,
                            const ExecutorOptions& options) {
  const std::string order = "`jounce order " + options.receiver.executor;
  const double velocity = now.live_master[1];
  const bool master_moves = std::isfinite(velocity) && velocity != 0;
  const bool endless =
      now.state == State::synchronized_motion || now.state == State::continuous_motion;
  const std::string places = "the cam is at " + at.table + ", the axis at " + at.axis;
  const std::string ramp = "start = \"ramp_in\" in [coupling]";
  if (options.cutter && options.follow.what != Follow::What::nothing && !in_motion(now)) {
    const std::string cutter = "send " + order + " start` for its cutter";
    return fitting({places + ": " + cutter, "the cam is at " + at.table + ": " + cutter, cutter});
  }
  if (endless) {
    const std::string halt = "the axis keeps moving: send " + order + " halt`, then ";
    const std::string with_ramp = halt + "use " + ramp;
    if (master_moves) return with_ramp;
    return fitting({halt + at.move + ", and repeat the command", halt + at.move, with_ramp});
  }
  if (master_moves) {
    const std::string moves = "the master moves: use " + ramp;
    const std::string there = ", or --start-at where the cam rests at ";
    return fitting({"the cam is at " + at.table + " now, the axis at " + at.axis + ", and " +
                        moves + there + "this place",
                    moves + there + "the place of the axis", moves});
  }
  const std::string when = in_motion(now) ? ": after the present motion, send " : ": send ";
  return fitting({places + when + at.move + ", or use " + ramp, places + when + at.move,
                  "the cam is elsewhere" + when + at.move});
}

/// A table that begins elsewhere than the axis stands, or will stand. If the executor adopts the
/// start already, the text has no name of the cause: `jounce stream` does not add this remedy.
std::string start_position_text(const Refusal& refusal, const Tick& now,
                                const ExecutorOptions& options, bool live) {
  const std::string order = "`jounce order " + options.receiver.executor;
  const StartPlaces at = start_places(refusal, options);
  if (now.fault != Cause::none) {
    const std::string reset = "the axis has a fault: " + std::string(name(now.fault)) +
                              ". First send " + order +
                              " reset`, and move the axis to the start of the table";
    return fitting({reset + ", " + at.table, reset});
  }
  if (std::isnan(refusal.value))
    return "the motion does not begin at the position of the axis, " + at.axis;
  if (live) return live_start_text(at, now, options);
  const bool adopts = options.adopt_start;
  const std::string head = adopts ? "" : std::string(name(refusal.cause)) + ": ";
  const std::string begins = head + (adopts ? "the" : "The") + " table begins at " + at.table;
  const std::string stop = adopts ? "" : ".";
  const bool endless =
      now.state == State::synchronized_motion || now.state == State::continuous_motion;
  if (endless) {
    const std::string halt = "the axis keeps moving: send " + order + " halt`, ";
    const std::string then =
        halt + (adopts ? "" : "then " + at.move + ", ") + "and repeat the command" + stop;
    const std::string first = head + halt + "and move it to the start of the table" + stop;
    return fitting({begins + ", but " + then, head + then, first});
  }
  const bool moves = in_motion(now);
  if (moves && adopts)
    return fitting(
        {begins + ", but the present motion ends at " + at.axis + ": repeat the command after it",
         begins + ": repeat the command after the present motion"});
  const std::string move =
      (moves ? ": after the present motion, send " : ": send ") + at.move + stop;
  return fitting({begins + (moves ? ", but the present motion ends at " : ", but the axis is at ") +
                      at.axis + (moves ? ": after it, send " : ": send ") + at.move + stop,
                  begins + move, head + "Move the axis to the start of the table first" + move});
}

/// The unit of the numbers of a refusal: that of the axis of the group that it names.
std::string unit_of_axis(const Refusal& refusal, const ExecutorOptions& options) {
  if (!options.group || options.group->units.empty()) return options.units.position;
  const std::vector<std::string>& units = options.group->units;
  const bool names_axis = refusal.cause == Cause::axis_away && refusal.where >= 1 &&
                          refusal.where <= static_cast<double>(units.size());
  return names_axis ? units[static_cast<std::size_t>(refusal.where) - 1] : options.group->unit;
}

/// Adds the tolerance of a place if the reply is long enough for it.
void add_tolerance(std::string& words, double tolerance, const std::string& unit) {
  const std::string more =
      " The tolerance is " + six_digits(tolerance) + (unit.empty() ? "" : " " + unit) + ".";
  if (words.size() + more.size() < wire::reason_bytes) words += more;
}

/// A cutter away from its home position, with the order that moves it there.
std::string home_position_text(const Refusal& refusal, const ExecutorOptions& options) {
  const std::string home = place_in_units(refusal.value, options);
  std::string place = home;
  std::erase(place, ' ');
  const std::string away = "the cutter does not stand at its home position";
  const std::string move =
      ": send `jounce order " + options.receiver.executor + " move --to " + place + "`";
  return fitting(
      {away + ": home is at " + home + ", the axis at " + in_units(refusal.limit, options) + move,
       away + move});
}

/// The orders that enable a disabled group without a fault: its axes, then the group. "" for another
/// refusal.
std::string disabled_group_text(Cause cause, const Tick& now, const ExecutorOptions& options) {
  if (cause != Cause::not_enabled || !options.group || now.fault != Cause::none) return "";
  const auto words = [&](const std::string& axes) {
    return "the group is disabled: send `jounce order AXIS enable` for " + axes +
           ", then `jounce order " + options.receiver.executor + " enable`";
  };
  std::string names;
  for (const std::string& axis : options.group->names) names += (names.empty() ? "" : ", ") + axis;
  const std::string all = words(names);
  return fitting({all, words("each of its axes")});
}

}  // namespace

std::string refusal_text(const Refusal& refusal, const Tick& now, const ExecutorOptions& options,
                         CommandKind order, bool live) {
  if (refusal.cause == Cause::in_group && !options.groups.empty())
    return in_group_text(options.groups, order);
  if (const std::string order_of_enables = disabled_group_text(refusal.cause, now, options);
      !order_of_enables.empty())
    return order_of_enables;
  if (const std::string most = distance_text(refusal, now, options, order); !most.empty())
    return most;
  if (const std::string missing = missing_part_text(refusal.cause, options); !missing.empty())
    return missing;
  if (const std::string endless = endless_text(refusal.cause, now, options, order);
      !endless.empty())
    return endless;
  if (refusal.cause == Cause::cutter_away && std::isfinite(refusal.value))
    return home_position_text(refusal, options);
  if (refusal.cause == Cause::start_position)
    return start_position_text(refusal, now, options, live);
  const std::string unit = unit_of_axis(refusal, options);
  std::string words = text(refusal, unit, options.units.x, group_names(options));
  constexpr std::string_view either = "The axis or group ";
  if (const std::size_t at = words.find(either); at != std::string::npos)
    words.replace(at, either.size(), options.group ? "The group " : "The axis ");
  if (refusal.cause == Cause::probe_window && options.axis.limits.position_min &&
      options.axis.limits.position_max)
    words += " The axis has the range " + in_units(*options.axis.limits.position_min, options) +
             " to " + in_units(*options.axis.limits.position_max, options) + ".";
  if (refusal.cause == Cause::axis_away && options.group)
    add_tolerance(words, options.group->of.tolerance, unit);
  words = fitting({words, without_meaning(refusal.cause, words),
                   std::string(name(refusal.cause)) + ": " + meaning(refusal.cause)});
  const bool fault = refusal.cause == Cause::in_error || refusal.cause == Cause::not_enabled;
  if (!fault || now.fault == Cause::none) return words;
  const std::string who = options.group ? ": the group " : ": the axis ";
  const std::string why =
      std::string(name(refusal.cause)) + who +
      (refusal.cause == Cause::in_error ? "has a fault: " : "is disabled because of a fault: ") +
      name(now.fault);
  const std::string numbers =
      numbers_of(now, options.units.position, options.axis, group_names(options), true);
  const std::string means = why + ". " + meaning(now.fault);
  // The most complete text that fits into the field of the reason.
  return fitting({means + numbers, numbers.empty() ? means : why + "." + numbers, means,
                  why + ". See `jounce explain " + name(now.fault) + "`."});
}

std::vector<std::string> notices_of(const Tick& before, const Tick& now, const std::string& unit,
                                    const AxisConfig& config, std::span<const std::string> axes) {
  std::vector<std::string> notices;
  const std::string at = " at tick " + std::to_string(now.tick);
  if (now.job != 0 && now.job != before.job) notices.push_back("started" + at);
  if (now.dropped)
    notices.push_back("the armed motion did not start" + at + ": " + text(*now.dropped, unit));
  if (now.finished > before.finished) notices.push_back("finished" + at);
  if (now.stopped > before.stopped) notices.push_back("stopped" + at);
  if (now.fault != before.fault && now.fault != Cause::none)
    notices.push_back("fault" + at + " (" + six_digits(now.time) + " s, position " +
                      six_digits(now.position) + (unit.empty() ? "" : " " + unit) +
                      "): " + fault_text(now, unit, config, axes) + " See `jounce explain " +
                      name(now.fault) + "`.");
  if (now.registration.lost && !before.registration.lost)
    notices.push_back("registration: no mark in the last products" + at);
  return notices;
}

}  // namespace jounce
