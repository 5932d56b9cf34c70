#include "dashboard.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "jounce/axis/cause.hpp"
#include "jounce/executor/histogram.hpp"

namespace jounce::cli {
namespace {

constexpr std::size_t label = 12;  // columns before a value
constexpr std::size_t bar_width = 20;
constexpr Nanos trace_period = std::chrono::milliseconds(100);

bool continues(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

std::size_t columns(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return !continues(c); }));
}

/// What came over the wire, as a terminal may be given it: no control character, not even one of two bytes.
std::string harmless(std::string_view text, bool ascii) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (c < 0x80U) {
      out += c < 0x20U || c == 0x7FU ? '?' : text[i];
      continue;
    }
    std::size_t end = i + 1;
    while (end < text.size() && continues(text[end])) ++end;
    const bool control =
        c == 0xC2U && end == i + 2 && static_cast<unsigned char>(text[i + 1]) < 0xA0U;
    if (ascii || control || continues(text[i]))
      out += '?';
    else
      out += text.substr(i, end - i);
    i = end - 1;
  }
  return out;
}

/// Cut to so many columns.
std::string cut(std::string_view text, std::size_t width) {
  std::size_t end = 0;
  for (std::size_t column = 0; end < text.size() && column < width; ++column) {
    ++end;
    while (end < text.size() && continues(text[end])) ++end;
  }
  return std::string(text.substr(0, end));
}

std::string padded(std::string_view text, std::size_t width) {
  std::string out = cut(text, width);
  out.append(width - columns(out), ' ');
  return out;
}

constexpr std::array<const char*, 9> blocks{" ", "▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
constexpr std::array<const char*, 9> marks{" ", ".", ":", "-", "=", "+", "*", "#", "@"};

/// A column that is filled by a share of 0 to 1.
const char* column(double share, bool ascii) {
  const auto level = static_cast<std::size_t>(std::lround(std::clamp(share, 0.0, 1.0) * 8));
  return (ascii ? marks : blocks)[level];
}

std::string bar(double share, bool ascii) {
  const auto full = static_cast<std::size_t>(
      std::lround(std::clamp(share, 0.0, 1.0) * static_cast<double>(bar_width)));
  std::string text;
  for (std::size_t i = 0; i < bar_width; ++i)
    text += i < full ? (ascii ? "#" : "█") : (ascii ? "." : "░");
  return text;
}

/// By the logarithm, or nothing but the most frequent class would be seen.
std::string histogram(const wire::Histogram& counts, bool ascii) {
  const double most = std::log1p(*std::max_element(counts.begin(), counts.end()));
  std::string text;
  for (const std::int32_t n : counts) {
    // One cycle among millions is seen too.
    const double share = n <= 0 ? 0 : std::max(1.0 / 8, std::log1p(n) / most);
    text += column(share, ascii);
  }
  return text;
}

std::string within(const wire::Histogram& counts) {
  const double us = upper_bound(counts, 0.999);
  if (us == 0) return "";
  return std::isinf(us) ? "99.9 % not within 16384 us" : fmt::format("99.9 % within {} us", us);
}

Tone tone_of(wire::AxisState state) {
  using State = wire::AxisState;
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

std::string valued(double value, const std::string& unit) {
  return std::isnan(value) ? "not known" : fmt::format("{:.6g} {}", value, unit);
}

/// Where the chosen axis is among all; 0 where it is none of them.
std::size_t index_of(const std::vector<Watched>& axes, const std::string& name) {
  const auto found =
      std::find_if(axes.begin(), axes.end(), [&](const Watched& a) { return a.name == name; });
  return found == axes.end() ? 0 : static_cast<std::size_t>(found - axes.begin());
}

/// Seconds since it was last heard, if these are too many.
std::optional<double> silent(const Watched& axis, const View& view) {
  const Nanos since = view.now - axis.heard;
  if (since <= view.silence) return std::nullopt;
  return std::chrono::duration<double>(since).count();
}

std::string fault_of(const wire::Status& s) {
  if (s.last_error == 0) return "";
  return fmt::format("{} {}", s.last_error, name(static_cast<Cause>(s.last_error)));
}

/// The line of an axis in the list.
Row listed(const Watched& axis, const View& view, bool chosen) {
  Row row{{chosen ? "> " : "  ", Tone::strong},
          {padded(axis.name, 14), chosen ? Tone::chosen : Tone::plain}};
  if (!axis.status) {
    row.push_back({"not heard yet", Tone::faint});
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
  std::string doing = name(s.progress);
  if (s.next != wire::Next::nothing) doing += fmt::format(", next: {}", name(s.next));
  rows.push_back(
      line("state", {{padded(name(s.state), 21), tone_of(s.state)}, {"motion " + doing}}));
  std::string position = padded(valued(s.slave_position, u), 21);
  if (!std::isnan(s.master_position))
    position += "master " + valued(s.master_position, harmless(s.units.x, view.ascii));
  rows.push_back(line("position", {{position, Tone::strong}}));
  rows.push_back(
      line("velocity",
           {{padded(valued(s.slave_velocity, u + "/s"), 21) + "torque " +
             (std::isnan(s.torque) ? "not known" : fmt::format("{:.0f} %", 100 * s.torque))}}));
  rows.push_back(line("actual", {{padded(valued(s.actual_position, u), 21) + "following error " +
                                  valued(s.following_error, u)}}));
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
    rows.push_back(
        line("master", {{said_of(master, view.ascii), master.lost ? Tone::wrong : Tone::plain}}));
}

/// The cycle and the link: what is late, what was refused.
void add_health(std::vector<Row>& rows, const wire::Status& s, const View& view) {
  rows.push_back(
      line("late",
           {{fmt::format("{} cycles", s.late_ticks), s.late_ticks > 0 ? Tone::waits : Tone::plain},
            {fmt::format(" of {} ms, tick {}", static_cast<double>(s.cycle_ns) * 1e-6, s.tick)}}));
  for (const auto& [text, counts] :
       {std::pair{"wake-up", &s.lateness}, {"computing", &s.computing}})
    rows.push_back(line(text, {{histogram(*counts, view.ascii), Tone::moves},
                               {" 1 us to 16 ms  " + within(*counts), Tone::faint}}));
  rows.push_back(line(
      "packets", {{fmt::format("{} refused, {} of them not authentic", s.rejected, s.not_authentic),
                   s.not_authentic > 0 ? Tone::waits : Tone::plain}}));
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
  const auto room = static_cast<std::size_t>(std::max(0, view.width - static_cast<int>(label)));
  rows.push_back(line("", {{sparkline(axis.trace, room, view.ascii), Tone::moves}}));
  rows.push_back(line("queue", queue_of(s, view.ascii)));
  rows.push_back(line("outputs", {{outputs_of(s.outputs)}}));
  rows.push_back(
      line("motions",
           {{fmt::format("{} finished, {} stopped", s.finished, s.stopped)},
            {s.reason == 0 ? std::string()
                           : fmt::format("; the last: {}", name(static_cast<Cause>(s.reason)))}}));
  add_health(rows, s, view);
  return rows;
}

Row last_row(const View& view) {
  if (view.asks) return {{"Stop " + view.chosen + "?  y: yes  any other key: no", Tone::wrong}};
  Row row{{view.ascii ? "up/down axis  h hold  r resume  s stop  q quit"
                      : "↑↓ axis  h hold  r resume  s stop  q quit",
           Tone::faint}};
  if (!view.note.empty()) row.push_back({"   " + view.note, Tone::strong});
  return row;
}

/// Cut to the screen.
void fit(Row& row, int width) {
  std::size_t left = static_cast<std::size_t>(std::max(width, 0));
  for (Span& span : row) {
    span.text = cut(span.text, left);
    left -= columns(span.text);
  }
}

}  // namespace

void hear(std::vector<Watched>& axes, const std::string& name, const wire::Status& status,
          Nanos now) {
  const auto place = std::lower_bound(axes.begin(), axes.end(), name,
                                      [](const Watched& a, const auto& n) { return a.name < n; });
  Watched& axis = place != axes.end() && place->name == name
                      ? *place
                      : *axes.insert(place, Watched{.name = name});
  axis.status = status;
  axis.heard = now;
  if (!axis.trace.empty() && now - axis.traced_at < trace_period) return;
  axis.traced_at = now;
  axis.trace.push_back(status.slave_position);
  if (axis.trace.size() > Watched::traced) axis.trace.pop_front();
}

void hear(std::vector<Watched>& axes, const std::string& name, const wire::MasterStatus& master) {
  const auto axis =
      std::find_if(axes.begin(), axes.end(), [&](const Watched& a) { return a.name == name; });
  if (axis == axes.end() || !axis->status) return;
  // An executor that was started again may have other masters.
  std::erase_if(axis->masters, [&](const auto& m) { return m.boot != master.boot; });
  auto& all = axis->masters;
  const auto place = std::lower_bound(all.begin(), all.end(), master.master,
                                      [](const auto& m, const auto& n) { return m.master < n; });
  if (place != all.end() && place->master == master.master)
    *place = master;
  else
    all.insert(place, master);
}

std::string said_of(const wire::MasterStatus& master, bool ascii) {
  const std::string unit = harmless(master.unit, ascii);
  const std::string age = std::isnan(master.age_s) ? std::string("never measured")
                          : master.age_s == 0
                              ? std::string("computed")
                              : fmt::format("measured {:.3g} ms ago", 1e3 * master.age_s);
  // Somebody speaks, and does not count: the executor's terminal says why.
  const std::string refused =
      master.refused > 0
          ? fmt::format(", {} samples refused (old epoch, unit or repeated)", master.refused)
          : "";
  if (master.lost) return fmt::format("{} is lost, {}{}", master.master, age, refused);
  return fmt::format("{} {}, {}, {}", master.master, valued(master.position, unit),
                     valued(master.velocity, unit + "/s"), age);
}

std::string sparkline(const std::deque<double>& values, std::size_t width, bool ascii) {
  const std::size_t from = values.size() > width ? values.size() - width : 0;
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(from);
  if (begin == values.end()) return "";
  const auto [low, high] = std::minmax_element(begin, values.end());
  const double least = *low;
  const double range = *high - least;
  std::string text;
  // The lowest one is a line too: an axis that rests is there.
  for (auto v = begin; v != values.end(); ++v)
    text += column(range > 0 ? 1.0 / 8 + 7.0 / 8 * (*v - least) / range : 1.0 / 8, ascii);
  return text;
}

std::vector<Row> dashboard(const std::vector<Watched>& axes, const View& view) {
  std::vector<Row> rows;
  rows.push_back({{padded("  axis", 16) + padded("state", 21) + padded("position", 17) +
                       padded("velocity", 17) + "fault",
                   Tone::faint}});
  if (axes.empty()) rows.push_back({{"  nothing is heard yet", Tone::faint}});
  const std::size_t at = index_of(axes, view.chosen);
  const std::vector<Row> chosen = axes.empty() ? std::vector<Row>{} : details(axes[at], view);
  // The list gives way to the details, down to three axes; the chosen one is always among them.
  const int room = std::max(3, view.height - 3 - static_cast<int>(chosen.size()));
  const std::size_t shown = std::min(axes.size(), static_cast<std::size_t>(room));
  const std::size_t first = at >= shown ? at + 1 - shown : 0;
  for (std::size_t i = first; i < std::min(axes.size(), first + shown); ++i)
    rows.push_back(listed(axes[i], view, i == at));
  rows.emplace_back();
  rows.insert(rows.end(), chosen.begin(), chosen.end());
  rows.resize(std::min(rows.size(), static_cast<std::size_t>(std::max(view.height - 1, 0))));
  if (view.height > 0) rows.push_back(last_row(view));
  for (Row& row : rows) fit(row, view.width);
  return rows;
}

Wish press(View& view, const std::vector<Watched>& axes, Key key) {
  const auto c = static_cast<int>(key);
  if (c == 'q') return Wish::quit;
  if (view.asks) {
    view.asks = false;
    view.note = c == 'y' ? "" : "not stopped";
    return c == 'y' ? Wish::stop : Wish::nothing;
  }
  if (axes.empty()) return Wish::nothing;
  const std::size_t at = index_of(axes, view.chosen);
  const std::size_t step = key == Key::up ? axes.size() - 1 : key == Key::down || c == '\t' ? 1 : 0;
  view.chosen = axes[(at + step) % axes.size()].name;
  if (step > 0) view.note.clear();
  view.asks = c == 's';
  return c == 'h' ? Wish::hold : c == 'r' ? Wish::resume : Wish::nothing;
}

}  // namespace jounce::cli
