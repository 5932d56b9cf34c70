// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/message/message.hpp"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace jounce::wire {
namespace {

bool is_name_character(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-';
}

}  // namespace

const char* name(ArmMode mode) {
  switch (mode) {
    case ArmMode::play:
      return "play";
    case ArmMode::follow_input:
      return "follow_input";
    case ArmMode::follow_table:
      return "follow_table";
    case ArmMode::path:
      return "path";
    case ArmMode::queue:
      break;
  }
  return "queue";
}

const char* name(Next next) {
  constexpr const char* names[] = {"nothing", "armed", "waiting"};
  return names[static_cast<std::size_t>(next)];
}

const char* name(Progress progress) {
  constexpr const char* names[] = {"none",     "waiting", "engaging", "running",
                                   "starving", "done",    "broken"};
  return names[static_cast<std::size_t>(progress)];
}

const char* name(GearState gear) {
  constexpr const char* names[] = {"no master", "disengaged", "engaging", "in gear", "in cam"};
  return names[static_cast<std::size_t>(gear)];
}

const char* name(EventKind kind) {
  constexpr const char* names[] = {"compare", "track",          "tappet",      "probe",
                                   "mark",    "end_of_profile", "table_begin", "m_word"};
  return names[static_cast<std::size_t>(kind)];
}

Cut cut(Interpolation rule, std::uint32_t knots, std::size_t values) {
  const std::uint32_t columns = rule == Interpolation::linear          ? 2
                                : rule == Interpolation::cubic_hermite ? 3
                                                                       : 4;
  Header header;
  header.knots = knots;
  header.columns = columns;
  header.per_chunk = static_cast<std::uint32_t>(values) / columns;
  return cut(header);
}

Cut cut(const Header& header) {
  const auto [whole, rest] = std::div(std::int64_t{header.knots}, std::int64_t{header.per_chunk});
  return {.columns = header.columns,
          .per_chunk = header.per_chunk,
          .chunks = static_cast<std::uint32_t>(whole + (rest > 0 ? 1 : 0))};
}

std::uint32_t Cut::chunks_for(std::uint32_t messages) const {
  const std::size_t values = std::max(std::size_t{per_chunk} * columns, credit_values);
  return static_cast<std::uint32_t>(std::max(messages * credit_values / values, std::size_t{1}));
}

std::uint32_t Cut::knots_of(std::uint32_t seq, std::uint32_t knots) const {
  assert(seq < chunks);
  return std::min(per_chunk, knots - seq * per_chunk);
}

bool is_executor_name(std::string_view name) {
  return !name.empty() && name.size() < executor_bytes &&
         std::all_of(name.begin(), name.end(), is_name_character);
}

}  // namespace jounce::wire
