// SPDX-License-Identifier: Apache-2.0
#include "jounce/machine/outcome_text.hpp"

#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/command/causes.hpp"
#include "jounce/command/commands.hpp"
#include "jounce/profiles/six_digits.hpp"

namespace jounce {
namespace {

using OutcomeJson = nlohmann::ordered_json;

OutcomeJson common_members(const CallOutcome& outcome) {
  return {{"ok", outcome.ok()}, {"error", name(outcome.error)}, {"reason", outcome.reason}};
}

/// The remedy for a table that begins elsewhere, with its position; nullopt if the reason has none.
std::optional<std::string> start_remedy(const std::string& reason) {
  constexpr std::string_view mark = "begins at ";
  const std::size_t from = reason.find(mark);
  if (from == std::string::npos) return std::nullopt;
  const std::size_t begin = from + mark.size();
  std::string start = reason.substr(begin, reason.find_first_of(",;", begin) - begin);
  std::erase(start, ' ');
  const std::string move = "`jounce order NAME move --to " + start;
  if (reason.find("present motion ends at") != std::string::npos)
    return "Wait for the end of this motion, then send " + move +
           "`, or send a table that begins where the motion ends.";
  return "Move the axis to the start of the table (" + move +
         "`), or start the executor with --adopt-start. With --live, use start = \"ramp_in\" with "
         "velocity_diff and acceleration in [coupling], or the `cutter` of the axis (`jounce order "
         "NAME start`).";
}

/// The kind of the rejected order; nullopt: a table was rejected.
using Rejected = std::optional<CommandKind>;

/// The remedy of a cause for this axis. "" if the cause has none, or if the executor wrote the
/// reason itself, with a remedy.
std::string remedy_of(std::int32_t cause, const std::string& reason, const std::string& executor,
                      Rejected rejected) {
  for (const CauseInfo& one : all_causes()) {
    if (cause == 0 || static_cast<std::int32_t>(one.cause) != cause) continue;
    if (!reason.starts_with(one.name)) return "";
    std::string remedy =
        rejected ? remedy_of_order(one.cause, *rejected) : remedy_of_table(one.cause);
    if (one.cause == Cause::not_enabled && reason.find("the fault") != std::string::npos)
      remedy =
          "Remove its cause, then send `jounce order NAME reset` and `jounce order NAME enable`.";
    if (one.cause == Cause::start_position) remedy = start_remedy(reason).value_or(remedy);
    if (one.cause == Cause::no_master_input && reason.find("has no [follow]") != std::string::npos)
      remedy =
          "Add [follow] to the spec of the axis, or send the motion of the master as a table over "
          "time.";
    if (one.cause == Cause::no_master_input && reason.find("sends no valid") != std::string::npos)
      remedy = "`jounce monitor NAME` shows the master: start its program, or correct its unit.";
    constexpr std::string_view placeholder = "NAME";
    for (auto at = remedy.find(placeholder); at != std::string::npos;
         at = remedy.find(placeholder, at)) {
      remedy.replace(at, placeholder.size(), executor);
      at += executor.size();
    }
    return remedy;
  }
  return "";
}

std::string reason_and_remedy(const CallOutcome& outcome, const std::string& executor,
                              Rejected rejected) {
  constexpr std::string_view homing = "not homed: ";
  if (outcome.reason.starts_with(homing)) {
    const std::string remedy =
        remedy_of(outcome.cause, outcome.reason.substr(homing.size()), executor, rejected);
    return remedy.empty() ? outcome.reason : outcome.reason + " " + remedy;
  }
  if (outcome.refusal != wire::Refusal::axis) return outcome.reason;
  std::string reason = outcome.reason;
  constexpr std::string_view who = "axis: ";
  if (reason.starts_with(who)) reason.erase(0, who.size());
  const std::string remedy = remedy_of(outcome.cause, reason, executor, rejected);
  return remedy.empty() ? reason : reason + " " + remedy;
}

const char* last_state(const StreamOutcome& outcome, bool waits) {
  if (outcome.started) return waits ? "accepted, waits for its start" : "started";
  return outcome.armed ? "armed" : "downloaded";
}

}  // namespace

std::string reason_text(const CallOutcome& outcome, const std::string& executor,
                        CommandKind order) {
  return reason_and_remedy(outcome, executor, order);
}

std::string accepted_text(const std::string& word, const wire::Status& before,
                          const std::string& executor) {
  if (word == "home") return "homed";
  if (word == "override" && before.gear > wire::GearState::disengaged)
    return "override accepted; no effect while the axis follows its master";
  if (word == "set-position" && before.homed)
    return fmt::format(
        "set-position accepted; the position range keeps its numbers, so it moves with the "
        "coordinate: the position was {} before",
        six_digits(before.slave_position) +
            (before.units.position.empty() ? "" : " " + before.units.position));
  if (word != "enable" || before.last_error == 0) return word + " accepted";
  return fmt::format("enable accepted, but the fault {} remains: send `jounce order {} reset`",
                     name(static_cast<Cause>(before.last_error)), executor);
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
  const std::string reason = reason_and_remedy(outcome, executor, std::nullopt);
  if (outcome.error == StreamError::no_answer) return reason + ": " + hint;
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

std::string stream_text(const StreamOutcome& outcome, const std::string& executor, bool waits) {
  const std::string state =
      outcome.swaps > 0 ? "started, " + counted(outcome.swaps, "swap") : last_state(outcome, waits);
  return fmt::format("{} arrived at {}, {} sent again; {}",
                     counted(outcome.progress.chunks, "chunk"), executor, outcome.progress.resent,
                     state);
}

std::string stream_json(const StreamOutcome& outcome) {
  OutcomeJson document = common_members(outcome);
  document.update({{"downloaded", outcome.downloaded},
                   {"armed", outcome.armed},
                   {"started", outcome.started},
                   {"swaps", outcome.swaps},
                   {"chunks", outcome.progress.chunks},
                   {"resent", outcome.progress.resent}});
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
