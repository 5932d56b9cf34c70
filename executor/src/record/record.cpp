// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/detail/record.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <type_traits>

#include "jounce/profiles/error.hpp"

#include "executor/src/record/record_wire.hpp"

namespace jounce {
namespace {

using namespace record_wire;

constexpr std::array<std::string_view, std::variant_size_v<RecordEvent>> channels{
    "JOUNCE.axis",         "JOUNCE.table",        "JOUNCE.job",          "JOUNCE.cycle",
    "JOUNCE.lost",         "JOUNCE.queue",        "JOUNCE.rows",         "JOUNCE.gear",
    "JOUNCE.master",       "JOUNCE.sight",        "JOUNCE.output",       "JOUNCE.sample",
    "JOUNCE.program",      "JOUNCE.registration", "JOUNCE.triggers",     "JOUNCE.check",
    "JOUNCE.compensation", "JOUNCE.references",   "JOUNCE.path_switches"};

template <class Wire>
std::string bytes_of(const Wire& w) {
  std::string bytes(static_cast<std::size_t>(w.getEncodedSize()), '\0');
  w.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  return bytes;
}

/// Decodes an event of a fixed-size LCM type. Only such types are permitted: their decoder cannot
/// read past the bytes. The first eight bytes are LCM's fingerprint of the fields. A record with
/// other fields (of another version) is therefore rejected.
template <class Wire>
RecordEvent event_of(std::string_view channel, std::string_view bytes) {
  Wire w{};
  const bool fits = bytes.size() == static_cast<std::size_t>(w.getEncodedSize());
  if (!fits || w.decode(bytes.data(), 0, static_cast<int>(bytes.size())) < 0)
    throw InputError("event", std::string(channel),
                     "has another type than this channel: replay the record with the version of "
                     "jounce that wrote it");
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

Sha256 continued(const Sha256& check, std::string_view channel, std::string_view bytes) {
  std::string all(check.begin(), check.end());
  all.append(channel).append(1, '\0').append(bytes);
  return sha256(all);
}

std::optional<RecordEvent> decoded(std::string_view channel, std::string_view bytes) {
  const auto it = std::find(channels.begin(), channels.end(), channel);
  if (it == channels.end()) return std::nullopt;
  using Decode = RecordEvent (*)(std::string_view, std::string_view);
  constexpr std::array<Decode, channels.size()> decoders{
      event_of<axis_t>,         event_of<table_t>,        event_of<job_t>,
      event_of<cycle_t>,        event_of<lost_t>,         event_of<queue_t>,
      event_of<rows_t>,         event_of<gear_t>,         event_of<master_t>,
      event_of<sight_t>,        event_of<output_t>,       event_of<sample_t>,
      event_of<program_t>,      event_of<registration_t>, event_of<triggers_t>,
      event_of<check_t>,        event_of<compensation_t>, event_of<references_t>,
      event_of<path_switches_t>};
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
  const Refusals refusals(replayed);
  std::optional<TickDifference> found;
  each_output(replayed, refusals, was,
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
