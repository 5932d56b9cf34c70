// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/detail/recorder.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include <unistd.h>

#include "jounce/base/detail/lcm_log.hpp"
#include "jounce/base/file.hpp"
#include "jounce/profiles/error.hpp"

#include "executor/src/record/record_wire.hpp"

namespace jounce {
namespace {

constexpr std::size_t buffered = std::size_t{1} << 20U;  // bytes

bool regular_or_new(const std::filesystem::path& path) {
  std::error_code none;
  return !std::filesystem::exists(path, none) || std::filesystem::is_regular_file(path, none);
}

/// A black box is written at a fault: finds a bad path in advance.
void require_writable(const std::filesystem::path& path) {
  if (!regular_or_new(path)) return;
  const std::filesystem::path probe = path.string() + "." + std::to_string(getpid()) + ".probe";
  const bool made = std::ofstream(probe, std::ios::binary).is_open();
  const int why = errno;
  if (!made) throw std::system_error(why, std::generic_category(), "cannot write " + path.string());
  std::filesystem::remove(probe);
}

std::vector<double> part(const std::vector<double>& column, std::size_t first, std::size_t count) {
  if (column.empty()) return {};
  const auto begin = column.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

}  // namespace

void RecordBuffer::add(std::size_t axis, const Command& command, const Inputs& inputs,
                       const Tick& tick) noexcept {
  Item item{.cycle = {.axis = axis, .command = command, .inputs = inputs, .tick = tick}};
  // Stores its id: the movement may no longer exist when the other thread reads the item.
  if (const Movement* const movement = movement_of(command.what))
    item.cycle.movement = movement->id();
  set_movement(item.cycle.command.what, nullptr);
  item.cycle.tick.handed_back = {};
  push(item);
}

void RecordBuffer::add(std::size_t master, const MasterReading& sight) noexcept {
  Item item{.what = Item::What::sight, .sight = {.master = master, .sight = sight}};
  push(item);
}

void RecordBuffer::add(std::size_t master, const MasterSample& sample) noexcept {
  Item item{.what = Item::What::sample, .sample = {.master = master, .sample = sample}};
  push(item);
}

void RecordBuffer::push(Item& item) noexcept {
  item.lost_before = lost_;
  lost_ = items_.push(item) ? 0 : lost_ + 1;
}

Recorder::Recorder(RecorderOptions options, std::vector<RecordedAxis> axes, RecordBuffer& buffer,
                   std::vector<RecordedMaster> masters)
    : options_(std::move(options)),
      axes_(std::move(axes)),
      masters_(std::move(masters)),
      ring_(buffer),
      boxes_(axes_.size() + masters_.size()) {
  if (options_.black_box && options_.black_box_cycles == 0)
    throw InputError("black_box_cycles", "0", "must be at least 1");
  if (options_.black_box) require_writable(*options_.black_box);
  if (!options_.log) return;
  part_ = *options_.log;
  if (regular_or_new(part_)) part_ += ".part";
  file_.open(part_, std::ios::binary | std::ios::trunc);
  if (!file_)
    throw std::system_error(errno, std::generic_category(), "cannot write " + part_.string());
  for (const RecordedAxis& axis : axes_) {
    write(axis, 0);
    for (const RecordedOutput& part : parts_of(axis.axis, axis.outputs, axis.compare))
      write(part, 0);
    if (axis.config.registration)
      write(RecordedRegistration{axis.axis, *axis.config.registration}, 0);
    if (axis.config.compensation)
      for (const RecordedCompensation& part : parts_of(axis.axis, *axis.config.compensation))
        write(part, 0);
  }
  for (const RecordedMaster& master : masters_) write(master, 0);
  write_check();
}

Recorder::~Recorder() {
  flush();
}

void Recorder::job(const RecordedJob& job, const StoredTable& time, const StoredTable* cam) {
  if (!file_.is_open()) return;
  RecordedJob with_hashes = job;
  with_hashes.time = time.hash;
  write(time);
  if (cam != nullptr) {
    with_hashes.cam = cam->hash;
    write(*cam);
  }
  write(with_hashes, now_);
}

/// Writes a table in parts, unless it is already there.
void Recorder::write(const StoredTable& stored) {
  if (!tables_.insert(stored.hash).second) return;
  const Table& table = *stored.table;
  const Columns& c = table.columns();
  for (std::size_t first = 0; first < table.size(); first += record_wire::knots_an_event) {
    const std::size_t count = std::min(record_wire::knots_an_event, table.size() - first);
    write(RecordedTable{.hash = stored.hash,
                        .units = stored.units,
                        .over = table.axis(),
                        .rule = table.rule(),
                        .outside = table.outside(),
                        .knots = table.size(),
                        .first = first,
                        .columns = {part(c.x, first, count), part(c.p, first, count),
                                    part(c.v, first, count), part(c.a, first, count)}},
          now_);
  }
}

void Recorder::turn() {
  for (RecordBuffer::Item item; ring_.items_.pop(item);) {
    now_ = instant_of(item);
    if (item.lost_before > 0) {
      if (lost_ == 0 && options_.notify)
        options_.notify("the recorder was too slow: cycles are missing from the record");
      lost_ += item.lost_before;
      write(RecordedLoss{item.lost_before}, now_);
    }
    take(item);
  }
}

/// Time in us. A sample precedes the sight that uses it, and gets the time of the previous item.
std::int64_t Recorder::instant_of(const RecordBuffer::Item& item) const {
  using What = RecordBuffer::Item::What;
  if (item.what == What::sample) return now_;
  return item.what == What::sight ? item.sight.sight.tick * axes_.front().config.period / 1000
                                  : static_cast<std::int64_t>(item.cycle.tick.time * 1e6);
}

void Recorder::take(const RecordBuffer::Item& item) {
  using What = RecordBuffer::Item::What;
  if (item.what == What::sample) return write(item.sample, now_);
  const bool sight = item.what == What::sight;
  if (!sight) write_triggers(item.cycle);
  if (!sight) write_references(item.cycle);
  const RecordEvent event = sight ? RecordEvent(item.sight) : RecordEvent(item.cycle);
  const std::string data = encoded(event);
  write(channel_of(event), data, now_);
  const std::size_t box = sight ? item.sight.master : masters_.size() + item.cycle.axis;
  if (!options_.black_box || box >= boxes_.size()) return;
  keep(boxes_[box], data, now_);
  if (!sight) watch(boxes_[box], item.cycle);
}

/// Writes the trigger inputs of a cycle if they have changed.
void Recorder::write_triggers(const RecordedCycle& cycle) {
  const Triggers& now = cycle.inputs.feedback.triggers;
  auto& [wired, on] = triggers_[cycle.axis];
  if (now.count == 0 && now.wired == wired && now.on == on) return;
  wired = now.wired;
  on = now.on;
  write(RecordedTriggers{cycle.axis, now}, now_);
}

/// Writes the references of a compensation in each cycle, and a change of Inputs::referenced.
void Recorder::write_references(const RecordedCycle& cycle) {
  const bool compensates = cycle.axis < axes_.size() && axes_[cycle.axis].config.compensation;
  if (!compensates && referenced_.contains(cycle.axis) == cycle.inputs.referenced) return;
  if (cycle.inputs.referenced)
    referenced_.insert(cycle.axis);
  else
    referenced_.erase(cycle.axis);
  write(RecordedReferences{cycle.axis, cycle.inputs.referenced, cycle.inputs.references,
                           cycle.tick.compensated, cycle.tick.correction},
        now_);
}

void Recorder::close() {
  turn();
  flush();
  if (!file_.is_open()) return;
  file_.close();
  if (!file_) return fail(wire::record_unwritten, "cannot write " + part_.string());
  if (part_ == *options_.log) return;
  std::error_code error;
  std::filesystem::rename(part_, *options_.log, error);
  if (error)
    fail(wire::record_unwritten, "cannot rename " + part_.string() + ": " + error.message());
}

void Recorder::write(const RecordEvent& event, std::int64_t microseconds) {
  write(channel_of(event), encoded(event), microseconds);
}

/// Adds an event to the buffer and to the checksum.
void Recorder::append(std::string_view channel, const std::string& data,
                      std::int64_t microseconds) {
  base_detail::append(buffer_, number_++, microseconds, channel, data);
  check_ = continued(check_, channel, data);
}

void Recorder::write(std::string_view channel, const std::string& data, std::int64_t microseconds) {
  if (!file_.is_open()) return;
  append(channel, data, microseconds);
  if (buffer_.size() >= buffered) flush();
}

/// Does not flush: flush() calls it.
void Recorder::write_check() {
  const RecordedCheck check{check_};
  append(channel_of(check), encoded(check), now_);
}

void Recorder::flush() {
  if (!file_.is_open() || buffer_.empty()) return;
  write_check();
  errno = 0;
  file_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  file_.flush();
  buffer_.clear();
  if (file_) return;
  const std::string why = errno != 0 ? ": " + std::generic_category().message(errno) : "";
  file_.close();
  fail(wire::record_unwritten, "the record ends here: cannot write " + part_.string() + why);
}

void Recorder::fail(wire::Unwritten which, const std::string& what) {
  if (trouble_.empty()) trouble_ = what;
  if ((unwritten_ & which) != 0) return;
  unwritten_ |= which;
  if (options_.notify) options_.notify(what);
}

// ---- black box ----------------------------------------------------------------------------------

void Recorder::keep(Box& box, const std::string& data, std::int64_t microseconds) {
  if (box.kept.size() < options_.black_box_cycles) {
    box.kept.push_back(data);
    box.microseconds.push_back(microseconds);
  } else {
    box.kept[box.count % box.kept.size()] = data;
    box.microseconds[box.count % box.kept.size()] = microseconds;
  }
  ++box.count;
}

void Recorder::watch(Box& box, const RecordedCycle& cycle) {
  const bool failed = cycle.tick.fault != Cause::none && box.fault == Cause::none;
  box.fault = cycle.tick.fault;
  if (failed) write_black_box();
}

void Recorder::write_black_box() {
  std::string bytes;
  std::int64_t number = 0;
  Sha256 checksum{};
  const auto add = [&](std::int64_t microseconds, std::string_view channel,
                       const std::string& data) {
    base_detail::append(bytes, number++, microseconds, channel, data);
    checksum = continued(checksum, channel, data);
  };
  const auto add_check = [&](std::int64_t microseconds) {
    const RecordedCheck check{checksum};
    add(microseconds, channel_of(check), encoded(check));
  };
  for (RecordedAxis axis : axes_) {
    axis.whole = false;
    add(0, channel_of(axis), encoded(axis));
  }
  for (const RecordedMaster& master : masters_) add(0, channel_of(master), encoded(master));
  add_check(0);
  struct Entry {
    std::int64_t microseconds;
    std::string_view channel;
    const std::string* data;
  };
  std::vector<Entry> entries;
  for (std::size_t b = 0; b < boxes_.size(); ++b) {
    const Box& box = boxes_[b];
    const std::string_view channel =
        b < masters_.size() ? channel_of(RecordedSight{}) : channel_of(RecordedCycle{});
    const std::size_t oldest = box.count > box.kept.size() ? box.count % box.kept.size() : 0;
    for (std::size_t i = 0; i < box.kept.size(); ++i) {
      const std::size_t k = (oldest + i) % box.kept.size();
      entries.push_back({box.microseconds[k], channel, &box.kept[k]});
    }
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.microseconds < b.microseconds; });
  for (const Entry& e : entries) add(e.microseconds, e.channel, *e.data);
  add_check(entries.empty() ? 0 : entries.back().microseconds);
  try {
    write_file(options_.black_box->string(), bytes);
    if (options_.notify) options_.notify("the last cycles are in " + options_.black_box->string());
  } catch (const std::system_error& error) {
    fail(wire::black_box_unwritten, std::string("no black box: ") + error.what());
  }
}

}  // namespace jounce
