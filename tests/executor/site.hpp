// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "jounce/executor/detail/dispatcher.hpp"
#include "jounce/executor/detail/replay.hpp"
#include "jounce/stream/sender/stream_outcome.hpp"
#include "jounce/stream/sender/stream_plan.hpp"

#include "executor/cycle/virtual_pacer.hpp"
#include "executor/src/record/run_record.hpp"
#include "executor/src/server/motion_server.hpp"
#include "stream/src/transport/memory_transport.hpp"

namespace jounce::test {

/// An axis by this name, in these units; x: its master's.
ExecutorOptions axis_named(const std::string& name, const Limits& limits, const Units& units = {});

/// The parts of a site beside its axes.
struct SiteSpec {
  std::vector<MachineMaster> masters = {};
  bool recorded = false;
  std::vector<ExecutorOptions> said =
      {};  ///< configuration of the axes in the record; empty: the real one
};

/// A whole executor and one who talks to it, on one memory network and one clock that only the test
/// turns: whenever somebody waits for the network, the executor's two threads have their turns.
///
///     Site site({axis_named("feeder", limits(1000, 1e5), {"", "mm"})});
///     ASSERT_TRUE(site.play(*trapezoid_table(50, 100, 1000, 1000)).ok());
///     site.advance(1s);
///     EXPECT_EQ(site.last().position, 50);
class Site {
 public:
  explicit Site(std::vector<ExecutorOptions> of_axes, SiteSpec spec = {});
  ~Site();
  Site(const Site&) = delete;
  Site& operator=(const Site&) = delete;

  /// Cycle by cycle: before(), the cycle, the dispatcher's turn, after(). A client that is destroyed
  /// waits for the answer to its release, so what they use must outlive the site's clients.
  void advance(Nanos time);
  void turn();
  std::function<void()> before, after;

  [[nodiscard]] const Tick& last(std::size_t axis = 0) const { return dispatcher.last(axis); }

  /// In a session of its own, which counts from 1; to the first axis unless the plan names one.
  StreamOutcome stream(StreamPlan plan);
  /// A table over time, in s and the first axis's unit.
  StreamOutcome play(const Table& table);

  /// Ends the run; the bytes of its record.
  std::string record();
  /// Ends it, and executes the record again.
  Replay replayed(const std::function<void(const RecordedCycle&)>& each = {},
                  const std::function<void(const RecordedSight&)>& sight = {});

 private:
  std::filesystem::path log_;
  executor_detail::RunRecord record_;

 public:
  std::vector<ExecutorOptions> axes;
  std::vector<MachineMaster> masters;
  MemoryNetwork network;
  MemoryTransport own_link{network};  ///< the executor's
  MemoryTransport link{network};      ///< link of the client
  VirtualPacer pacer;
  Clock clock = [this] { return Nanos(pacer.now()); };
  Machine machine{machine_of(axes), masters.size()};
  MachineExchange exchange{axes.size(), masters.size()};
  Dispatcher dispatcher{own_link, axes, exchange, clock, masters};
  Cycle cycle;
  std::int64_t sessions = 0;
};

}  // namespace jounce::test
