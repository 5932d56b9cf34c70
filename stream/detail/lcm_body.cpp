#include "jounce/stream/detail/lcm_body.hpp"

#include <algorithm>
#include <bit>
#include <concepts>
#include <limits>
#include <optional>

#include "jounce/profiles/error.hpp"

namespace jounce::wire {
namespace {

// The numbers on the wire are those of the enumerations.
static_assert(static_cast<int>(Axis::time) == 0 && static_cast<int>(Axis::master) == 1);
static_assert(static_cast<int>(Rule::linear) == 0 && static_cast<int>(Rule::cubic_hermite) == 1 &&
              static_cast<int>(Rule::quintic_hermite) == 2);
static_assert(static_cast<int>(Outside::refuse) == 0 && static_cast<int>(Outside::hold) == 1 &&
              static_cast<int>(Outside::wrap) == 2 && static_cast<int>(Outside::advance) == 3);

template <class Enum>
constexpr int last_of = 0;
template <>
constexpr int last_of<Axis> = static_cast<int>(Axis::master);
template <>
constexpr int last_of<Rule> = static_cast<int>(Rule::quintic_hermite);
template <>
constexpr int last_of<Outside> = static_cast<int>(Outside::advance);
template <>
constexpr int last_of<StartMode> = static_cast<int>(StartMode::ramp_in_distance);
template <>
constexpr int last_of<ArmMode> = static_cast<int>(ArmMode::follow_table);
template <>
constexpr int last_of<StopMode> = static_cast<int>(StopMode::abort);
template <>
constexpr int last_of<Refusal> = static_cast<int>(Refusal::axis);
template <>
constexpr int last_of<Outcome> = static_cast<int>(Outcome::refused);
template <>
constexpr int last_of<AxisState> = static_cast<int>(AxisState::error_stop);
template <>
constexpr int last_of<Next> = static_cast<int>(Next::waiting);

template <class Enum>
std::int8_t number_of(Enum value) {
  return static_cast<std::int8_t>(value);
}

template <class Enum>
bool get_enum(std::int8_t number, Enum& value) {
  if (number < 0 || number > last_of<Enum>) return false;
  value = static_cast<Enum>(number);
  return true;
}

bool get_flag(std::int8_t number, bool& value) {
  value = number == 1;
  return number == 0 || number == 1;
}

std::int32_t put_count(const char* key, std::uint32_t count) {
  if (count > static_cast<std::uint32_t>(std::numeric_limits<std::int32_t>::max()))
    throw InputError(key, std::to_string(count), "must fit 31 bits");
  return static_cast<std::int32_t>(count);
}

bool get_count(std::int32_t number, std::uint32_t& count) {
  count = static_cast<std::uint32_t>(number);
  return number >= 0;
}

bool get_command(std::int32_t number, std::int32_t& command) {
  command = number;
  return number >= 1;
}

void put_unit(const char* key, const std::string& unit, std::uint8_t* bytes) {
  if (unit.size() >= unit_bytes)
    throw InputError(key, unit, "must be shorter than " + std::to_string(unit_bytes) + " bytes");
  put_text(unit, bytes, unit_bytes);
  if (std::string back; !get_text(bytes, unit_bytes, back) || back != unit)
    throw InputError(key, unit, "must not contain control characters");
}

/// As much of the text as fits, without half a UTF-8 character at the end.
std::string_view shortened(std::string_view text, std::size_t size) {
  if (text.size() < size) return text;
  std::size_t end = size - 1;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.substr(0, end);
}

template <std::size_t N>
void put_bytes(const std::array<std::uint8_t, N>& from, std::uint8_t (&to)[N]) {
  std::copy(from.begin(), from.end(), to);
}

template <std::size_t N>
bool get_bytes(const std::uint8_t (&from)[N], std::array<std::uint8_t, N>& to) {
  std::copy(from, from + N, to.begin());
  return true;
}

double put_magnitude(const std::optional<double>& value) {
  return value.value_or(0);
}

bool get_magnitude(double number, std::optional<double>& value) {
  if (number != 0) value = number;
  return number >= 0;
}

void put(const CouplingSpec& from, jounce_lcm::coupling_t& to) {
  to.start = number_of(from.start);
  to.master_absolute = from.master_absolute ? 1 : 0;
  to.slave_absolute = from.slave_absolute ? 1 : 0;
  to.master_scaling = from.master_scaling;
  to.master_offset = from.master_offset;
  to.slave_scaling = from.slave_scaling;
  to.slave_offset = from.slave_offset;
  to.velocity_diff = put_magnitude(from.velocity_diff);
  to.acceleration = put_magnitude(from.acceleration);
  to.deceleration = put_magnitude(from.deceleration);
  to.jerk = put_magnitude(from.jerk);
  to.distance = put_magnitude(from.distance);
  to.slave_period = put_magnitude(from.slave_period);
}

/// Whole, and such that a coupling can be made of it.
bool get(const jounce_lcm::coupling_t& from, CouplingSpec& to) {
  to.master_scaling = from.master_scaling;
  to.master_offset = from.master_offset;
  to.slave_scaling = from.slave_scaling;
  to.slave_offset = from.slave_offset;
  if (!get_enum(from.start, to.start) || !get_flag(from.master_absolute, to.master_absolute) ||
      !get_flag(from.slave_absolute, to.slave_absolute) ||
      !get_magnitude(from.velocity_diff, to.velocity_diff) ||
      !get_magnitude(from.acceleration, to.acceleration) ||
      !get_magnitude(from.deceleration, to.deceleration) || !get_magnitude(from.jerk, to.jerk) ||
      !get_magnitude(from.distance, to.distance) ||
      !get_magnitude(from.slave_period, to.slave_period))
    return false;
  try {
    require_valid(to);
  } catch (const InputError&) {
    return false;
  }
  return true;
}

}  // namespace

void put_text(std::string_view text, std::uint8_t* bytes, std::size_t size) {
  const std::string_view fits = shortened(text, size);
  std::fill_n(bytes, size, std::uint8_t{0});
  // A control character has no place in a name, a unit or a sentence.
  std::transform(fits.begin(), fits.end(), bytes, [](char c) {
    const auto byte = static_cast<std::uint8_t>(c);
    return byte < 0x20 ? std::uint8_t{' '} : byte;
  });
}

bool get_text(const std::uint8_t* bytes, std::size_t size, std::string& text) {
  const auto* const end = std::find(bytes, bytes + size, std::uint8_t{0});
  text.assign(bytes, end);
  return end != bytes + size &&
         std::all_of(end, bytes + size, [](std::uint8_t byte) { return byte == 0; }) &&
         std::all_of(bytes, end, [](std::uint8_t byte) { return byte >= 0x20; });
}

void put(const Header& from, jounce_lcm::header_t& to) {
  to.table = put_count("table", from.table);
  put_bytes(from.hash, to.hash);
  to.axis = number_of(from.axis);
  to.rule = number_of(from.rule);
  to.outside = number_of(from.outside);
  put_unit("unit of x", from.units.x, to.unit_x);
  put_unit("unit of position", from.units.position, to.unit_position);
  to.knots = put_count("knots", from.knots);
  to.columns = put_count("columns", from.columns);
  to.chunks = put_count("chunks", from.chunks);
}

bool get(const jounce_lcm::header_t& from, Header& to) {
  return get_count(from.table, to.table) && to.table < most_tables &&
         get_bytes(from.hash, to.hash) && get_enum(from.axis, to.axis) &&
         get_enum(from.rule, to.rule) && get_enum(from.outside, to.outside) &&
         get_text(from.unit_x, unit_bytes, to.units.x) &&
         get_text(from.unit_position, unit_bytes, to.units.position) &&
         get_count(from.knots, to.knots) && get_count(from.columns, to.columns) &&
         get_count(from.chunks, to.chunks);
}

void put(const Chunk& from, jounce_lcm::chunk_t& to) {
  if (from.values.size() > chunk_values) {
    throw InputError("values", std::to_string(from.values.size()),
                     "a chunk holds at most " + std::to_string(chunk_values));
  }
  to.table = put_count("table", from.table);
  to.seq = put_count("seq", from.seq);
  to.first_knot = put_count("first_knot", from.first_knot);
  to.knots = put_count("knots", from.knots);
  to.columns = put_count("columns", from.columns);
  std::copy(from.values.begin(), from.values.end(), to.values);
}

bool get(const jounce_lcm::chunk_t& from, Chunk& to) {
  if (!get_count(from.table, to.table) || to.table >= most_tables || !get_count(from.seq, to.seq) ||
      !get_count(from.first_knot, to.first_knot) || !get_count(from.knots, to.knots) ||
      !get_count(from.columns, to.columns))
    return false;
  if (to.columns < 2 || to.columns > 4 || to.knots < 1 || to.knots > chunk_values / to.columns)
    return false;
  const double* const end = from.values + std::size_t{to.knots} * to.columns;
  to.values.assign(from.values, end);
  return std::all_of(end, from.values + chunk_values,
                     [](double unused) { return std::bit_cast<std::uint64_t>(unused) == 0; });
}

void put(const Arm& from, jounce_lcm::arm_t& to) {
  to.command = from.command;
  to.mode = number_of(from.mode);
  put_bytes(from.slave, to.slave_hash);
  put_bytes(from.master, to.master_hash);
  require_valid(from.coupling);
  put(from.coupling, to.coupling);
}

bool get(const jounce_lcm::arm_t& from, Arm& to) {
  return get_command(from.command, to.command) && get_enum(from.mode, to.mode) &&
         get_bytes(from.slave_hash, to.slave) && get_bytes(from.master_hash, to.master) &&
         get(from.coupling, to.coupling);
}

void put(const Start& from, jounce_lcm::start_t& to) {
  to.command = from.command;
  to.start_tick = from.tick;
}

bool get(const jounce_lcm::start_t& from, Start& to) {
  to.tick = from.start_tick;
  return get_command(from.command, to.command) && to.tick >= -1;
}

void put(const Stop& from, jounce_lcm::stop_t& to) {
  to.command = from.command;
  to.stop_mode = number_of(from.mode);
}

bool get(const jounce_lcm::stop_t& from, Stop& to) {
  return get_command(from.command, to.command) && get_enum(from.stop_mode, to.mode);
}

void put(const Heartbeat& from, jounce_lcm::heartbeat_t& to) {
  to.command = from.command;
  to.release = from.release ? 1 : 0;
}

bool get(const jounce_lcm::heartbeat_t& from, Heartbeat& to) {
  return get_command(from.command, to.command) && get_flag(from.release, to.release);
}

void put(const Ack& from, jounce_lcm::ack_t& to) {
  to.boot = from.boot;
  to.table = put_count("table", from.table);
  to.next = put_count("next", from.next);
  to.mask = std::bit_cast<std::int64_t>(from.mask);
  to.credit = put_count("credit", from.credit);
  to.complete = from.complete ? 1 : 0;
  to.refusal = number_of(from.refusal);
  put_text(from.reason, to.reason, reason_bytes);
}

bool get(const jounce_lcm::ack_t& from, Ack& to) {
  to.boot = from.boot;
  to.mask = std::bit_cast<std::uint64_t>(from.mask);
  return to.boot >= 1 && get_count(from.table, to.table) && to.table < most_tables &&
         get_count(from.next, to.next) && get_count(from.credit, to.credit) &&
         get_flag(from.complete, to.complete) && get_enum(from.refusal, to.refusal) &&
         get_text(from.reason, reason_bytes, to.reason);
}

void put(const Reply& from, jounce_lcm::reply_t& to) {
  to.boot = from.boot;
  to.command = from.command;
  to.outcome = number_of(from.outcome);
  to.refusal = number_of(from.refusal);
  to.cause = from.cause;
  put_text(from.reason, to.reason, reason_bytes);
}

bool get(const jounce_lcm::reply_t& from, Reply& to) {
  to.boot = from.boot;
  to.cause = from.cause;
  return to.boot >= 1 && get_command(from.command, to.command) &&
         get_enum(from.outcome, to.outcome) && get_enum(from.refusal, to.refusal) &&
         get_text(from.reason, reason_bytes, to.reason);
}

void put(const Status& from, jounce_lcm::status_t& to) {
  to.state = number_of(from.state);
  to.next = number_of(from.next);
  to.tick = from.tick;
  to.cycle_ns = from.cycle_ns;
  to.master_position = from.master_position;
  to.slave_position = from.slave_position;
  to.slave_velocity = from.slave_velocity;
  put_bytes(from.table, to.table_prefix);
  to.last_error = from.last_error;
  to.late_ticks = from.late_ticks;
  to.finished = from.finished;
  to.stopped = from.stopped;
}

bool get(const jounce_lcm::status_t& from, Status& to) {
  to.tick = from.tick;
  to.cycle_ns = from.cycle_ns;
  to.master_position = from.master_position;
  to.slave_position = from.slave_position;
  to.slave_velocity = from.slave_velocity;
  to.last_error = from.last_error;
  to.late_ticks = from.late_ticks;
  to.finished = from.finished;
  to.stopped = from.stopped;
  return get_enum(from.state, to.state) && get_enum(from.next, to.next) && to.tick >= 0 &&
         to.cycle_ns > 0 && to.late_ticks >= 0 && to.finished >= 0 && to.stopped >= 0 &&
         get_bytes(from.table_prefix, to.table);
}

}  // namespace jounce::wire
