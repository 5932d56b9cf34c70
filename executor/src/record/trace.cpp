// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/detail/trace.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "jounce/drive/seqlock.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

constexpr std::uint64_t trace_magic = 0x3265636172542d4aU;  // "J-Trace2"
constexpr std::size_t trace_words = (sizeof(TraceTick) + 7) / 8;
static_assert(std::is_trivially_copyable_v<TraceTick>);

[[noreturn]] void fail_trace(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// One tick in shared memory, in atomic words: see Seqlock for the memory order.
struct TraceSlot {
  std::array<std::atomic<std::uint64_t>, trace_words> words;

  void store(const TraceTick& tick) noexcept {
    std::array<std::uint64_t, trace_words> raw{};
    std::memcpy(raw.data(), &tick, sizeof tick);
    for (std::size_t i = 0; i < trace_words; ++i) words[i].store(raw[i], std::memory_order_release);
  }
  [[nodiscard]] TraceTick load() const noexcept {
    std::array<std::uint64_t, trace_words> raw{};
    for (std::size_t i = 0; i < trace_words; ++i) raw[i] = words[i].load(std::memory_order_acquire);
    TraceTick tick;
    std::memcpy(static_cast<void*>(&tick), raw.data(), sizeof tick);
    return tick;
  }
  [[nodiscard]] std::int64_t number() const noexcept {
    static_assert(offsetof(TraceTick, tick) == 0);
    return std::bit_cast<std::int64_t>(words[0].load(std::memory_order_acquire));
  }
};

/// The numbers of the ticks in the ring of an axis: from `begin` to before `end`.
struct TraceRing {
  std::atomic<std::uint64_t> begin;
  std::atomic<std::uint64_t> end;
  std::atomic<std::int64_t> period;
};

void store_unit(std::array<char, TraceTable::most_unit>& to, const std::string& unit) {
  unit.copy(to.data(), to.size() - 1);
}

}  // namespace

/// The path of a group. Its number is also outside, so that a reader need not copy the path.
struct TracePathSlot {
  std::atomic<std::uint64_t> number;
  Seqlock<TracePath> path;
};

/// The beginning of the memory. The paths and the rings of the axes follow it, and then their slots.
/// The kernel provides the pages of a path only when it is written.
struct Trace::Memory {
  std::atomic<std::uint64_t> magic;
  std::uint64_t axes;
  std::uint64_t capacity;  // slots of each axis, a power of two
  std::atomic<std::uint64_t> table_count;
  std::array<Seqlock<TraceTable>, Trace::tables> tables;

  static std::size_t bytes_of(std::size_t axes, std::size_t capacity) {
    return sizeof(Memory) +
           axes * (sizeof(TracePathSlot) + sizeof(TraceRing) + capacity * sizeof(TraceSlot));
  }
  TracePathSlot& path(std::size_t axis) { return reinterpret_cast<TracePathSlot*>(this + 1)[axis]; }
  TraceRing& ring(std::size_t axis) { return reinterpret_cast<TraceRing*>(&path(axes))[axis]; }
  TraceSlot& slot(std::size_t axis, std::uint64_t number) {
    auto* const slots = reinterpret_cast<TraceSlot*>(&ring(axes));
    return slots[axis * capacity + number % capacity];
  }
};

TraceTick trace_tick(const Tick& tick) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  return {.tick = tick.tick,
          .values = {tick.position, tick.actual_position, tick.following_error, tick.velocity,
                     tick.acceleration, tick.torque, tick.master,
                     std::isnan(tick.master) ? unknown : tick.master_velocity},
          .state = tick.state,
          .fault = tick.fault,
          .reason = tick.reason,
          .refused = tick.refused ? tick.refused->cause : Cause::none,
          .dropped = tick.dropped ? tick.dropped->cause : Cause::none};
}

Trace::Trace(int descriptor, std::size_t bytes, Memory* memory)
    : descriptor_(descriptor), bytes_(bytes), memory_(memory) {}

Trace::Trace(Trace&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      bytes_(other.bytes_),
      memory_(std::exchange(other.memory_, nullptr)) {}

Trace::~Trace() {
  if (memory_ != nullptr) munmap(memory_, bytes_);
  if (descriptor_ >= 0) close(descriptor_);
}

Trace Trace::of(const std::vector<std::int64_t>& periods) {
  const std::size_t axes = periods.size();
  const std::size_t room = most_bytes / sizeof(TraceSlot) / std::max<std::size_t>(axes, 1);
  const std::size_t capacity = std::min(most_ticks, std::bit_floor(room));
  const std::size_t bytes = Memory::bytes_of(axes, capacity);
  const int descriptor = memfd_create("jounce-trace", MFD_CLOEXEC | MFD_ALLOW_SEALING);
  if (descriptor < 0) fail_trace("cannot create the memory of the traces");
  void* at = MAP_FAILED;
  // The size is final: a reader cannot cut it, which would end the writer by SIGBUS.
  if (ftruncate(descriptor, static_cast<off_t>(bytes)) == 0 &&
      fcntl(descriptor, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) == 0)
    at = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  if (at == MAP_FAILED) {
    close(descriptor);
    fail_trace("cannot map the memory of the traces");
  }
  // New memory contains zeros: a valid state of all atomics in it.
  Trace trace(descriptor, bytes, static_cast<Memory*>(at));
  trace.memory_->axes = axes;
  trace.memory_->capacity = capacity;
  for (std::size_t axis = 0; axis < axes; ++axis) trace.set_period(axis, periods[axis]);
  trace.memory_->magic.store(trace_magic, std::memory_order_release);
  return trace;
}

Trace Trace::of(const std::vector<ExecutorOptions>& axes) {
  std::vector<std::int64_t> periods;
  for (const ExecutorOptions& options : axes) periods.push_back(options.axis.period);
  return of(periods);
}

std::optional<Trace> Trace::opened(int descriptor) {
  struct stat status {};
  if (fstat(descriptor, &status) != 0) return std::nullopt;
  const auto bytes = static_cast<std::size_t>(status.st_size);
  if (bytes < sizeof(Memory)) return std::nullopt;
  void* at = mmap(nullptr, bytes, PROT_READ, MAP_SHARED, descriptor, 0);
  if (at == MAP_FAILED) return std::nullopt;
  Trace trace(descriptor, bytes, static_cast<Memory*>(at));
  const Memory& memory = *trace.memory_;
  if (memory.magic.load(std::memory_order_acquire) == trace_magic &&
      bytes == Memory::bytes_of(memory.axes, memory.capacity))
    return trace;
  trace.descriptor_ = -1;  // it belongs to somebody else
  return std::nullopt;
}

int Trace::reading_descriptor() const {
  const std::string path = "/proc/self/fd/" + std::to_string(descriptor_);
  const int reading = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (reading < 0) fail_trace("cannot open the memory of the traces");
  return reading;
}

void Trace::add(std::size_t axis, const TraceTick& tick) noexcept {
  TraceRing& ring = memory_->ring(axis);
  const std::uint64_t end = ring.end.load(std::memory_order_relaxed);
  memory_->slot(axis, end).store(tick);
  ring.end.store(end + 1, std::memory_order_release);
}

void Trace::clear(std::size_t axis) noexcept {
  TraceRing& ring = memory_->ring(axis);
  ring.begin.store(ring.end.load(std::memory_order_relaxed), std::memory_order_release);
}

void Trace::add(std::size_t axis, const StoredTable& stored) {
  const Table& table = *stored.table;
  const std::uint64_t number = memory_->table_count.load(std::memory_order_relaxed) + 1;
  TraceTable entry{.number = number,
                   .axis = axis,
                   .hash = stored.hash,
                   .knots = table.size(),
                   .over = table.axis(),
                   .start = table.start(),
                   .end = table.end()};
  store_unit(entry.x_unit, stored.units.x);
  store_unit(entry.unit, stored.units.position);
  for (std::size_t i = 0; i < TraceTable::samples; ++i) {
    const double share = static_cast<double>(i) / (TraceTable::samples - 1);
    const bool is_last = i + 1 == TraceTable::samples;
    const double x = is_last ? table.end() : table.start() + share * table.length();
    entry.position[i] = table.jet(x, is_last ? Side::left : Side::right)[0];
  }
  memory_->tables[number % tables].write(entry);
  memory_->table_count.store(number, std::memory_order_release);
}

void Trace::set(std::size_t group, TracePath& path) {
  TracePathSlot& slot = memory_->path(group);
  path.number = slot.number.load(std::memory_order_relaxed) + 1;
  slot.path.write(path);
  slot.number.store(path.number, std::memory_order_release);
}

std::uint64_t Trace::path_number(std::size_t group) const {
  return memory_->path(group).number.load(std::memory_order_acquire);
}

std::unique_ptr<TracePath> Trace::path(std::size_t group) const {
  const auto path = memory_->path(group).path.read();
  return path && path->number != 0 ? std::make_unique<TracePath>(*path) : nullptr;
}

std::size_t Trace::axes() const {
  return memory_->axes;
}

std::int64_t Trace::period(std::size_t axis) const {
  return memory_->ring(axis).period.load(std::memory_order_relaxed);
}

void Trace::set_period(std::size_t axis, std::int64_t ns) noexcept {
  memory_->ring(axis).period.store(ns, std::memory_order_relaxed);
}

std::optional<std::int64_t> Trace::newest(std::size_t axis) const {
  const TraceRing& ring = memory_->ring(axis);
  const std::uint64_t end = ring.end.load(std::memory_order_acquire);
  if (end == ring.begin.load(std::memory_order_acquire)) return std::nullopt;
  return memory_->slot(axis, end - 1).number();
}

std::vector<TraceTick> Trace::ticks(std::size_t axis, std::int64_t first, std::int64_t last) const {
  const TraceRing& ring = memory_->ring(axis);
  const std::uint64_t capacity = memory_->capacity;
  const std::uint64_t end = ring.end.load(std::memory_order_acquire);
  // The slot behind the newest one may be in use by the writer.
  std::uint64_t begin =
      std::max(ring.begin.load(std::memory_order_acquire), end - std::min(end, capacity - 1));
  for (std::uint64_t above = end; begin < above;) {  // the first one not before `first`
    const std::uint64_t middle = begin + (above - begin) / 2;
    memory_->slot(axis, middle).number() < first ? begin = middle + 1 : above = middle;
  }
  std::vector<TraceTick> ticks;
  ticks.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(
      end - begin, last < first ? 0 : static_cast<std::uint64_t>(last - first) + 1)));
  for (std::uint64_t number = begin; number < end; ++number) {
    ticks.push_back(memory_->slot(axis, number).load());
    if (ticks.back().tick > last) {
      ticks.pop_back();
      break;
    }
  }
  // The writer may have replaced the oldest ones meanwhile.
  const std::uint64_t now = ring.end.load(std::memory_order_relaxed);
  const std::uint64_t lost = now >= begin + capacity
                                 ? std::min<std::uint64_t>(now - capacity - begin + 1, ticks.size())
                                 : 0;
  ticks.erase(ticks.begin(), ticks.begin() + static_cast<std::ptrdiff_t>(lost));
  return ticks;
}

std::vector<TraceTable> Trace::last_tables() const {
  const std::uint64_t count = memory_->table_count.load(std::memory_order_acquire);
  std::vector<TraceTable> all;
  for (std::uint64_t number = count; number > 0 && count - number < tables; --number)
    if (const auto table = memory_->tables[number % tables].read();
        table && table->number == number)
      all.push_back(*table);
  return all;
}

}  // namespace jounce
