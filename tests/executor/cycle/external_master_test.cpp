// SPDX-License-Identifier: Apache-2.0
// Masters from outside, end to end: a sender with a clock of its own on a bad link, the executor's
// threads in turn on a virtual clock, followers that get their orders over the link; and the record
// of the run.

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/cam/design/placement.hpp"
#include "jounce/gear/follow.hpp"
#include "jounce/pvt/segment_row.hpp"
#include "jounce/stream/sender/client.hpp"

#include "axis/tables.hpp"
#include "executor/site.hpp"
#include "gear/follow_tables.hpp"
#include "stream/src/transport/lossy_transport.hpp"

namespace jounce::external_master_test {
namespace {

using namespace test;
using namespace std::chrono_literals;
using ::testing::Contains;
using ::testing::HasSubstr;

const Units over_time{.x = "s", .position = "mm"};
const Units over_master{.x = "mm", .position = "mm"};

/// A sender of a master's position; its clock is another one, ahead and fast.
struct Sender {
  std::string name;
  std::function<double(double)> position;  // over its own time
  std::int32_t clock = 1;
  bool valid = true;
  bool silent = false;
  std::string unit = "mm";
  std::int64_t seq = 0;

  static double its_time(Nanos now) {
    const double here = std::chrono::duration<double>(now).count() - 123.456789;
    return here * (1 + 50e-6) + 1234.5;
  }
  wire::Master sample(Nanos now) {
    const double t = its_time(now);
    return {.seq = ++seq,
            .stamp_ns = std::llround(t * 1e9),
            .clock = clock,
            .valid = valid,
            .position = position(t - 1234.5),
            .unit = unit};
  }
};

/// 5 ms jitter at a 5th, one in ten lost, some doubled and damaged.
constexpr LossSpec bad{.seed = 7, .lost = 0.1, .doubled = 0.05, .corrupted = 0.02, .delayed = 0.2};

std::vector<ExecutorOptions> knife_and_label(double fast) {
  std::vector<ExecutorOptions> axes;
  for (const char* const name : {"knife", "label"}) {
    axes.push_back(axis_named(name, limits(5 * fast, 2000 * fast), over_master));
    axes.back().follow = {.what = Follow::What::master, .index = axes.size() - 1};
  }
  return axes;
}

std::vector<MachineMaster> line_and_web(double fast) {
  const TrackerSpec tracker{
      .velocity = 3 * fast, .acceleration = 40 * fast, .time_constant = 10e-3, .order = 3};
  std::vector<MachineMaster> masters;
  for (const char* const name : {"line", "web"})
    masters.push_back({name, "mm", std::make_shared<ExternalMaster>(tracker)});
  return masters;
}

std::vector<ExecutorOptions> telling(std::vector<std::string>& notices,
                                     std::vector<ExecutorOptions> axes) {
  for (ExecutorOptions& axis : axes)
    axis.notify = [&notices](const std::string& notice) { notices.push_back(notice); };
  return axes;
}

struct Notices {
  std::vector<std::string> notices;
};

/// Two masters, a knife behind the first, a label behind the second, all recorded.
struct Line : Notices, Site {
  /// `fast`: the line's velocity, its units a second.
  explicit Line(const LossSpec& loss = bad, double fast = 1000)
      : Site(telling(notices, knife_and_label(fast)),
             {.masters = line_and_web(fast), .recorded = true}),
        lossy(their_link, loss, clock) {
    before = [this] {
      for (Sender* sender : {&line, &web})
        if (!sender->silent) send_message(lossy, {sender->name, 0, sender->sample(clock())});
      static_cast<void>(lossy.receive(0ns));
      if (each_turn) each_turn();
    };
    link.subscribe(wire::channel("knife", wire::Lane::reply), 64);
    link.subscribe(wire::channel("knife", wire::Lane::masters), 4096);
    link.subscribe(wire::channel("label", wire::Lane::masters), 4096);
  }

  const Tick& knife() const { return last(0); }
  const Tick& label() const { return last(1); }
  const MasterReading& seen(std::size_t master) const { return dispatcher.masters().last(master); }

  StreamOutcome couple(const TablePtr& cam, StreamPlan plan = {}) {
    plan.executor = "knife";
    plan.tables = {{*cam, over_master}};
    plan.mode = wire::ArmMode::follow_input;
    return stream(std::move(plan));
  }

  MemoryTransport their_link{network};
  LossyTransport lossy;
  Sender line{.name = "line", .position = [](double t) { return 1000 * t; }};
  Sender web{.name = "web", .position = [](double t) { return 200 * std::sin(2 * t); }};
  std::function<void()> each_turn;
};

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// Result of a replay of a record with followers of `cam`: the number of cycles in which the knife
/// was on the cam of the recorded master, to the last bit, and the number of the other cycles.
struct Compared {
  std::int64_t same = 0, other = 0, lost = 0;
};
Compared compared(Line& site, const Table& cam) {
  Compared count;
  std::map<std::size_t, MasterReading> sights;
  const Replay r = site.replayed(
      [&](const RecordedCycle& c) {
        if (c.axis != 0 || c.tick.progress != Progress::running || c.tick.job == 0) return;
        if (c.tick.state != State::synchronized_motion) return;
        // It was coupled where the cam and the slave are at 0.
        const Jet exact = placed(cam, {.periodic = true}, sights[0].at);
        const bool same =
            same_bits(exact[0], c.tick.position) && same_bits(exact[1], c.tick.velocity);
        ++(same ? count.same : count.other);
      },
      [&](const RecordedSight& s) {
        sights[s.master] = s.sight;
        count.lost += s.master == 0 && s.sight.lost();
      });
  EXPECT_TRUE(r.same()) << r.shorter << (r.difference ? r.difference->what.field : "");
  EXPECT_EQ(r.masters.size(), 2U);
  return count;
}

// PMC600 manual Fig. 6.14, 360 by 232, behind a line at 1 m/s.
TEST(ExternalMasterRun, ThePmc600sCamIsThatOfTheRecordedMasterToTheLastBit) {
  Line site;
  site.line.position = [](double t) { return std::max(0.0, 1000 * (t - 1)); };
  site.advance(500ms);
  ASSERT_FALSE(site.seen(0).lost());
  const auto cam = pmc600_cam();
  const StreamOutcome outcome =
      site.couple(cam, {.executor = {}, .tables = {}, .coupling = {.slave_absolute = false}});
  ASSERT_TRUE(outcome.ok()) << outcome.reason;
  site.advance(6s);
  EXPECT_EQ(site.knife().fault, Cause::none);
  EXPECT_NEAR(site.seen(0).at[0], 5500, 400);
  const Compared count = compared(site, *cam);
  EXPECT_GT(count.same, 5000);
  EXPECT_EQ(count.other, 0);
}

TEST(ExternalMasterRun, ALostMasterStopsItsFollowerAndNothingElse) {
  for (const char* const how : {"silent", "invalid", "another clock"}) {
    SCOPED_TRACE(how);
    Line site;
    site.advance(500ms);
    Client label(site.link, "label", {}, site.clock);
    ASSERT_TRUE(label.command(command::GearIn{.numerator = 1, .denominator = 2}).ok());
    ASSERT_TRUE(label.release().ok());
    Client knife(site.link, "knife", {}, site.clock);
    ASSERT_TRUE(knife.command(command::GearIn{.numerator = 1, .denominator = 1}).ok());
    ASSERT_TRUE(knife.release().ok());
    site.advance(1s);
    ASSERT_EQ(site.knife().state, State::synchronized_motion);
    ASSERT_NEAR(site.knife().velocity, 1000, 20);
    const std::string what = how;
    if (what == "silent") site.line.silent = true;
    if (what == "invalid") site.line.valid = false;
    if (what == "another clock") ++site.line.clock;
    site.advance(1s);
    EXPECT_EQ(site.knife().fault, Cause::master_lost);
    EXPECT_EQ(site.knife().velocity, 0);
    EXPECT_EQ(site.label().fault, Cause::none);
    EXPECT_EQ(site.label().state, State::synchronized_motion);
    EXPECT_THAT(site.notices, Contains(HasSubstr("master line is lost at tick")));
    const double stands = site.knife().position;
    site.line.silent = false;
    site.line.valid = true;
    site.advance(1s);
    EXPECT_FALSE(site.seen(0).lost()) << "it is back";
    EXPECT_EQ(site.knife().position, stands) << "and nothing runs after it";
    std::int64_t lost = 0;
    const Replay r =
        site.replayed({}, [&](const RecordedSight& s) { lost += s.master == 0 && s.sight.lost(); });
    EXPECT_TRUE(r.same()) << r.shorter;
    EXPECT_GT(lost, 0);
  }
}

// Replayed samples move nothing: every tick is the same with and without them.
TEST(ExternalMasterRun, SamplesOfBeforeDoNothing) {
  const auto run = [](bool replayed) {
    Line site({.seed = 3});
    std::vector<wire::Master> heard;
    MemoryTransport attacker(site.network);
    site.each_turn = [&] {
      heard.push_back({.seq = site.line.seq,
                       .stamp_ns = heard.empty() ? 1 : heard.back().stamp_ns,
                       .clock = 1,
                       .valid = true,
                       .position = -777,
                       .unit = "mm"});
      if (!replayed || heard.size() < 100) return;
      for (std::size_t i = 0; i < 5; ++i)
        send_message(attacker, {"line", 0, heard[(heard.size() * 7919 + i) % heard.size()]});
    };
    site.advance(500ms);
    Client knife(site.link, "knife", {}, site.clock);
    EXPECT_TRUE(knife.command(command::GearIn{.numerator = 1, .denominator = 1}).ok());
    EXPECT_TRUE(knife.release().ok());
    std::vector<double> positions;
    for (int i = 0; i < 2000; ++i) {
      site.advance(1ms);
      positions.push_back(site.knife().position);
    }
    EXPECT_EQ(site.dispatcher.masters().status(0).refused > 5000, replayed);
    return positions;
  };
  EXPECT_EQ(run(false), run(true));
}

TEST(ExternalMasterRun, EachMasterIsReportedByTheAxesThatFollowIt) {
  Line site;
  site.web.silent = true;
  site.advance(1s);
  std::map<std::string, wire::MasterStatus> last;
  Rejects rejects;
  while (const auto message = next_message(site.link, 0ns, rejects)) {
    const auto* status = std::get_if<wire::MasterStatus>(&message->body);
    if (status == nullptr) continue;
    EXPECT_EQ(message->executor, status->master == "line" ? "knife" : "label");
    last[status->master] = *status;
  }
  ASSERT_EQ(last.size(), 2U);
  EXPECT_FALSE(last["line"].lost);
  EXPECT_NEAR(last["line"].position, 1000, 60);
  EXPECT_NEAR(last["line"].velocity, 1000, 20);
  EXPECT_LT(last["line"].age_s, 0.02);
  EXPECT_GT(last["line"].taken, 500);
  EXPECT_GT(last["line"].refused, 20) << "overtaken and doubled";
  EXPECT_TRUE(last["web"].lost);
  EXPECT_TRUE(std::isnan(last["web"].position));
  EXPECT_TRUE(std::isnan(last["web"].age_s));
  EXPECT_EQ(last["web"].taken, 0);
}

TEST(ExternalMasterRun, AMasterInAnotherUnitIsRejectedAndNamed) {
  Line site;
  site.line.unit = "in";
  site.advance(500ms);
  EXPECT_TRUE(site.seen(0).lost());
  EXPECT_THAT(site.notices,
              Contains("master line: samples rejected, because their unit is in, not mm"));
}

// 5 m/s with velocity = 3 m/s and jump = 0.3 m: reported with its numbers, then lost.
TEST(ExternalMasterRun, AMasterAboveItsVelocityIsReportedAndThenLost) {
  Line site;
  site.line.position = [](double t) { return t < 2 ? 1000 * t : 2000 + 5000 * (t - 2); };
  site.advance(500ms);
  Client knife(site.link, "knife", {}, site.clock);
  ASSERT_TRUE(knife.command(command::GearIn{.numerator = 1, .denominator = 1}).ok());
  ASSERT_TRUE(knife.release().ok());
  site.advance(3s);
  EXPECT_EQ(site.knife().fault, Cause::master_lost);
  EXPECT_TRUE(site.seen(0).lost());
  EXPECT_GT(site.seen(0).lag.distance, 300);
  EXPECT_NEAR(site.seen(0).lag.velocity, 5000, 100);
  const auto reported = [](const std::string& notice) {
    return notice.find("limit velocity = 3000 mm/s") != std::string::npos &&
           notice.find("jump = 300 mm") != std::string::npos;
  };
  EXPECT_EQ(std::count_if(site.notices.begin(), site.notices.end(), reported), 1);
  const Replay r = site.replayed();
  EXPECT_TRUE(r.same()) << r.shorter << (r.difference ? r.difference->what.field : "");
}

// Googol's example 7-8, 802 segments through a dynamic queue: PASS at 50000 pulses of a line at 50 a ms.
TEST(ExternalMasterRun, AGoogolFollowTableWaitsForTheLineAndIsThatOfTheRecordedOne) {
  Line site(bad, 50e3);
  site.line.position = [](double t) { return std::max(0.0, 50e3 * (t - 1.5)); };
  site.advance(300ms);
  const FollowTable table = test::example_7_8();
  std::vector<wire::Row> rows;
  for (const PtPoint& point : table.segments) {
    const SegmentRow row = row_of(point, rows.empty());
    wire::Row& sent = rows.emplace_back(wire::Row{.x_end = row.x_end, .p_end = row.p_end});
    sent.order = static_cast<wire::RowOrder>(row.degree);
    if (row.degree >= 2) sent.v_start = row.v_start, sent.v_end = row.v_end;
  }
  rows.back().last = true;
  std::size_t next = 0;
  RowPlan plan{.executor = "knife", .rows = [&](std::size_t most) {
                 std::vector<wire::Row> some;
                 while (next < rows.size() && some.size() < most) some.push_back(rows[next++]);
                 return some;
               }};
  plan.queue = {.axis = Domain::master,
                .units = over_master,
                .capacity = 1000,
                .event = wire::QueueEvent::pass,
                .event_position = 50000,
                .event_direction = 1,
                .prefill = 802};
  const RowOutcome outcome = stream_rows(site.link, std::move(plan), {}, site.clock, 1);
  EXPECT_TRUE(outcome.ok()) << outcome.reason;
  EXPECT_EQ(outcome.progress.played, 802);
  EXPECT_NEAR(site.knife().position, 100000, 1e-7) << "stated";

  const Cam exact = follow(FollowSpec{{table}}).cam;
  std::map<std::size_t, MasterReading> sights;
  std::int64_t within = 0;
  const Replay r = site.replayed(
      [&](const RecordedCycle& c) {
        const double gone = sights[0].at[0] - 50000;
        if (c.axis != 0 || c.tick.state != State::synchronized_motion || !(gone > 0)) return;
        within += gone < exact.end();
        EXPECT_NEAR(c.tick.position, exact.jet(std::min(gone, exact.end()))[0], 1e-7) << gone;
      },
      [&](const RecordedSight& s) { sights[s.master] = s.sight; });
  EXPECT_TRUE(r.same()) << r.shorter;
  EXPECT_GT(within, 2300) << "120000 pulses at 50 a ms";
}

// The label waits for 800 mm of a line that comes from 0.
TEST(ExternalMasterRun, ACamStartsWhereTheMasterPassesAPosition) {
  Line site;
  site.line.position = [](double t) { return std::max(0.0, 1000 * (t - 1)); };
  site.advance(300ms);
  const auto cam = table(Domain::master, Interpolation::quintic_hermite, Extrapolation::hold,
                         {{800, 1300, 1800}, {0, 400, 0}, {0, 0, 0}, {0, 0, 0}});
  StreamPlan plan;
  plan.coupling = {.slave_absolute = false};
  plan.when = StartAt::master_position;
  plan.position = 800;
  const StreamOutcome outcome = site.couple(cam, plan);
  ASSERT_TRUE(outcome.ok()) << outcome.reason;
  double first = NAN, furthest = 0;
  for (int i = 0; i < 3000; ++i) {
    site.advance(1ms);
    if (std::isnan(first) && site.knife().position != 0) first = site.seen(0).at[0];
    furthest = std::max(furthest, site.knife().position);
  }
  EXPECT_GT(first, 800);
  EXPECT_LT(first, 860);
  EXPECT_NEAR(furthest, 400, 0.5);
  EXPECT_EQ(site.knife().fault, Cause::none);
  EXPECT_TRUE(site.replayed().same());
}

// GearInPos in step at (1500, 500), and the ratio from there on.
TEST(ExternalMasterRun, AGearIsInStepWithTheRecordedMaster) {
  Line site;
  site.line.position = [](double t) { return std::max(0.0, 1000 * (t - 1)); };
  site.advance(600ms);
  Client knife(site.link, "knife", {}, site.clock);
  const auto in = knife.command(command::GearInPos{.numerator = 1,
                                                   .denominator = 2,
                                                   .master_sync_position = 1500,
                                                   .slave_sync_position = 400,
                                                   .master_start_distance = 800});
  ASSERT_TRUE(in.ok()) << in.reason;
  ASSERT_TRUE(knife.release().ok());
  site.advance(4s);
  std::int64_t in_step = 0;
  std::map<std::size_t, MasterReading> sights;
  const Replay r = site.replayed(
      [&](const RecordedCycle& c) {
        const double x = sights[0].at[0];
        if (c.axis != 0 || !(x > 1500)) return;
        ++in_step;
        EXPECT_NEAR(c.tick.position, 400 + (x - 1500) / 2, 1e-9);
      },
      [&](const RecordedSight& s) { sights[s.master] = s.sight; });
  EXPECT_TRUE(r.same()) << r.shorter;
  EXPECT_GT(in_step, 1500);
}

}  // namespace
}  // namespace jounce::external_master_test
