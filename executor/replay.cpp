#include "jounce/executor/replay.hpp"

#include <map>
#include <memory>
#include <utility>

#include "jounce/executor/detail/lcm_log.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

std::string of_axis(std::size_t axis, std::int64_t tick) {
  return "axis " + std::to_string(axis + 1) + ", tick " + std::to_string(tick);
}

/// A table whose parts come one after another.
struct Growing {
  Units units;
  RecordedTable head;
  Columns columns;
};

class Replayer {
 public:
  explicit Replayer(const std::function<void(const RecordedCycle&)>& watch) : watch_(watch) {}

  void take(const RecordedAxis& axis) {
    if (axis.axis != result_.axes.size())
      throw InputError("axis", std::to_string(axis.axis + 1), "does not follow the ones before");
    result_.axes.push_back(axis);
    if (axis.whole) motions_.emplace_back(std::make_unique<MotionAxis>(axis.config));
    if (!axis.whole) end("it is a black box: it begins in the middle of a run");
  }

  void take(const RecordedTable& part) {
    Growing& table = growing_[part.hash];
    if (part.first != table.columns.x.size())
      throw InputError("table", hex(part.hash).substr(0, 16),
                       "is not there from its first knot on");
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
      throw InputError("table", hex(part.hash).substr(0, 16), "does not have the hash of its name");
    tables_[part.hash] = std::move(made);
    growing_.erase(part.hash);
  }

  void take(const RecordedJob& job) {
    jobs_[{job.axis, job.id}] =
        std::make_unique<Job>(job.id, table(job.time), job.cam ? table(*job.cam) : nullptr,
                              job.tick, job.coupling, job.position);
  }

  void take(const RecordedLoss& loss) {
    end(std::to_string(loss.cycles) + " cycles found no room on their way into the record" +
        after());
  }

  void take(const RecordedCycle& cycle) {
    if (cycle.axis >= result_.axes.size())
      throw InputError("axis", std::to_string(cycle.axis + 1), "was not recorded when it started");
    ++result_.cycles;
    if (!result_.first_tick) result_.first_tick = cycle.tick.tick;
    result_.last_tick = cycle.tick.tick;
    if (watch_) watch_(cycle);
    if (!ended_) execute(cycle);
  }

  /// The execution ends here: the first reason counts.
  void end(const std::string& why) {
    if (!ended_) result_.shorter = why;
    ended_ = true;
  }

  [[nodiscard]] std::string after() const {
    return result_.first_tick ? " after tick " + std::to_string(result_.last_tick) : "";
  }

  Replay finish() { return std::move(result_); }

 private:
  void execute(const RecordedCycle& cycle) {
    Command command = cycle.command;
    if (cycle.movement != 0) {
      const auto job = jobs_.find({cycle.axis, cycle.movement});
      if (job == jobs_.end())
        return end("the record does not have what movement " + std::to_string(cycle.movement) +
                   " is made from (" + of_axis(cycle.axis, cycle.tick.tick) + ")");
      command.movement = job->second.get();
    }
    const auto [last, first] = last_ticks_.try_emplace(cycle.axis, cycle.tick.tick);
    if (cycle.tick.tick < 0 || (!first && cycle.tick.tick <= last->second))
      throw InputError("tick", std::to_string(cycle.tick.tick),
                       "must be greater than the one before, and not negative");
    last->second = cycle.tick.tick;
    const Tick now = motions_[cycle.axis]->step(cycle.tick.tick, command, cycle.inputs);
    ++result_.compared;
    for (const Movement* movement : now.handed_back)
      if (movement != nullptr) jobs_.erase({cycle.axis, movement->id()});
    const bool switches = !result_.axes[cycle.axis].switches;
    if (const auto what = first_difference(cycle.tick, now, switches)) {
      result_.difference = Replay::Difference{cycle.axis, cycle.tick.tick, *what};
      ended_ = true;
    }
  }

  std::shared_ptr<const Table> table(const Sha256& hash) const {
    const auto it = tables_.find(hash);
    if (it == tables_.end())
      throw InputError("job", hex(hash).substr(0, 16), "is the hash of a table that is not there");
    return it->second;
  }

  const std::function<void(const RecordedCycle&)>& watch_;
  Replay result_;
  std::vector<std::unique_ptr<MotionAxis>> motions_;
  std::map<std::size_t, std::int64_t> last_ticks_;
  std::map<Sha256, Growing> growing_;
  std::map<Sha256, std::shared_ptr<const Table>> tables_;
  std::map<std::pair<std::size_t, std::uint64_t>, std::unique_ptr<Job>> jobs_;
  bool ended_ = false;
};

}  // namespace

Replay replay(std::istream& in, const std::string& name,
              const std::function<void(const RecordedCycle&)>& watch) {
  detail::LcmLogReader reader(in, name);
  Replayer replayer(watch);
  while (const auto event = reader.next()) {
    try {
      if (const auto record = decoded(event->channel, event->data))
        std::visit([&](const auto& r) { replayer.take(r); }, *record);
    } catch (const InputError& error) {
      throw InputError("event " + std::to_string(reader.events()) + ": " + error.key(),
                       error.value(), error.rule())
          .at(name);
    }
  }
  if (reader.cut())
    replayer.end("the file is cut off at byte " + std::to_string(reader.offset()) +
                 replayer.after());
  Replay result = replayer.finish();
  if (result.axes.empty())
    throw InputError("record", "", "has no axis: this is not a record of an executor").at(name);
  return result;
}

}  // namespace jounce
