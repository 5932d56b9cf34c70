// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/detail/replay.hpp"

#include <algorithm>
#include <bit>
#include <deque>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include "jounce/axis/axis.hpp"
#include "jounce/axis/detail/group_path.hpp"
#include "jounce/axis/detail/live_cuts.hpp"
#include "jounce/axis/live_cam.hpp"
#include "jounce/base/detail/lcm_log.hpp"
#include "jounce/base/units.hpp"
#include "jounce/profiles/error.hpp"

#include "executor/src/record/remade_masters.hpp"
#include "executor/src/server/executed_command.hpp"

namespace jounce {
namespace {

/// True if nanoseconds can count to this tick, and beyond it.
bool on_clock(std::int64_t tick, std::int64_t period) {
  return tick >= 0 && tick <= std::numeric_limits<std::int64_t>::max() / 2 / period;
}

std::string of_axis(std::size_t axis, std::int64_t tick) {
  return "axis " + std::to_string(axis + 1) + ", tick " + std::to_string(tick);
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// A table whose parts arrive one after another.
struct Growing {
  Units units;
  RecordedTable head;
  Columns columns;
};

class Replayer {
 public:
  Replayer(const std::function<void(const RecordedCycle&)>& watch,
           const std::function<void(const RecordedSight&)>& watch_master)
      : watch_(watch), watch_master_(watch_master) {}

  void take(const RecordedAxis& axis) {
    if (axis.axis != result_.axes.size())
      throw InputError("axis", std::to_string(axis.axis + 1), "is out of sequence");
    result_.axes.push_back(axis);
    if (axis.whole) motions_.emplace_back(std::make_unique<MotionAxis>(axis.config));
    if (!axis.whole) end("the file is a black box: its record begins in the middle of a run");
  }

  /// Reconstructs the axis with the parts of its outputs so far.
  void take(const RecordedOutput& part) {
    static_cast<void>(config(part.axis));
    RecordedAxis& axis = result_.axes[part.axis];
    if (apply(part, axis.outputs, axis.compare) && part.axis < motions_.size())
      motions_[part.axis] = std::make_unique<MotionAxis>(axis.config, axis.outputs, axis.compare);
  }

  /// Reconstructs the axis with its registration.
  void take(const RecordedRegistration& part) {
    static_cast<void>(config(part.axis));
    RecordedAxis& axis = result_.axes[part.axis];
    axis.config.registration = part.spec;
    if (part.axis < motions_.size())
      motions_[part.axis] = std::make_unique<MotionAxis>(axis.config, axis.outputs, axis.compare);
  }

  /// Reconstructs the axis with the whole correction table.
  void take(const RecordedCompensation& part) {
    static_cast<void>(config(part.axis));
    RecordedAxis& axis = result_.axes[part.axis];
    if (apply(part, axis.config.compensation) && part.axis < motions_.size())
      motions_[part.axis] = std::make_unique<MotionAxis>(axis.config, axis.outputs, axis.compare);
  }

  void take(const RecordedReferences& seen) { references_[seen.axis] = seen; }

  void take(const RecordedTriggers& changed) { triggers_[changed.axis] = changed.triggers; }

  void take(const RecordedTable& part) {
    Growing& table = growing_[part.hash];
    if (part.first != table.columns.x.size())
      throw InputError("table", hex(part.hash).substr(0, 16), "does not begin with its first knot");
    table.head = part;
    const auto add = [](std::vector<double>& whole, const std::vector<double>& more) {
      whole.insert(whole.end(), more.begin(), more.end());
    };
    add(table.columns.x, part.columns.x);
    add(table.columns.p, part.columns.p);
    add(table.columns.v, part.columns.v);
    add(table.columns.a, part.columns.a);
    if (table.columns.x.size() < part.knots) return;
    auto made =
        std::make_shared<const Table>(part.over, part.rule, part.outside, std::move(table.columns));
    if (content_hash(*made, part.units) != part.hash)
      throw InputError("table", hex(part.hash).substr(0, 16), "does not match its hash");
    tables_[part.hash] = std::move(made);
    growing_.erase(part.hash);
  }

  void take(const RecordedJob& job) {
    if (job.cuts)
      keep(job.axis,
           std::make_shared<LiveCuts>(
               job.id, std::make_shared<const CutTask>(cut_job_of(table(job.time)->columns().p)),
               config(job.axis)));
    else if (job.live)
      keep(job.axis, std::make_shared<LiveCam>(job.id, table(job.time), job.coupling, job.end));
    else
      keep(job.axis,
           std::make_shared<Job>(job.id, table(job.time), job.cam ? table(*job.cam) : nullptr,
                                 job.tick, job.coupling, job.position));
  }

  void take(const RecordedGear& gear) {
    keep(gear.axis, gear_of(gear.gear, gear.id, config(gear.axis), gear.position));
  }

  void take(const RecordedProgram& part) {
    std::vector<LawInterval>& law = laws_[{part.axis, part.id}];
    if (part.first != law.size())
      throw InputError("program", std::to_string(part.first),
                       "must be " + std::to_string(law.size()) + ", the next stretch of its law");
    law.insert(law.end(), part.law.begin(), part.law.end());
    if (law.size() < part.total) return;
    GroupProgram program = remade(law, part.axes);
    program.switches = std::move(switches_[{part.axis, part.id}]);
    keep(part.axis, std::make_shared<GroupPath>(part.id, std::move(program)));
    laws_.erase({part.axis, part.id});
    switches_.erase({part.axis, part.id});
  }

  void take(const RecordedPathSwitches& part) {
    std::vector<PathSwitch>& all = switches_[{part.axis, part.id}];
    all.insert(all.end(), part.some.begin(), part.some.end());
  }

  void take(const RecordedQueue& opened) {
    if (ended_) return;
    queues_.try_emplace({opened.axis, opened.id}, opened.queue, opened.id, config(opened.axis));
  }

  void take(const RecordedRows& rows) {
    if (!ended_) handed_over_[rows.axis].push_back(rows.what);
  }

  void take(const RecordedMaster& master) {
    if (master.master != result_.masters.size())
      throw InputError("master", std::to_string(master.master + 1), "is out of sequence");
    result_.masters.push_back(Replay::Master{master});
    sights_.emplace_back();
    masters_.add(master);
  }

  void take(const RecordedSample& sample) {
    if (!ended_) masters_.take(sample);
  }

  void take(const RecordedSight& seen) {
    if (seen.master >= sights_.size())
      throw InputError("master", std::to_string(seen.master + 1),
                       "is missing from the start of the record");
    sights_[seen.master] = seen.sight;
    ++result_.masters[seen.master].cycles;
    result_.masters[seen.master].lost += seen.sight.lost();
    if (watch_master_) watch_master_(seen);
    if (ended_ || result_.axes.empty()) return;
    const std::int64_t period = result_.axes.front().config.period;
    if (!on_clock(seen.sight.tick, period))
      throw InputError("tick", std::to_string(seen.sight.tick), "must be the tick of a cycle");
    const double time = static_cast<double>(seen.sight.tick * period) * 1e-9;
    if (const auto what = masters_.compare(seen, time)) {
      result_.difference = Replay::Difference{seen.master, seen.sight.tick, *what, true};
      ended_ = true;
    }
  }

  void take(const RecordedCheck& check) {
    if (check.hash != check_ && result_.damage.empty())
      result_.damage = "between event " + std::to_string(std::max<std::int64_t>(checked_, 1)) +
                       " and event " + std::to_string(events_) +
                       ", an event was changed, added or lost";
    result_.has_checksums = true;
    checked_ = events_;
  }

  /// An event of Jounce, which is event `number` of the file.
  void take(const RecordEvent& record, std::int64_t number) {
    events_ = number;
    std::visit([&](const auto& r) { take(r); }, record);
  }

  /// Adds an event of Jounce to the checksum.
  void add(std::string_view channel, std::string_view bytes) {
    check_ = continued(check_, channel, bytes);
  }

  void take(const RecordedLoss& loss) {
    end(std::to_string(loss.cycles) + " cycles are missing: the recorder was too slow" + after());
  }

  void take(RecordedCycle cycle) {
    Triggers& triggers = triggers_[cycle.axis];
    cycle.inputs.feedback.triggers = triggers;
    triggers.count = 0;
    if (const auto seen = references_.find(cycle.axis); seen != references_.end()) {
      cycle.inputs.referenced = seen->second.referenced;
      cycle.inputs.references = seen->second.references;
      cycle.tick.compensated = seen->second.compensated;
      cycle.tick.correction = seen->second.correction;
    }
    if (cycle.axis >= result_.axes.size())
      throw InputError("axis", std::to_string(cycle.axis + 1),
                       "is missing from the start of the record");
    ++result_.cycles;
    if (!result_.first_tick) result_.first_tick = cycle.tick.tick;
    result_.last_tick = cycle.tick.tick;
    if (watch_) watch_(cycle);
    if (!ended_) execute(cycle);
  }

  /// Ends the execution: the first reason counts.
  void end(const std::string& why) {
    if (!ended_) result_.shorter = why;
    ended_ = true;
  }

  [[nodiscard]] std::string after() const {
    return result_.first_tick ? " after tick " + std::to_string(result_.last_tick) : "";
  }

  /// Requires that the last event is a checksum, unless the file is cut off.
  Replay finish(bool cut) {
    if (result_.has_checksums && !cut && checked_ != events_ && result_.damage.empty())
      result_.damage = "the checksum after event " + std::to_string(events_) + " is missing";
    return std::move(result_);
  }

 private:
  void execute(const RecordedCycle& cycle) {
    Command command = cycle.command;
    if (!hand_over(cycle)) return;
    if (cycle.movement != 0) {
      Movement* const movement = this->movement({cycle.axis, cycle.movement});
      set_movement(command.what, movement);
      if (movement == nullptr)
        return end("the record lacks parts of movement " + std::to_string(cycle.movement) + " (" +
                   of_axis(cycle.axis, cycle.tick.tick) + ")");
    }
    const auto [last, first] = last_ticks_.try_emplace(cycle.axis, cycle.tick.tick);
    if (!on_clock(cycle.tick.tick, result_.axes[cycle.axis].config.period) ||
        (!first && cycle.tick.tick <= last->second))
      throw InputError("tick", std::to_string(cycle.tick.tick),
                       "must be greater than the one before, not negative, and within 146 years");
    last->second = cycle.tick.tick;
    if (const auto what = other_master(cycle)) return differ(cycle, *what);
    MotionAxis& motion = *motions_[cycle.axis];
    Tick now = motion.step(cycle.tick.tick, command, cycle.inputs);
    if (motion.config().compensation) now.correction = motion.compensate(cycle.inputs.references);
    ++result_.compared;
    for (const Movement* movement : now.handed_back)
      if (movement != nullptr) drop({cycle.axis, movement->id()});
    const bool switches = !result_.axes[cycle.axis].switches;
    if (const auto what = first_difference(cycle.tick, now, switches)) return differ(cycle, *what);
    if (!same_bits(cycle.tick.correction[0], now.correction[0]))
      differ(cycle, {"correction", cycle.tick.correction[0], now.correction[0]});
  }

  void differ(const RecordedCycle& cycle, const TickDifference& what) {
    result_.difference = Replay::Difference{cycle.axis, cycle.tick.tick, what};
    ended_ = true;
  }

  /// The unit of a master in that of a follower, as the executor converts it.
  double scale_of(std::size_t master, std::size_t axis) {
    const auto [at, is_new] = scales_.try_emplace({master, axis}, 1.0);
    const std::string& unit = result_.axes[axis].units.x;
    const std::string& from = result_.masters[master].unit;
    if (is_new && is_convertible(from, unit)) at->second = conversion(from, unit);
    return at->second;
  }

  /// A difference between the master in a follower and in the cycle.
  [[nodiscard]] std::optional<TickDifference> other_master(const RecordedCycle& cycle) {
    for (std::size_t m = 0; m < sights_.size(); ++m) {
      if ((result_.masters[m].followers >> cycle.axis & 1U) == 0) continue;
      const Jet& own = cycle.inputs.master;
      Jet sight = sights_[m].at;
      const double scale = scale_of(m, cycle.axis);
      for (double& value : sight) value *= scale;
      const bool same = sights_[m].tick == cycle.tick.tick &&
                        std::equal(own.begin(), own.end(), sight.begin(), same_bits);
      if (!same) return TickDifference{"live_master", own[0], sight[0]};
    }
    return std::nullopt;
  }

  using Key = std::pair<std::size_t, std::uint64_t>;  // axis, and the movement's id

  void keep(std::size_t axis, std::shared_ptr<Movement> movement) {
    const std::uint64_t id = movement->id();
    movements_[{axis, id}] = std::move(movement);
  }

  /// The axis no longer reads it.
  void drop(const Key& key) {
    movements_.erase(key);
    if (const auto queue = queues_.find(key); queue != queues_.end()) queue->second.fifos().leave();
  }

  /// The movement of a queue can be armed again and again.
  [[nodiscard]] Movement* movement(const Key& key) const {
    if (const auto it = movements_.find(key); it != movements_.end()) return it->second.get();
    const auto queue = queues_.find(key);
    return queue == queues_.end() ? nullptr : queue->second.movement().get();
  }

  [[nodiscard]] const AxisConfig& config(std::size_t axis) const {
    if (axis >= result_.axes.size())
      throw InputError("axis", std::to_string(axis + 1), "is missing from the start of the record");
    return result_.axes[axis].config;
  }

  /// Applies the changes of its queues that the axis sees from this cycle on. Returns false if it
  /// cannot be executed.
  bool hand_over(const RecordedCycle& cycle) {
    auto& waiting = handed_over_[cycle.axis];
    for (; !waiting.empty() && waiting.front().number <= cycle.inputs.rows; waiting.pop_front()) {
      const HandedOver& next = waiting.front();
      const auto queue = queues_.find({cycle.axis, next.movement});
      if (queue != queues_.end() && queue->second.take(next)) continue;
      end("the record has rows for queue " + std::to_string(next.movement) +
          " that the queue cannot take (" + of_axis(cycle.axis, cycle.tick.tick) + ")");
      return false;
    }
    return true;
  }

  std::shared_ptr<const Table> table(const Sha256& hash) const {
    const auto it = tables_.find(hash);
    if (it == tables_.end())
      throw InputError("job", hex(hash).substr(0, 16),
                       "is the hash of a table that is missing from the record");
    return it->second;
  }

  const std::function<void(const RecordedCycle&)>& watch_;
  const std::function<void(const RecordedSight&)>& watch_master_;
  Replay result_;
  Sha256 check_{};            // checksum of the events so far
  std::int64_t events_ = 0;   // the last event of Jounce
  std::int64_t checked_ = 0;  // the last checksum; 0: none
  executor_detail::RemadeMasters masters_;
  std::vector<MasterReading> sights_;  // the last of each master
  std::vector<std::unique_ptr<MotionAxis>> motions_;
  std::map<std::size_t, std::int64_t> last_ticks_;
  std::map<std::pair<std::size_t, std::size_t>, double> scales_;  // by master and axis
  std::map<std::size_t, Triggers> triggers_;
  std::map<std::size_t, RecordedReferences> references_;
  std::map<Sha256, Growing> growing_;
  std::map<Sha256, std::shared_ptr<const Table>> tables_;
  std::map<Key, std::shared_ptr<Movement>> movements_;
  std::map<Key, std::vector<LawInterval>> laws_;     // programs whose parts arrive
  std::map<Key, std::vector<PathSwitch>> switches_;  // their outputs
  std::map<Key, QueueMovement> queues_;
  std::map<std::size_t, std::deque<HandedOver>> handed_over_;  // not yet seen, by axis
  bool ended_ = false;
};

}  // namespace

Replay replay(std::istream& in, const std::string& name,
              const std::function<void(const RecordedCycle&)>& watch,
              const std::function<void(const RecordedSight&)>& watch_master) {
  base_detail::LcmLogReader reader(in, name);
  Replayer replayer(watch, watch_master);
  while (const auto event = reader.next()) {
    try {
      const auto record = decoded(event->channel, event->data);
      if (!record) continue;
      replayer.take(*record, reader.events());
      replayer.add(event->channel, event->data);
    } catch (const InputError& error) {
      throw InputError("event " + std::to_string(reader.events()) + ": " + error.key(),
                       error.value(), error.rule())
          .at(name);
    }
  }
  if (reader.cut())
    replayer.end("the file is cut off at byte " + std::to_string(reader.offset()) +
                 replayer.after() +
                 ": copy the record again from the machine, or end its run first");
  Replay result = replayer.finish(reader.cut());
  if (result.axes.empty())
    throw InputError("", "", "is not a record of `jounce run --record`: it has no axis").at(name);
  return result;
}

}  // namespace jounce
