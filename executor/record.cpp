#include "jounce/executor/record.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>
#include <vector>

#include "jounce/executor/detail/record_fields.hpp"
#include "jounce/profiles/error.hpp"

#include "jounce_record/axis_t.hpp"
#include "jounce_record/cycle_t.hpp"
#include "jounce_record/gear_t.hpp"
#include "jounce_record/job_t.hpp"
#include "jounce_record/lost_t.hpp"
#include "jounce_record/master_t.hpp"
#include "jounce_record/output_t.hpp"
#include "jounce_record/queue_t.hpp"
#include "jounce_record/rows_t.hpp"
#include "jounce_record/sight_t.hpp"
#include "jounce_record/table_t.hpp"

namespace jounce {
namespace {

using namespace jounce_record;
using namespace record_fields;

constexpr std::int16_t version = 3;
constexpr std::size_t knots_an_event = 200;

template <std::size_t N>
void put_text(const std::string& text, std::uint8_t (&bytes)[N]) {
  std::memset(bytes, 0, N);
  std::memcpy(bytes, text.data(), std::min(text.size(), N - 1));
}

template <std::size_t N>
std::string get_text(const std::uint8_t (&bytes)[N]) {
  return {bytes, std::find(bytes, bytes + N, 0)};
}

// ---- events ---------------------------------------------------------------------------------------

axis_t on_wire(const RecordedAxis& a) {
  axis_t w{};
  w.version = version;
  w.axis = static_cast<std::int16_t>(a.axis);
  put_text(a.name, w.name);
  put_text(a.units.position, w.position_unit);
  put_text(a.units.x, w.master_unit);
  w.whole = a.whole ? 1 : 0;
  w.switches = a.switches ? 1 : 0;
  each_number(a.config, w, Put{});
  return w;
}

RecordedAxis ours(const axis_t& w) {
  if (w.version != version)
    throw InputError("version", std::to_string(w.version),
                     "of the record's types must be 3: another version of jounce wrote it");
  RecordedAxis a{.axis = static_cast<std::size_t>(w.axis),
                 .name = get_text(w.name),
                 .units = {get_text(w.master_unit), get_text(w.position_unit)},
                 .whole = w.whole != 0,
                 .switches = w.switches != 0};
  each_number(a.config, w, Get{});
  return a;
}

/// The columns that there are: x, p, v, a.
template <class C>
auto columns_of(C& c) {
  return std::array{&c.x, &c.p, &c.v, &c.a};
}

table_t on_wire(const RecordedTable& t) {
  table_t w{};
  std::copy(t.hash.begin(), t.hash.end(), w.hash);
  put_text(t.units.x, w.x_unit);
  put_text(t.units.position, w.position_unit);
  w.over = static_cast<std::int8_t>(t.over);
  w.rule = static_cast<std::int8_t>(t.rule);
  w.outside = static_cast<std::int8_t>(t.outside);
  w.knots = static_cast<std::int64_t>(t.knots);
  w.first = static_cast<std::int64_t>(t.first);
  w.count = static_cast<std::int32_t>(t.columns.x.size());
  const auto columns = columns_of(t.columns);
  for (std::size_t k = 0; k < columns.size() && !columns[k]->empty(); ++k) {
    w.columns = static_cast<std::int8_t>(k + 1);
    std::copy(columns[k]->begin(), columns[k]->end(), w.value[k]);
  }
  return w;
}

RecordedTable ours(const table_t& w) {
  if (w.count < 1 || w.count > static_cast<int>(knots_an_event) || w.first < 0 ||
      w.knots < w.first + w.count || w.knots > 1'000'000'000)
    throw InputError("knots",
                     std::to_string(w.first) + " and " + std::to_string(w.count) + " of " +
                         std::to_string(w.knots),
                     "is no part of a table");
  if (w.columns < 2 || w.columns > 4)
    throw InputError("columns", std::to_string(w.columns), "must be 2, 3 or 4");
  RecordedTable t{.units = {get_text(w.x_unit), get_text(w.position_unit)},
                  .knots = static_cast<std::size_t>(w.knots),
                  .first = static_cast<std::size_t>(w.first)};
  std::copy(std::begin(w.hash), std::end(w.hash), t.hash.begin());
  Get{}("over", t.over, w.over);
  Get{}("rule", t.rule, w.rule);
  Get{}("outside", t.outside, w.outside);
  const auto columns = columns_of(t.columns);
  for (std::size_t k = 0; k < static_cast<std::size_t>(w.columns); ++k)
    columns[k]->assign(w.value[k], w.value[k] + w.count);
  return t;
}

job_t on_wire(const RecordedJob& j) {
  job_t w{};
  w.axis = static_cast<std::int16_t>(j.axis);
  w.id = static_cast<std::int64_t>(j.id);
  std::copy(j.time.begin(), j.time.end(), w.time);
  if (j.cam) std::copy(j.cam->begin(), j.cam->end(), w.cam);
  w.live = j.live ? 1 : 0;
  w.tick = j.tick;
  w.position = j.position;
  each_coupling(j.coupling, w, Put{});
  return w;
}

RecordedJob ours(const job_t& w) {
  RecordedJob j{.axis = static_cast<std::size_t>(w.axis),
                .id = static_cast<std::uint64_t>(w.id),
                .live = w.live != 0,
                .tick = w.tick,
                .position = w.position};
  std::copy(std::begin(w.time), std::end(w.time), j.time.begin());
  if (std::any_of(std::begin(w.cam), std::end(w.cam), [](std::uint8_t b) { return b != 0; })) {
    j.cam.emplace();
    std::copy(std::begin(w.cam), std::end(w.cam), j.cam->begin());
  }
  each_coupling(j.coupling, w, Get{});
  return j;
}

cycle_t on_wire(const RecordedCycle& c) {
  cycle_t w{};
  w.axis = static_cast<std::int16_t>(c.axis);
  const Refusal refused = c.tick.refused.value_or(Refusal{});
  each_input(c, w, Put{});
  each_output(c.tick, refused, w, Put{});
  return w;
}

RecordedCycle ours(const cycle_t& w) {
  RecordedCycle c{.axis = static_cast<std::size_t>(w.axis)};
  Refusal refused;
  each_input(c, w, Get{});
  each_output(c.tick, refused, w, Get{});
  if (refused.cause != Cause::none) c.tick.refused = refused;
  return c;
}

lost_t on_wire(const RecordedLoss& l) {
  lost_t w{};
  w.cycles = l.cycles;
  return w;
}

RecordedLoss ours(const lost_t& w) {
  return {w.cycles};
}

gear_t on_wire(const RecordedGear& g) {
  gear_t w{};
  w.axis = static_cast<std::int16_t>(g.axis);
  w.id = static_cast<std::int64_t>(g.id);
  w.kind = static_cast<std::int8_t>(g.kind);
  std::copy(g.value.begin(), g.value.end(), w.value);
  w.position = g.position;
  return w;
}

RecordedGear ours(const gear_t& w) {
  RecordedGear g{.axis = static_cast<std::size_t>(w.axis),
                 .id = static_cast<std::uint64_t>(w.id),
                 .position = w.position};
  Get{}("kind", g.kind, w.kind);
  if (g.kind != wire::OrderKind::gear_in && g.kind != wire::OrderKind::gear_in_pos)
    throw InputError("kind", std::to_string(w.kind), "is no order of a gear");
  std::copy(std::begin(w.value), std::end(w.value), g.value.begin());
  return g;
}

queue_t on_wire(const RecordedQueue& q) {
  queue_t w{};
  w.axis = static_cast<std::int16_t>(q.axis);
  w.id = static_cast<std::int64_t>(q.id);
  w.over = static_cast<std::int8_t>(q.queue.axis);
  w.mode = static_cast<std::int8_t>(q.queue.mode);
  w.capacity = q.queue.capacity;
  w.loops = q.queue.loops;
  w.event = static_cast<std::int8_t>(q.queue.event);
  w.event_position = q.queue.event_position;
  w.event_direction = q.queue.event_direction;
  return w;
}

RecordedQueue ours(const queue_t& w) {
  RecordedQueue q{.axis = static_cast<std::size_t>(w.axis), .id = static_cast<std::uint64_t>(w.id)};
  Get{}("over", q.queue.axis, w.over);
  Get{}("mode", q.queue.mode, w.mode);
  Get{}("event", q.queue.event, w.event);
  if (w.capacity < 1 || w.capacity > 1'000'000)
    throw InputError("capacity", std::to_string(w.capacity), "must be from 1 to 1e6 rows");
  q.queue.capacity = static_cast<std::uint32_t>(w.capacity);
  q.queue.loops = static_cast<std::int32_t>(w.loops);
  q.queue.event_position = w.event_position;
  q.queue.event_direction = static_cast<std::int8_t>(w.event_direction);
  return q;
}

rows_t on_wire(const RecordedRows& r) {
  rows_t w{};
  w.axis = static_cast<std::int16_t>(r.axis);
  w.id = static_cast<std::int64_t>(r.what.movement);
  w.number = static_cast<std::int64_t>(r.what.number);
  w.kind = static_cast<std::int8_t>(r.what.kind);
  w.bank = static_cast<std::int8_t>(r.what.bank);
  w.count = static_cast<std::int32_t>(r.what.rows.size());
  for (std::size_t i = 0; i < r.what.rows.size(); ++i) {
    const SegmentRow& row = r.what.rows[i];
    const std::array value{row.x_end, row.p_end, row.v_start, row.v_end, row.a_start, row.a_end};
    std::copy(value.begin(), value.end(), w.value[i]);
    w.degree[i] = static_cast<std::int8_t>(row.degree);
    w.last[i] = row.last ? 1 : 0;
  }
  return w;
}

RecordedRows ours(const rows_t& w) {
  RecordedRows r{.axis = static_cast<std::size_t>(w.axis)};
  r.what.movement = static_cast<std::uint64_t>(w.id);
  r.what.number = static_cast<std::uint64_t>(w.number);
  Get{}("kind", r.what.kind, w.kind);
  if (w.bank < 0 || w.bank > 1) throw InputError("bank", std::to_string(w.bank), "must be 0 or 1");
  if (w.count < 0 || w.count > static_cast<int>(HandedOver::most_rows))
    throw InputError("count", std::to_string(w.count), "must be from 0 to 32 rows");
  r.what.bank = w.bank;
  for (int i = 0; i < w.count; ++i) {
    const auto& v = w.value[i];
    r.what.rows.push_back({v[0], v[1], v[2], v[3], v[4], v[5], w.degree[i], w.last[i] != 0});
  }
  return r;
}

master_t on_wire(const RecordedMaster& m) {
  master_t w{};
  w.master = static_cast<std::int16_t>(m.master);
  put_text(m.name, w.name);
  put_text(m.unit, w.unit);
  w.followers = static_cast<std::int64_t>(m.followers);
  return w;
}

RecordedMaster ours(const master_t& w) {
  return {.master = static_cast<std::size_t>(w.master),
          .name = get_text(w.name),
          .unit = get_text(w.unit),
          .followers = static_cast<std::uint64_t>(w.followers)};
}

sight_t on_wire(const RecordedSight& s) {
  sight_t w{};
  w.master = static_cast<std::int16_t>(s.master);
  w.tick = s.sight.tick;
  std::copy(s.sight.at.begin(), s.sight.at.end(), w.at);
  w.age = s.sight.age;
  return w;
}

RecordedSight ours(const sight_t& w) {
  RecordedSight s{.master = static_cast<std::size_t>(w.master),
                  .sight = {.tick = w.tick, .age = w.age}};
  std::copy(std::begin(w.at), std::end(w.at), s.sight.at.begin());
  return s;
}

/// f(name, ours, theirs) for every number.
template <class Ours, class Theirs, class F>
void each_of_output(Ours& o, Theirs& w, F f) {
  f("part", o.part, w.part);
  f("of", o.of, w.of);
  f("period", o.period, w.period);
  f("first_on_position", o.cam_switch.first_on_position, w.first_on_position);
  f("last_on_position", o.cam_switch.last_on_position, w.last_on_position);
  f("axis_direction", o.cam_switch.axis_direction, w.axis_direction);
  f("switch_mode", o.cam_switch.mode, w.switch_mode);
  f("duration", o.cam_switch.duration, w.duration);
  f("on_compensation", o.track.on_compensation, w.on_compensation);
  f("off_compensation", o.track.off_compensation, w.off_compensation);
  f("hysteresis", o.track.hysteresis, w.hysteresis);
  f("inverted", o.track.inverted, w.inverted);
  f("enabled", o.track.enabled, w.enabled);
  f("initial", o.track.initial, w.initial);
  f("compare_mode", o.mode, w.compare_mode);
  f("pulse", o.pulse, w.pulse);
  f("points", o.points, w.points);
}

output_t on_wire(const RecordedOutput& o) {
  output_t w{};
  w.axis = static_cast<std::int16_t>(o.axis);
  each_of_output(o, w, Put{});
  const bool track = o.part == RecordedOutput::Part::track;
  w.track = static_cast<std::int8_t>(track ? o.track.track : o.cam_switch.track);
  w.count = static_cast<std::int32_t>(o.some.size());
  for (std::size_t i = 0; i < o.some.size(); ++i) {
    w.position[i] = o.some[i].position;
    w.level[i] = o.some[i].level ? 1 : 0;
  }
  return w;
}

RecordedOutput ours(const output_t& w) {
  RecordedOutput o{.axis = static_cast<std::size_t>(w.axis)};
  each_of_output(o, w, Get{});
  o.cam_switch.track = o.track.track = w.track;
  if (w.points < 0 || w.points > static_cast<std::int64_t>(RecordedOutput::longest))
    throw InputError("points", std::to_string(w.points), "must be from 0 to 100000");
  if (w.compare_mode == 0) throw InputError("compare_mode", "0", "must be from 1 to 6");
  if (w.count < 0 || w.count > static_cast<int>(RecordedOutput::most_points))
    throw InputError("count", std::to_string(w.count), "must be from 0 to 64 points");
  for (int i = 0; i < w.count; ++i) o.some.push_back({w.position[i], w.level[i] != 0});
  return o;
}

constexpr std::array<std::string_view, std::variant_size_v<RecordEvent>> channels{
    "JOUNCE.axis", "JOUNCE.table", "JOUNCE.job",    "JOUNCE.cycle", "JOUNCE.lost",  "JOUNCE.queue",
    "JOUNCE.rows", "JOUNCE.gear",  "JOUNCE.master", "JOUNCE.sight", "JOUNCE.output"};

template <class Wire>
std::string bytes_of(const Wire& w) {
  std::string bytes(static_cast<std::size_t>(w.getEncodedSize()), '\0');
  w.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  return bytes;
}

/// Fixed-size types only: their decoder cannot be led beyond the bytes. The first eight of them are LCM's
/// fingerprint of the type's fields, so that a record of other fields (another version's) is refused.
template <class Wire>
RecordEvent event_of(std::string_view channel, std::string_view bytes) {
  Wire w{};
  const bool fits = bytes.size() == static_cast<std::size_t>(w.getEncodedSize());
  if (!fits || w.decode(bytes.data(), 0, static_cast<int>(bytes.size())) < 0)
    throw InputError(
        "event", std::string(channel),
        "is not of the type that this channel has: a record is replayed by the version "
        "of jounce that wrote it");
  return ours(w);
}

std::int16_t number_of(const RecordEvent& event) {
  return std::visit(
      [](const auto& e) -> std::int16_t {
        if constexpr (requires { e.axis; }) return static_cast<std::int16_t>(e.axis);
        if constexpr (requires { e.master; }) return static_cast<std::int16_t>(e.master);
        return 0;
      },
      event);
}

}  // namespace

std::string_view channel_of(const RecordEvent& event) {
  return channels[event.index()];
}

std::string encoded(const RecordEvent& event) {
  return std::visit([](const auto& e) { return bytes_of(on_wire(e)); }, event);
}

std::optional<RecordEvent> decoded(std::string_view channel, std::string_view bytes) {
  const auto it = std::find(channels.begin(), channels.end(), channel);
  if (it == channels.end()) return std::nullopt;
  using Decode = RecordEvent (*)(std::string_view, std::string_view);
  constexpr std::array<Decode, channels.size()> decoders{
      event_of<axis_t>,   event_of<table_t>, event_of<job_t>,   event_of<cycle_t>,
      event_of<lost_t>,   event_of<queue_t>, event_of<rows_t>,  event_of<gear_t>,
      event_of<master_t>, event_of<sight_t>, event_of<output_t>};
  RecordEvent event = decoders[static_cast<std::size_t>(it - channels.begin())](channel, bytes);
  if (number_of(event) < 0)
    throw InputError("axis or master", std::to_string(number_of(event)), "must not be negative");
  return event;
}

namespace {
bool of_outputs(std::string_view name) {
  return name == "outputs" || name == "switch_edge" || name == "compare" || name == "compare_edge";
}
}  // namespace

std::optional<TickDifference> first_difference(const Tick& recorded, const Tick& replayed,
                                               bool switches) {
  const cycle_t was = on_wire(RecordedCycle{.tick = recorded});
  const Refusal refused = replayed.refused.value_or(Refusal{});
  std::optional<TickDifference> found;
  each_output(replayed, refused, was,
              [&](std::string_view name, const auto& ours, const auto& theirs) {
                using T = std::decay_t<decltype(theirs)>;
                const auto now = static_cast<T>(ours);
                bool same = now == theirs;
                if constexpr (std::is_same_v<T, double>)
                  same = std::bit_cast<std::uint64_t>(now) == std::bit_cast<std::uint64_t>(theirs);
                if (same || found || (of_outputs(name) && !switches)) return;
                found = {std::string(name), static_cast<double>(theirs), static_cast<double>(now)};
              });
  return found;
}

}  // namespace jounce
