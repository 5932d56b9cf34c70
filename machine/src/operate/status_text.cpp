// SPDX-License-Identifier: Apache-2.0
#include "jounce/machine/detail/status_text.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/units.hpp"
#include "jounce/command/cause.hpp"
#include "jounce/command/commands.hpp"
#include "jounce/profiles/detail/six_digits.hpp"

#include "machine/src/operate/dashboard_text.hpp"

namespace jounce {

namespace {

using Json = nlohmann::ordered_json;

constexpr double unseen = 1e-12;  ///< a smaller value in the unit of an axis is rounding

/// "12.5 mm"; "12.5" without a unit.
std::string number_text(double value, const std::string& unit) {
  return six_digits(std::abs(value) < unseen ? 0 : value) + (unit.empty() ? "" : " " + unit);
}

/// "  range_end" after a jog that a group could not continue, "  start dropped: start_position" after
/// a start with a live master that was not possible when it was due; "" otherwise.
std::string end_of_motion(const wire::Status& s) {
  const auto cause = static_cast<Cause>(s.reason);
  if (cause >= Cause::range_end && cause <= Cause::no_acknowledge)
    return std::string("  ") + name(cause);
  const bool dropped = (cause >= Cause::bad_table && cause <= Cause::not_in_sync) ||
                       cause == Cause::start_jump || cause == Cause::cutter_away;
  return dropped && s.state == State::standstill ? std::string("  start dropped: ") + name(cause)
                                                 : "";
}

}  // namespace

std::string status_text(const std::string& axis, const wire::Status& s) {
  return fmt::format(
      "{:<12} {:<9} tick {:<10} {:<19} position {:<14} velocity {:<16} late cycles "
      "{}{}{}{}{}{}{}{}{}{}",
      axis, name(s.state), s.tick,
      std::isnan(s.master_position) ? "no master"
                                    : "master " + number_text(s.master_position, s.units.x),
      number_text(s.slave_position, s.units.position),
      number_text(s.slave_velocity, rate_unit(s.units.position, "s", 1)), s.late_ticks,
      s.override_ == 1 ? "" : fmt::format("  override {} %", six_digits(100 * s.override_)),
      s.held ? "  held" : "", s.homed ? "  homed" : "",
      std::isnan(s.correction) ? ""
                               : "  compensated " + number_text(s.correction, s.units.position),
      s.gear == wire::GearState::none ? "" : "  " + gear_text(s),
      s.last_error == 0 ? "" : fmt::format("  {}", name(static_cast<Cause>(s.last_error))),
      waits_text(s).empty() ? "" : "  " + waits_text(s), end_of_motion(s),
      s.unwritten == 0 ? "" : fmt::format("  not written: {}", unwritten_files(s.unwritten)));
}

std::string status_json(const std::string& axis, const wire::Status& s) {
  const Json line{{"name", axis},
                  {"state", name(s.state)},
                  {"tick", s.tick},
                  {"master", s.master_position},
                  {"position", s.slave_position},
                  {"velocity", s.slave_velocity},
                  {"late", s.late_ticks},
                  {"error", s.last_error},
                  {"actual", s.actual_position},
                  {"following_error", s.following_error},
                  {"override", s.override_},
                  {"progress", name(s.progress)},
                  {"waits", s.start == wire::StartOutcome::waiting ? s.start_reason : ""},
                  {"held", s.held},
                  {"homed", s.homed},
                  {"gear", name(s.gear)},
                  {"gear_master", s.gear_master},
                  {"ratio", s.ratio},
                  {"correction", s.correction},
                  {"unwritten", unwritten_files(s.unwritten)},
                  {"queue_rows", s.queue_rows},
                  {"reason", name(static_cast<Cause>(s.reason))}};
  return line.dump();
}

std::string status_text(const std::string& axis, const wire::MasterStatus& m) {
  return fmt::format("{:<12} master    tick {:<10} {}", axis, m.tick, master_text(m, true));
}

std::string status_json(const std::string& axis, const wire::MasterStatus& m) {
  const Json line{{"name", axis},           {"master_name", m.master}, {"unit", m.unit},
                  {"tick", m.tick},         {"lost", m.lost},          {"position", m.position},
                  {"velocity", m.velocity}, {"age", m.age_s},          {"taken", m.taken},
                  {"refused", m.refused}};
  return line.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string status_text(const std::string& group, const wire::GroupStatus& g,
                        const std::string& unit) {
  return fmt::format("{:<12} path      tick {:<10} {}, feed {}, remaining {}", group, g.tick,
                     place_text(g, unit), number_text(g.feed, rate_unit(unit, "s", 1)),
                     remaining_text(g, unit));
}

std::string status_json(const std::string& group, const wire::GroupStatus& g) {
  const Json line{{"name", group},
                  {"tick", g.tick},
                  {"axes", g.axes},
                  {"place", g.place},
                  {"units", g.units},
                  {"framed", g.framed},
                  {"path_position", g.position},
                  {"path_length", g.length},
                  {"feed", g.feed},
                  {"remaining", g.remaining_s},
                  {"estimated", g.estimated},
                  {"line", g.line},
                  {"commands", g.commands},
                  {"look_ahead", g.look_ahead}};
  return line.dump();
}

std::string place_text(const wire::GroupStatus& group, const std::string& unit) {
  std::string place = group.framed ? "frame" : "";
  for (std::size_t k = 0; k < group.axes.size() && k < group.place.size(); ++k)
    place += (place.empty() ? "" : " ") + group.axes[k] + " " +
             number_text(group.place[k], k < group.units.size() ? group.units[k] : "");
  if (std::isnan(group.length)) return place + "; no path";
  return fmt::format("{}; path {} of {}, line {}", place, number_text(group.position, unit),
                     number_text(group.length, unit), group.line);
}

std::string remaining_text(const wire::GroupStatus& group, const std::string& unit) {
  std::string text =
      std::isnan(group.remaining_s) ? "not known" : six_digits(group.remaining_s) + " s";
  if (group.estimated && !std::isnan(group.remaining_s)) text += " (estimate)";
  text += ", " + counted(group.commands, "command");
  if (!std::isnan(group.look_ahead)) text += ", look-ahead " + number_text(group.look_ahead, unit);
  return text;
}

std::string event_text(const wire::Event& event) {
  using wire::MarkEvent;
  const std::string at = fmt::format(" at {}", event.position);
  switch (event.kind) {
    case wire::EventKind::probe: {
      const auto input = event.number == home_switch_input ? std::string("home")
                         : event.number == index_input     ? std::string("index")
                                                           : std::to_string(event.number);
      return "probe " + input + (event.on ? " rising" : " falling") + at;
    }
    case wire::EventKind::mark:
      switch (static_cast<MarkEvent>(event.number)) {
        case MarkEvent::missing:
          return "mark missing";
        case MarkEvent::stray:
          return "stray mark";
        case MarkEvent::lost:
          return "marks lost";
        case MarkEvent::accepted:
          break;
      }
      return fmt::format("mark, deviation {:.6g}", event.position);
    case wire::EventKind::end_of_profile:
      return fmt::format("end of profile {}, master{}", event.number, at);
    case wire::EventKind::table_begin:
      return fmt::format("follow table {} begins, master{}", event.number, at);
    case wire::EventKind::m_word:
      return fmt::format("M{} {}", event.number, event.on ? "waits" : "passes");
    case wire::EventKind::compare:
    case wire::EventKind::track:
    case wire::EventKind::tappet:
      break;
  }
  return fmt::format("{} {} {}{}", name(event.kind), event.number, event.on ? "on" : "off", at);
}

std::string status_text(const std::string& axis, const wire::Event& event) {
  return fmt::format("{:<12} event {:<6} tick {} - {:<9} {}", axis, event.count, event.tick,
                     fmt::format("{:.1f} us", 1e6 * event.offset_s), event_text(event));
}

std::string status_json(const std::string& axis, const wire::Event& event) {
  const Json line{{"name", axis},
                  {"event", event.count},
                  {"kind", name(event.kind)},
                  {"number", event.number},
                  {"on", event.on},
                  {"tick", event.tick},
                  {"offset_s", event.offset_s},
                  {"position", event.position}};
  return line.dump();
}

std::string waits_text(const wire::Status& s) {
  return s.start == wire::StartOutcome::waiting && !s.start_reason.empty()
             ? "start waits " + s.start_reason
             : "";
}

std::string gear_text(const wire::Status& s) {
  const std::string ratio = s.ratio == 0 ? "" : fmt::format(", ratio {:.6g}", s.ratio);
  const bool waits = s.gear == wire::GearState::engaging && s.progress == wire::Progress::waiting;
  return (waits ? "waiting for its master" : std::string(name(s.gear))) + ratio;
}

std::string unwritten_files(std::uint8_t files) {
  std::string text;
  for (const auto& [bit, word] : {std::pair{wire::log_unwritten, "log"},
                                  {wire::record_unwritten, "record"},
                                  {wire::black_box_unwritten, "black box"}})
    if ((files & bit) != 0) text += (text.empty() ? "" : ", ") + std::string(word);
  return text;
}

std::string master_text(const wire::MasterStatus& master, bool ascii) {
  const std::string unit = machine_detail::harmless(master.unit, ascii);
  const std::string age =
      std::isnan(master.age_s) ? std::string("no valid sample yet")
      : master.age_s == 0
          ? std::string("computed")
          : fmt::format("measured {} ms ago", six_digits(std::round(1e5 * master.age_s) / 100));
  // Samples of a sender that the executor rejects; its terminal prints the reason.
  const std::string rejected =
      master.refused > 0 ? fmt::format(", {} rejected (unit, epoch, order)", master.refused) : "";
  if (master.lost)
    return fmt::format("{}{}, {}{}", master.master, std::isnan(master.age_s) ? "" : " is lost",
                       master.age_s > 0
                           ? fmt::format("its last sample came {} s ago", six_digits(master.age_s))
                           : age,
                       rejected);
  return fmt::format("{} {}, {}, {}", master.master, machine_detail::valued(master.position, unit),
                     machine_detail::valued(master.velocity, unit + "/s"), age);
}

}  // namespace jounce
