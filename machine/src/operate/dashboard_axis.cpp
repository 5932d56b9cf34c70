// SPDX-License-Identifier: Apache-2.0
#include "machine/src/operate/dashboard_axis.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "jounce/command/cause.hpp"
#include "jounce/executor/histogram.hpp"
#include "jounce/machine/detail/status_text.hpp"
#include "jounce/profiles/detail/six_digits.hpp"

#include "machine/src/operate/dashboard_text.hpp"

namespace jounce::machine_detail {

using namespace dashboard;

namespace {

constexpr std::size_t label = 12;  // columns before a value

std::string within(const wire::Histogram& counts) {
  const double us = upper_bound(counts, 0.999);
  if (us == 0) return "";
  return std::isinf(us) ? "99.9 % not within 16384 us" : fmt::format("99.9 % within {} us", us);
}

Tone tone_of(State state) {
  using State = State;
  switch (state) {
    case State::disabled:
      return Tone::faint;
    case State::standstill:
      return Tone::rests;
    case State::stopping:
      return Tone::waits;
    case State::error_stop:
      return Tone::wrong;
    default:
      return Tone::moves;
  }
}

std::string unit_of(const wire::Status& s, bool ascii) {
  return s.units.position.empty() ? "u" : harmless(s.units.position, ascii);
}

/// Seconds since its last message, if there are too many.
std::optional<double> silent(const Watched& axis, const View& view) {
  const Nanos since = view.now - axis.received;
  if (since <= view.silence) return std::nullopt;
  return std::chrono::duration<double>(since).count();
}

std::string fault_of(const wire::Status& s) {
  if (s.last_error == 0) return "";
  return fmt::format("{} {}", s.last_error, name(static_cast<Cause>(s.last_error)));
}

/// A label and what follows it.
Row line(const char* text, std::vector<Span> spans) {
  Row row{{padded(text, label), Tone::faint}};
  std::move(spans.begin(), spans.end(), std::back_inserter(row));
  return row;
}

std::string outputs_of(std::uint32_t bits) {
  std::string text;
  for (int i = 0; i < 32; ++i)
    if ((bits >> static_cast<unsigned>(i) & 1U) != 0) text += fmt::format("{} ", i + 1);
  return text.empty() ? "none on" : text;
}

std::string words_of(std::int32_t cause) {
  const auto c = static_cast<Cause>(cause);
  return fmt::format("{} {}: {}", cause, name(c), meaning(c));
}

/// Motion: where it is, how fast, how far behind.
void add_motion(std::vector<Row>& rows, const wire::Status& s, const View& view) {
  const std::string u = unit_of(s, view.ascii);
  std::string doing = s.held ? "held" : name(s.progress);
  if (const std::string waits = waits_text(s); !waits.empty())
    doing += ", " + waits;
  else if (s.next != wire::Next::nothing)
    doing += fmt::format(", next: {}", name(s.next));
  rows.push_back(
      line("state", {{padded(name(s.state), 21), tone_of(s.state)}, {"motion " + doing}}));
  std::string position = padded(valued(s.slave_position, u), 21);
  if (s.homed) position += "homed ";
  if (!std::isnan(s.master_position))
    position += "master " + valued(s.master_position, harmless(s.units.x, view.ascii));
  rows.push_back(line("position", {{position, Tone::strong}}));
  rows.push_back(
      line("velocity",
           {{padded(valued(s.slave_velocity, u + "/s"), 21) + "torque " +
             (std::isnan(s.torque) ? "not known" : fmt::format("{:.0f} %", 100 * s.torque))}}));
  rows.push_back(line("actual", {{padded(valued(s.actual_position, u), 21) + "following error " +
                                  valued(s.following_error, u)}}));
  if (!std::isnan(s.correction))
    rows.push_back(line("correction", {{valued(s.correction, u), Tone::plain}}));
  if (s.gear != wire::GearState::none || s.gear_master)
    rows.push_back(
        line("gear", {{(s.gear == wire::GearState::none ? "" : gear_text(s)) +
                       std::string(s.gear == wire::GearState::none || !s.gear_master ? "" : ", ") +
                       (s.gear_master ? "master of another axis" : "")}}));
  rows.push_back(line("override", {{bar(s.override_ / 2, view.ascii)},
                                   {fmt::format(" {:.0f} %", 100 * s.override_)}}));
}

std::vector<Span> queue_of(const wire::Status& s, bool ascii) {
  if (s.queue_capacity == 0) return {{"none", Tone::faint}};
  const double share = static_cast<double>(s.queue_rows) / s.queue_capacity;
  const bool starves = s.progress == wire::Progress::starving;
  return {{bar(share, ascii), starves ? Tone::wrong : Tone::moves},
          {fmt::format(" {} of {} rows", s.queue_rows, s.queue_capacity)}};
}

void add_masters(std::vector<Row>& rows, const Watched& axis, const View& view) {
  for (const wire::MasterStatus& master : axis.masters)
    rows.push_back(line(
        "master", {{master_text(master, view.ascii), master.lost ? Tone::wrong : Tone::plain}}));
}

void add_group(std::vector<Row>& rows, const Watched& axis, const View& view) {
  if (!axis.group) return;
  const std::string unit = unit_of(*axis.status, view.ascii);
  rows.push_back(line("path", {{place_text(*axis.group, unit)}}));
  rows.push_back(line("remaining", {{remaining_text(*axis.group, unit)}}));
}

/// The cycle and the link: what is late, what was refused.
void add_health(std::vector<Row>& rows, const wire::Status& s, const View& view) {
  rows.push_back(
      line("late", {{counted(s.late_ticks, "cycle"), s.late_ticks > 0 ? Tone::waits : Tone::plain},
                    {fmt::format(" late by {} ms or more; present tick {}",
                                 static_cast<double>(s.cycle_ns) * 1e-6, s.tick)}}));
  for (const auto& [text, counts] :
       {std::pair{"wake-up", &s.lateness}, {"computing", &s.computing}})
    rows.push_back(line(text, {{histogram(*counts, view.ascii), Tone::moves},
                               {" 1 us to 16 ms  " + within(*counts), Tone::faint}}));
  if (s.unwritten != 0)
    rows.push_back(line("files", {{"not written: " + unwritten_files(s.unwritten), Tone::wrong}}));
  rows.push_back(line("packets", {{fmt::format("{} rejected, {} of them without a valid signature",
                                               s.rejected, s.not_authentic),
                                   s.not_authentic > 0 ? Tone::waits : Tone::plain}}));
}

}  // namespace

Row listed(const Watched& axis, const View& view, bool chosen) {
  Row row{{chosen ? "> " : "  ", Tone::strong},
          {padded(axis.name, 14), chosen ? Tone::chosen : Tone::plain}};
  if (!axis.status) {
    row.push_back({"no message yet", Tone::faint});
    return row;
  }
  const wire::Status& s = *axis.status;
  const std::string u = unit_of(s, view.ascii);
  const auto quiet = silent(axis, view);
  row.push_back(quiet ? Span{padded(fmt::format("silent for {:.0f} s", *quiet), 21), Tone::wrong}
                      : Span{padded(name(s.state), 21), tone_of(s.state)});
  const Tone tone = quiet ? Tone::faint : Tone::plain;
  row.push_back({padded(valued(s.slave_position, u), 17), tone});
  row.push_back({padded(valued(s.slave_velocity, u + "/s"), 17), tone});
  row.push_back({fault_of(s), Tone::wrong});
  return row;
}

std::vector<Row> details(const Watched& axis, const View& view) {
  std::vector<Row> rows;
  rows.push_back({{axis.name, Tone::strong}});
  if (!axis.status) return rows;
  const wire::Status& s = *axis.status;
  rows.push_back(s.last_error == 0 ? line("fault", {{"none", Tone::faint}})
                                   : line("fault", {{words_of(s.last_error), Tone::wrong}}));
  add_motion(rows, s, view);
  add_masters(rows, axis, view);
  add_group(rows, axis, view);
  const auto room = static_cast<std::size_t>(std::max(0, view.width - static_cast<int>(label)));
  rows.push_back(line("", {{sparkline(axis.trace, room, view.ascii), Tone::moves}}));
  rows.push_back(line("queue", queue_of(s, view.ascii)));
  rows.push_back(line("outputs", {{outputs_of(s.outputs)}}));
  if (!axis.events.empty())
    rows.push_back(line("event", {{fmt::format("{}: {}", axis.events.back().count,
                                               event_text(axis.events.back()))}}));
  rows.push_back(
      line("motions",
           {{fmt::format("{} finished, {} stopped", s.finished, s.stopped)},
            {s.reason == 0 ? std::string()
                           : fmt::format("; the last: {}", name(static_cast<Cause>(s.reason)))}}));
  add_health(rows, s, view);
  return rows;
}

}  // namespace jounce::machine_detail
