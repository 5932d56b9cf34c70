// SPDX-License-Identifier: Apache-2.0
#include "jounce/machine/detail/outcome_text.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "jounce/base/units.hpp"
#include "jounce/command/commands.hpp"
#include "jounce/command/detail/causes.hpp"
#include "jounce/command/detail/refusal_text.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/stream/detail/refusals.hpp"

namespace jounce {
namespace {

using OutcomeJson = nlohmann::ordered_json;

OutcomeJson common_members(const CallOutcome& outcome) {
  return {{"ok", outcome.ok()}, {"error", name(outcome.error)}, {"reason", outcome.reason}};
}

constexpr std::string_view no_remedy = "Nothing.";  ///< remedy of a cause that needs none

/// The remedy with the name of the axis or group.
std::string for_executor(std::string remedy, const std::string& executor) {
  for (const std::string_view placeholder : {"NAME", "GROUP"})
    for (auto at = remedy.find(placeholder); at != std::string::npos;
         at = remedy.find(placeholder, at)) {
      remedy.replace(at, placeholder.size(), executor);
      at += executor.size();
    }
  return remedy;
}

/// The sentences of a refusal of the protocol in place of its name. An axis that is busy has no
/// other reason.
std::string refusal_text(const CallOutcome& outcome, const std::string& executor) {
  constexpr const char* owned = "busy: the axis belongs to another session";
  for (const wire::RefusalInfo& one : wire::all_refusals()) {
    const bool is_plain = outcome.reason == one.name || outcome.reason == owned;
    if (one.refusal == outcome.refusal && is_plain)
      return std::string(one.name) + ": " + one.meaning + " " + for_executor(one.remedy, executor);
  }
  return outcome.reason;
}

/// The kind of the rejected order; nullopt: a table was rejected.
using Rejected = std::optional<CommandKind>;

/// True for an order that an axis at rest rejects, because it changes a motion.
bool changes_motion(Rejected order) {
  return order && permitted(State::standstill, *order) == Cause::no_movement;
}

/// The remedy of a fault, with the reset that ends it; for a disabled axis, also with `enable`.
std::string remedy_of_fault(const CauseInfo& fault, bool is_disabled) {
  const std::string reset = "`jounce order NAME reset`", enable = "`jounce order NAME enable`";
  std::string remedy = fault.remedy;
  if (remedy.find(reset) == std::string::npos) remedy += " Then send " + reset + ".";
  if (is_disabled && remedy.find(enable) == std::string::npos)
    remedy.insert(remedy.find(reset) + reset.size(), " and " + enable);
  return remedy;
}

/// The remedy of a cause for this axis, which has this fault (0: none). "" if the cause has none, or
/// if the executor wrote the reason itself, with a remedy: such a reason has no name of a cause.
std::string remedy_of(std::int32_t cause, const std::string& reason, const std::string& executor,
                      Rejected rejected, std::int32_t fault) {
  for (const CauseInfo& one : all_causes()) {
    if (cause == 0 || static_cast<std::int32_t>(one.cause) != cause) continue;
    if (!reason.starts_with(one.name)) return "";
    std::string remedy =
        rejected ? remedy_of_order(one.cause, *rejected) : remedy_of_table(one.cause);
    const bool is_disabled = one.cause == Cause::not_enabled;
    if (fault != 0 && (is_disabled || one.cause == Cause::in_error))
      for (const CauseInfo& latched : all_causes())
        if (static_cast<std::int32_t>(latched.cause) == fault)
          remedy = remedy_of_fault(latched, is_disabled);
    if (one.cause == Cause::in_error && fault == static_cast<std::int32_t>(Cause::aborted))
      remedy = changes_motion(rejected) ? "Send `jounce order NAME reset`, then the motion again."
                                        : "Send `jounce order NAME reset`.";
    if (one.cause == Cause::in_error && fault == static_cast<std::int32_t>(Cause::axis_fault))
      remedy =
          "Remove the cause, send `jounce order AXIS reset` and `jounce order AXIS enable` for "
          "this "
          "axis, then `jounce order NAME reset`.";
    if (is_disabled && fault == static_cast<std::int32_t>(Cause::axis_fault))
      remedy =
          "Remove its cause, then send `jounce order NAME reset` and `jounce order NAME enable`.";
    if (remedy == no_remedy) return "";
    return for_executor(remedy, executor);
  }
  return "";
}

/// `own`: a remedy in place of that of the cause, or "".
std::string reason_and_remedy(const CallOutcome& outcome, const std::string& executor,
                              Rejected rejected, std::int32_t fault, const std::string& own = "") {
  constexpr std::string_view homing = "not homed: ";
  if (outcome.reason.starts_with(homing)) {
    const std::string remedy =
        remedy_of(outcome.cause, outcome.reason.substr(homing.size()), executor, rejected, fault);
    return remedy.empty() ? outcome.reason : outcome.reason + " " + remedy;
  }
  if (outcome.refusal != wire::Refusal::axis) return refusal_text(outcome, executor);
  std::string reason = outcome.reason;
  constexpr std::string_view who = "axis: ";
  if (reason.starts_with(who)) reason.erase(0, who.size());
  const std::string remedy =
      own.empty() ? remedy_of(outcome.cause, reason, executor, rejected, fault) : own;
  return remedy.empty() ? reason : reason + " " + remedy;
}

/// The quantity whose limit a rejection names; nullopt for other causes.
std::optional<Quantity> limited_quantity(std::int32_t cause) {
  switch (static_cast<Cause>(cause)) {
    case Cause::velocity_limit:
      return Quantity::velocity;
    case Cause::acceleration_limit:
      return Quantity::acceleration;
    case Cause::jerk_limit:
      return Quantity::jerk;
    default:
      return std::nullopt;
  }
}

/// "Give a lower --deceleration.", if the order gave the rejected number with an option.
std::string remedy_of_option(const CallOutcome& outcome, const CommandWords& words,
                             const Units& units) {
  if (static_cast<Cause>(outcome.cause) == Cause::no_such_move &&
      outcome.reason.find(" is not in this direction from ") != std::string::npos)
    return "Leave out --direction, or give a target on the other side.";
  if (static_cast<Cause>(outcome.cause) == Cause::no_reserve)
    for (const std::string option : {"acceleration", "deceleration"})
      if (const std::size_t at = outcome.reason.find(": " + option + " ");
          at != std::string::npos && outcome.reason.find(" or ", at) == std::string::npos)
        return "Begin the present motion with a lower --" + option + ", or wait for its end.";
  const auto quantity = limited_quantity(outcome.cause);
  const auto value = refused_value(outcome.reason);
  const bool of_axis =
      outcome.reason.find(name(static_cast<Cause>(outcome.cause))) != std::string::npos;
  if (!quantity || !value || !of_axis) return "";
  const std::vector<std::string> options = options_with(words, *quantity, *value, units);
  return options.empty() ? "" : fmt::format("Give a lower {}.", fmt::join(options, " and "));
}

/// " The limit is --distance = 2 mm.": the option that ended a homing; "" for another end.
std::string limit_of_homing(const CallOutcome& outcome, const CommandWords& words,
                            const std::string& unit) {
  if (words.what != "home" || outcome.ok()) return "";
  const auto cause = static_cast<Cause>(outcome.cause);
  const bool is_time = cause == Cause::home_timeout;
  if (!is_time && cause != Cause::search_distance && cause != Cause::index_not_found) return "";
  const std::string option = is_time ? "timeout" : "distance";
  const auto given = words.options.find(option);
  if (given == words.options.end() || given->second.empty()) return "";
  const std::string of = is_time ? "s" : unit;
  return " The limit is --" + option + " = " + six_digits(quantity(given->second, of)) +
         (of.empty() ? "." : " " + of + ".");
}

/// The position of the master at which a gear in position begins to engage.
std::string start_of_gear(const CommandWords& words, const std::string& unit) {
  const double start = quantity(words.options.at("master-sync"), unit) -
                       quantity(words.options.at("start-distance"), unit);
  return "the slave waits until the master passes " + six_digits(start) +
         (unit.empty() ? "" : " " + unit);
}

constexpr const char* jerk_of_master =
    "; no jerk limit applies behind the master: the jerk is that of the master times the ratio";

/// True for the states in which `disable` causes a fault.
bool moves(State state) {
  return state != State::disabled && state != State::standstill && state != State::error_stop;
}

const char* last_state(const StreamOutcome& outcome, bool waits) {
  if (outcome.started) return waits ? "accepted, waits for its start" : "started";
  return outcome.armed ? "armed" : "downloaded";
}

}  // namespace

std::string with_file(const std::string& reason, const std::string& file) {
  constexpr std::string_view who = "axis: ";
  constexpr std::string_view line = "line ";
  const std::string text = reason.starts_with(who) ? reason.substr(who.size()) : reason;
  const std::size_t end = text.find_first_not_of("0123456789", line.size());
  const bool has_line =
      text.starts_with(line) && end > line.size() && end != std::string::npos && text[end] == ':';
  return has_line ? file + ":" + text.substr(line.size()) : reason;
}

std::string reason_text(const CallOutcome& outcome, const std::string& executor, CommandKind order,
                        std::int32_t fault) {
  return reason_and_remedy(outcome, executor, order, fault);
}

std::string reason_text(const CallOutcome& outcome, const CommandWords& words,
                        const wire::Status& before, const std::string& executor) {
  CallOutcome told = outcome;
  told.reason += limit_of_homing(outcome, words, before.units.position);
  return reason_and_remedy(told, executor, kind_of(words), before.last_error,
                           remedy_of_option(outcome, words, before.units));
}

namespace {

/// True if set-limits has a limit.
bool has_numbers(const CommandWords& words) {
  constexpr std::array limits{"velocity", "acceleration", "deceleration", "jerk"};
  return std::any_of(limits.begin(), limits.end(), [&](const char* option) {
    const auto given = words.options.find(option);
    return given != words.options.end() && !given->second.empty();
  });
}

std::string plain_accepted_text(const CommandWords& words, const wire::Status& before,
                                const std::string& executor) {
  const std::string& word = words.what;
  if (word == "home") return "homed";
  if (word == "gear-in-pos")
    return word + " accepted: " + start_of_gear(words, before.units.x) + jerk_of_master;
  if (word == "gear-in" || word == "combine") return word + " accepted" + jerk_of_master;
  if (word == "cut" && !words.options.contains("length") && !words.options.contains("waste"))
    return "cut accepted; it replaces a cut on demand that still waits";
  if (word == "set-coordinate-transform" &&
      std::all_of(words.options.begin(), words.options.end(),
                  [](const auto& option) { return option.second.empty(); }))
    return word + " accepted: without values, it removes the frame";
  if (word == "override" && before.gear > wire::GearState::disengaged)
    return "override accepted; no effect while the axis follows its master";
  if (word == "set-position" && before.homed)
    return fmt::format(
        "set-position accepted; the position range keeps its numbers, so it moves with the "
        "coordinate: the position was {} before",
        six_digits(before.slave_position) +
            (before.units.position.empty() ? "" : " " + before.units.position));
  if (word == "disable" && moves(before.state))
    return fmt::format(
        "disable accepted in motion: the axis has a fault now, {1}. Before the next motion, send "
        "`jounce order {0} reset` and `jounce order {0} enable`. `jounce stop {0}` before disable "
        "avoids this",
        executor, name(Cause::disabled_in_motion));
  if (word == "set-limits" && !has_numbers(words))
    return word + " accepted: without values, it removes the limits of earlier set-limits";
  if (word != "enable" || before.last_error == 0) return word + " accepted";
  return fmt::format("enable accepted, but a fault remains: {}. Send `jounce order {} reset`",
                     name(static_cast<Cause>(before.last_error)), executor);
}

}  // namespace

std::string accepted_text(const CommandWords& words, const wire::Status& before,
                          const std::string& executor, const std::string& note) {
  const bool is_group = words.what == "disable" && !note.empty();  // without the fault of an axis
  const std::string text =
      is_group ? "disable accepted" : plain_accepted_text(words, before, executor);
  return note.empty() ? text : text + "; " + note;
}

std::string stopped_text(const std::string& executor, State rest) {
  const std::string text = executor + " is at rest: " + name(rest);
  if (rest != State::error_stop) return text;
  return fmt::format(
      "{0}. `jounce monitor {1}` shows the fault, `jounce order {1} reset` clears it", text,
      executor);
}

std::string error_text(const CallOutcome& outcome, const std::string& executor,
                       const std::string& hint) {
  const std::string reason = reason_and_remedy(outcome, executor, std::nullopt, outcome.fault);
  if (outcome.error == StreamError::no_answer) return reason + ": " + hint;
  if (outcome.error == StreamError::out_of_time)
    return fmt::format("{}: {}. Permit more time (--patience)", name(outcome.error), reason);
  const bool rejected = outcome.error == StreamError::refused;
  return fmt::format("{}: {}", rejected ? "rejected" : name(outcome.error), reason);
}

std::string outcome_json(const CallOutcome& outcome) {
  return common_members(outcome).dump();
}

std::string command_json(const CallOutcome& outcome) {
  return OutcomeJson{{"ok", outcome.ok()},
                     {"error", name(outcome.error)},
                     {"cause", outcome.cause},
                     {"reason", outcome.reason}}
      .dump();
}

std::string with_remark(const std::string& text, const std::string& remark) {
  return remark.empty() ? text : text + "\nnote: " + remark;
}

std::string stream_text(const StreamOutcome& outcome, const std::string& executor, bool waits) {
  const std::string state =
      outcome.swaps > 0 ? "started, " + counted(outcome.swaps, "swap") : last_state(outcome, waits);
  const bool noted = waits && outcome.swaps == 0 && !outcome.progress.note.empty();
  return with_remark(
      fmt::format("{} arrived at {}, {} sent again; {}{}",
                  counted(outcome.progress.chunks, "chunk"), executor, outcome.progress.resent,
                  state, noted ? ": " + outcome.progress.note : ""),
      outcome.remark);
}

std::string stream_json(const StreamOutcome& outcome) {
  OutcomeJson document = common_members(outcome);
  document.update({{"downloaded", outcome.downloaded},
                   {"armed", outcome.armed},
                   {"started", outcome.started},
                   {"swaps", outcome.swaps},
                   {"chunks", outcome.progress.chunks},
                   {"resent", outcome.progress.resent},
                   {"note", outcome.progress.note}});
  if (!outcome.remark.empty()) document["remark"] = outcome.remark;
  return document.dump();
}

std::string rows_text(const RowOutcome& outcome, const std::string& executor) {
  const RowProgress& p = outcome.progress;
  return fmt::format("{} of {} played at {}, {}, {} sent again; {}", p.played,
                     counted(p.sent, "row"), executor, counted(p.underruns, "underrun"),
                     counted(p.resent, "message"), p.finished ? "finished" : "stopped");
}

std::string rows_json(const RowOutcome& outcome) {
  const RowProgress& p = outcome.progress;
  OutcomeJson document = common_members(outcome);
  document.update({{"rows", p.sent},
                   {"played", p.played},
                   {"underruns", p.underruns},
                   {"resent", p.resent},
                   {"finished", p.finished}});
  return document.dump();
}

std::string group_text(const StreamOutcome& outcome, bool waited) {
  if (outcome.stopped) return "stopped";
  return waited ? "finished" : "started";
}

std::string group_json(const std::vector<std::string>& axes,
                       const std::vector<StreamOutcome>& outcomes) {
  OutcomeJson document = OutcomeJson::array();
  for (std::size_t i = 0; i < axes.size(); ++i) {
    OutcomeJson entry{{"axis", axes[i]}};
    entry.update(common_members(outcomes[i]));
    entry.update({{"started", outcomes[i].started}, {"stopped", outcomes[i].stopped}});
    document.push_back(std::move(entry));
  }
  return document.dump();
}

}  // namespace jounce
