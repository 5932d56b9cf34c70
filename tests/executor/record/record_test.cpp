// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/detail/record.hpp"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lcm/lcm-cpp.hpp>

#include "jounce/executor/detail/recorder.hpp"
#include "jounce/executor/detail/replay.hpp"
#include "jounce/profiles/error.hpp"

#include "axis/tables.hpp"
#include "support/errors.hpp"
#include "support/random.hpp"
#include "support/temporary_folder.hpp"

namespace jounce::record_test {
namespace {

using test::Kind;
using ::testing::HasSubstr;

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Replay replayed(const std::string& bytes) {
  std::istringstream in(bytes);
  return replay(in, "test.lcmlog");
}

/// A folder of its own, with axes that are recorded while they run.
class Recorded : public ::testing::Test {
 protected:
  std::filesystem::path path(const char* name) const { return folder_ / name; }

  void start(RecorderOptions options, std::size_t count = 1) {
    std::vector<RecordedAxis> axes;
    for (std::size_t i = 0; i < count; ++i) {
      axes.push_back({.axis = i,
                      .name = "axis" + std::to_string(i),
                      .units = {"deg", "mm"},
                      .config = config_});
      motions_.push_back(std::make_unique<MotionAxis>(config_));
    }
    options.notify = [this](const std::string& notice) { notices_.push_back(notice); };
    recorder_ = std::make_unique<Recorder>(options, axes, *buffer_);
  }

  Tick step(const Command& command = {}, const Inputs& inputs = {}, std::size_t axis = 0) {
    const Tick tick = motions_[axis]->step(tick_, command, inputs);
    buffer_->add(axis, command, inputs, tick);
    return tick;
  }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      for (std::size_t axis = 0; axis < motions_.size(); ++axis) step({}, {}, axis);
      next();
    }
  }
  void order(const Command& command, std::size_t axis = 0) {
    for (std::size_t i = 0; i < motions_.size(); ++i) step(i == axis ? command : Command{}, {}, i);
    next();
  }
  void next() {
    ++tick_;
    recorder_->turn();
  }

  static StoredTable store(const std::shared_ptr<const Table>& table, const Units& units) {
    return {content_hash(*table, units), units, table};
  }

  /// A cam behind a master at constant velocity, as `axis` is about to arm it.
  Movement* cam(std::uint64_t id, std::size_t axis = 0) {
    const auto master = test::constant_master(360, 720);
    const auto slave =
        test::table(Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap,
                    {{0, 120, 180, 300, 360}, {0, 90, 90, 0, 0}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}});
    jobs_.push_back(std::make_unique<Job>(id, master, slave));
    const StoredTable stored = store(slave, {"deg", "mm"});
    recorder_->job({.axis = axis, .id = id}, store(master, {"s", "deg"}), &stored);
    return jobs_.back().get();
  }

  AxisConfig config_{.limits = test::limits(1e4, 1e6), .position = 0};
  test::TemporaryFolder folder_;
  std::unique_ptr<RecordBuffer> buffer_ = std::make_unique<RecordBuffer>();
  std::unique_ptr<Recorder> recorder_;
  std::vector<std::unique_ptr<MotionAxis>> motions_;
  std::vector<std::unique_ptr<Job>> jobs_;
  std::vector<std::string> notices_;
  std::int64_t tick_ = 0;
};

TEST_F(Recorded, ARunIsReplayedToTheLastBit) {
  start({.log = path("run.lcmlog")}, 2);
  order({command::Enable{}});
  order({command::Enable{}}, 1);
  order({command::Arm{.movement = cam(7)}});
  order({command::Start{}});
  run(100);
  order({command::Arm{.movement = cam(7, 1)}}, 1);  // the same number on another axis
  order({command::Start{.tick = tick_ + 20}}, 1);
  run(200);
  tick_ += 13;  // a late cycle
  run(50);
  order({command::Stop{}}, 1);
  run(300);
  order({command::Start{}});  // refused: nothing is armed
  order({command::SetPosition{.position = 12.5}});
  order({command::Abort{}});
  run(5);
  order({command::Reset{}});
  order({command::MoveAbsolute{.position = 90, .dynamics = {.velocity = 300}}});
  run(40);
  order({command::Override{.factor = 0.3}});
  run(40);
  order({command::Halt{}});
  run(100);
  EXPECT_FALSE(std::filesystem::exists(path("run.lcmlog"))) << "not before it is closed";
  recorder_->close();
  EXPECT_EQ(recorder_->trouble(), "");
  EXPECT_FALSE(std::filesystem::exists(path("run.lcmlog.part")));

  const Replay result = replayed(bytes_of(path("run.lcmlog")));
  EXPECT_TRUE(result.same()) << result.shorter
                             << (result.difference ? result.difference->what.field : "");
  ASSERT_EQ(result.axes.size(), 2U);
  EXPECT_EQ(result.axes[1].name, "axis1");
  EXPECT_EQ(result.axes[1].units.position, "mm");
  EXPECT_EQ(result.cycles, result.compared);
  EXPECT_EQ(result.first_tick, 0);
  EXPECT_EQ(result.last_tick, tick_ - 1);
}

TEST_F(Recorded, MovesThatWaitAndBlendAreReplayedToo) {
  start({.log = path("run.lcmlog")});
  order({command::Enable{}});
  for (const BufferMode mode :
       {BufferMode::buffered, BufferMode::blending_low, BufferMode::blending_high}) {
    order({command::MoveRelative{.distance = 40, .dynamics = {.velocity = 400}}});
    order({command::MoveRelative{.distance = 30, .dynamics = {.velocity = 600}, .buffer = mode}});
    run(300);
  }
  order({.what = command::MoveRelative{.distance = 5}, .at = tick_ + 20});
  run(100);
  recorder_->close();
  const Replay result = replayed(bytes_of(path("run.lcmlog")));
  EXPECT_TRUE(result.same()) << result.shorter
                             << (result.difference ? result.difference->what.field : "");
}

TEST_F(Recorded, LcmsOwnReaderReadsIt) {
  start({.log = path("run.lcmlog")});
  order({command::Enable{}});
  order({command::Arm{.movement = cam(1)}});
  run(10);
  recorder_->close();
  lcm::LogFile log(path("run.lcmlog").string(), "r");
  ASSERT_TRUE(log.good());
  std::vector<std::string> channels;
  std::int64_t number = 0;
  while (const lcm::LogEvent* event = log.readNextEvent()) {
    EXPECT_EQ(event->eventnum, number++);
    channels.emplace_back(event->channel);
    const std::string_view data(static_cast<const char*>(event->data),
                                static_cast<std::size_t>(event->datalen));
    EXPECT_TRUE(decoded(event->channel, data));
    EXPECT_TRUE(event->timestamp % 1000 == 0 && event->timestamp <= 11'000);
  }
  ASSERT_EQ(channels.size(), 1U + 1U + 2U + 1U + 11U + 2U) << "and two checksums";
  EXPECT_EQ(channels[0], "JOUNCE.axis");
  EXPECT_THAT(channels, ::testing::Contains("JOUNCE.job"));
}

TEST_F(Recorded, TheFirstDifferenceIsFound) {
  start({.log = path("run.lcmlog")});
  order({command::Enable{}});
  order({command::Arm{.movement = cam(1)}});
  order({command::Start{}});
  run(200);
  recorder_->close();
  // One bit of the position of one tick, by our own events: the last digit.
  lcm::LogFile log(path("run.lcmlog").string(), "r");
  {
    lcm::LogFile out(path("forged.lcmlog").string(), "w");
    while (const lcm::LogEvent* event = log.readNextEvent()) {
      std::string data(static_cast<const char*>(event->data),
                       static_cast<std::size_t>(event->datalen));
      auto record = *decoded(event->channel, data);
      if (auto* cycle = std::get_if<RecordedCycle>(&record);
          cycle != nullptr && cycle->tick.tick == 150) {
        cycle->tick.position = std::nextafter(cycle->tick.position, 1e9);
        data = encoded(record);
      }
      lcm::LogEvent copy = *event;
      copy.data = data.data();
      out.writeEvent(&copy);
    }
  }
  const Replay result = replayed(bytes_of(path("forged.lcmlog")));
  ASSERT_TRUE(result.difference);
  EXPECT_EQ(result.difference->tick, 150);
  EXPECT_EQ(result.difference->what.field, "position");
  EXPECT_EQ(result.difference->what.recorded,
            std::nextafter(result.difference->what.replayed, 1e9));
  EXPECT_EQ(result.cycles, 203) << "the rest is read all the same";
  EXPECT_EQ(result.compared, 151);
}

TEST_F(Recorded, ATruncatedRecordIsReplayedToItsEnd) {
  start({.log = path("run.lcmlog")});
  order({command::Enable{}});
  order({command::Arm{.movement = cam(1)}});
  order({command::Start{}});
  run(50);
  recorder_->close();
  const std::string whole = bytes_of(path("run.lcmlog"));
  const RecordedCheck check;  // the last event
  const std::size_t last = 28 + channel_of(check).size() + encoded(check).size();
  const Replay cut = replayed(whole.substr(0, whole.size() - last - 5));
  EXPECT_FALSE(cut.difference);
  EXPECT_THAT(cut.shorter, HasSubstr("cut off"));
  EXPECT_EQ(cut.compared, 52);
  EXPECT_EQ(cut.last_tick, 51);
  int errors = 0;
  for (std::size_t size = 0; size < whole.size(); size += 97) {
    try {
      const Replay some = replayed(whole.substr(0, size));
      EXPECT_FALSE(some.difference) << size;
    } catch (const InputError&) {
      ++errors;  // not even the axis is there
    }
  }
  EXPECT_LE(errors, 6);
  EXPECT_GT(errors, 0);
}

TEST_F(Recorded, WhatIsDamagedIsAnErrorOrADifferenceAndNeverACrash) {
  start({.log = path("run.lcmlog")});
  order({command::Enable{}});
  order({command::Arm{.movement = cam(1)}});
  order({command::Start{}});
  run(20);
  recorder_->close();
  const std::string whole = bytes_of(path("run.lcmlog"));
  EXPECT_TRUE(replayed(whole).has_checksums);
  // Numbers and time stamps of the events, which the replay does not use.
  std::set<std::size_t> unused;
  for (std::size_t event = 0; event < whole.size();) {
    const auto length = [&](std::size_t at) {
      std::size_t value = 0;
      for (std::size_t i = 0; i < 4; ++i)
        value = value << 8U | static_cast<unsigned char>(whole[event + at + i]);
      return value;
    };
    for (std::size_t i = 4; i < 20; ++i) unused.insert(event + i);
    event += 28 + length(20) + length(24);
  }
  test::Random random(714);
  int same = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string damaged = whole;
    const std::size_t at = random.next() % whole.size();
    const auto bit = static_cast<unsigned char>(1U << (random.next() % 8));
    damaged[at] = static_cast<char>(static_cast<unsigned char>(damaged[at]) ^ bit);
    SCOPED_TRACE(::testing::Message() << "byte " << at << ", bit " << static_cast<int>(bit));
    try {
      const bool is_same = replayed(damaged).same();
      EXPECT_TRUE(!is_same || unused.contains(at));
      same += is_same;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("test.lcmlog"));
    }
  }
  EXPECT_LT(same, 3000) << "the rest are numbers and time stamps of the events";
}

TEST_F(Recorded, AChecksumShowsALostEventAndAnOldRecordHasNone) {
  start({.log = path("run.lcmlog")});
  order({command::Enable{}});
  run(20);
  recorder_->close();
  const auto without = [&](const std::string& channel, int first) {
    lcm::LogFile log(path("run.lcmlog").string(), "r");
    {
      lcm::LogFile out(path("less.lcmlog").string(), "w");
      for (int seen = 0; const lcm::LogEvent* event = log.readNextEvent();) {
        if (event->channel == channel && seen++ >= first) continue;
        lcm::LogEvent copy = *event;
        out.writeEvent(&copy);
      }
    }
    return replayed(bytes_of(path("less.lcmlog")));
  };
  const Replay lost = without("JOUNCE.cycle", 15);
  EXPECT_FALSE(lost.difference);
  EXPECT_THAT(lost.damage, HasSubstr("an event was changed, added or lost"));
  EXPECT_FALSE(lost.same());
  EXPECT_THAT(without("JOUNCE.check", 1).damage, HasSubstr("is missing"));
  const Replay old = without("JOUNCE.check", 0);
  EXPECT_FALSE(old.has_checksums);
  EXPECT_TRUE(old.same()) << old.damage;
}

TEST_F(Recorded, ForeignFilesAreRejectedAndForeignChannelsLeftOut) {
  EXPECT_THROW(replayed(""), InputError);
  EXPECT_THROW(replayed("tick,time [s],state\n0,0,disabled,and so on for a while\n"), InputError);
  start({.log = path("run.lcmlog")});
  run(3);
  recorder_->close();
  {
    lcm::LogFile log(path("run.lcmlog").string(), "r");
    lcm::LogFile out(path("mixed.lcmlog").string(), "w");
    while (const lcm::LogEvent* event = log.readNextEvent()) {
      lcm::LogEvent other = *event;
      other.channel = "CAMERA";
      out.writeEvent(&other);
      lcm::LogEvent copy = *event;
      out.writeEvent(&copy);
    }
  }
  EXPECT_EQ(replayed(bytes_of(path("mixed.lcmlog"))).compared, 3);
}

// Records from before the replay of outputs.
TEST(RecordedEvents, OfAnAxisOfVersionTwoAreRejectedInOneError) {
  std::string bytes = encoded(RecordedAxis{});
  ASSERT_EQ(bytes[9], 8) << "the version, big-endian, after eight bytes of the type";
  bytes[9] = 2;
  try {
    decoded("JOUNCE.axis", bytes);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.key(), "version");
    EXPECT_EQ(error.value(), "2");
  }
}

// LCM's fingerprint stands for the fields of a type: a cycle of other fields is another version's.
TEST(RecordedEvents, OfAnotherVersionAreRejected) {
  std::string bytes = encoded(RecordedCycle{});
  bytes[3] = static_cast<char>(bytes[3] ^ 1);
  for (const std::string& other : {bytes, bytes.substr(0, bytes.size() - 17)}) {
    try {
      decoded("JOUNCE.cycle", other);
      FAIL();
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("JOUNCE.cycle"));
      EXPECT_THAT(error.what(), HasSubstr("with the version of jounce that wrote it"));
    }
  }
}

TEST_F(Recorded, ATableThatIsNotTheOneOfItsHashIsRejected) {
  std::string bytes;
  start({.log = path("run.lcmlog")});
  order({command::Enable{}});
  (void)cam(1);
  recorder_->close();
  bytes = bytes_of(path("run.lcmlog"));
  EXPECT_TRUE(replayed(bytes).same());
  const double ninety = 90;  // a knot of the cam, big-endian
  std::string knot(8, '\0');
  std::uint64_t bits = 0;
  std::memcpy(&bits, &ninety, 8);
  for (std::size_t i = 0; i < 8; ++i) knot[i] = static_cast<char>(bits >> (56 - 8 * i));
  const std::size_t at = bytes.find(knot);
  ASSERT_NE(at, std::string::npos);
  bytes[at + 7] = 1;
  try {
    replayed(bytes);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("does not match its hash"));
  }
}

TEST_F(Recorded, AMissingMovementEndsTheReplayWithAnError) {
  start({.log = path("run.lcmlog")});
  order({command::Enable{}});
  Job unknown(5, test::there_and_back(0, 10, 1, Extrapolation::hold));
  order({command::Arm{.movement = &unknown}});
  run(10);
  recorder_->close();
  const Replay result = replayed(bytes_of(path("run.lcmlog")));
  EXPECT_FALSE(result.same());
  EXPECT_FALSE(result.difference);
  EXPECT_THAT(result.shorter, HasSubstr("movement 5"));
  EXPECT_EQ(result.compared, 1);
  EXPECT_EQ(result.cycles, 12);
}

TEST_F(Recorded, WhatFoundNoRoomIsCountedAndTheReplayEndsThere) {
  start({.log = path("run.lcmlog")});
  const auto burst = [&](std::size_t cycles) {
    for (std::size_t i = 0; i < cycles; ++i) {
      step();
      ++tick_;
    }
  };
  burst(RecordBuffer::capacity + 100);
  recorder_->turn();
  EXPECT_EQ(recorder_->lost(), 0) << "it is reported with the next event that fits";
  burst(10);
  recorder_->turn();
  EXPECT_EQ(recorder_->lost(), 100);
  recorder_->close();
  EXPECT_EQ(notices_.size(), 1U);
  const Replay result = replayed(bytes_of(path("run.lcmlog")));
  EXPECT_EQ(result.compared, static_cast<std::int64_t>(RecordBuffer::capacity));
  EXPECT_EQ(result.cycles, static_cast<std::int64_t>(RecordBuffer::capacity) + 10);
  EXPECT_THAT(result.shorter, HasSubstr("100 cycles are missing"));
}

TEST_F(Recorded, AFullDiskEndsTheRecordAndNothingElse) {
  start({.log = "/dev/full"});
  order({command::Enable{}});
  run(5000);
  order({command::Arm{.movement = cam(1)}});
  order({command::Start{}});
  run(100);
  EXPECT_EQ(motions_[0]->state(), State::synchronized_motion);
  recorder_->close();
  EXPECT_THAT(recorder_->trouble(), HasSubstr("No space left"));
  EXPECT_EQ(notices_.size(), 1U) << "reported once";
}

// Each file that cannot be written is reported, once, after any other failure.
TEST_F(Recorded, AFullDiskIsReportedForTheBlackBoxToo) {
  start({.log = "/dev/full", .black_box = "/dev/full"});
  order({command::Enable{}});
  run(5000);
  EXPECT_EQ(recorder_->unwritten(), wire::record_unwritten);
  for (int i = 0; i < 2; ++i) {
    order({command::Abort{}});
    order({command::Reset{}});
    run(10);
  }
  EXPECT_EQ(recorder_->unwritten(), wire::record_unwritten | wire::black_box_unwritten);
  ASSERT_EQ(notices_.size(), 2U);
  EXPECT_THAT(notices_[0], HasSubstr("the record ends here"));
  EXPECT_THAT(notices_[1], HasSubstr("no black box: "));
  EXPECT_THAT(notices_[1], HasSubstr("No space left"));
}

TEST_F(Recorded, AFaultLeavesABlackBoxOfTheCyclesBeforeIt) {
  start({.black_box = path("box.lcmlog"), .black_box_cycles = 50}, 2);
  order({command::Enable{}});
  order({command::Arm{.movement = cam(1)}});
  order({command::Start{}});
  run(200);
  EXPECT_FALSE(std::filesystem::exists(path("box.lcmlog")));
  order({command::Abort{}});
  ASSERT_TRUE(std::filesystem::exists(path("box.lcmlog")));
  const std::string box = bytes_of(path("box.lcmlog"));
  std::vector<RecordedCycle> seen;
  std::istringstream in(box);
  const Replay result = replay(in, "box", [&](const RecordedCycle& cycle) {
    if (cycle.axis == 0) seen.push_back(cycle);
  });
  EXPECT_FALSE(result.axes[0].whole);
  EXPECT_EQ(result.compared, 0);
  EXPECT_THAT(result.shorter, HasSubstr("black box"));
  ASSERT_EQ(seen.size(), 50U);
  EXPECT_EQ(seen.back().tick.fault, Cause::aborted);
  EXPECT_EQ(seen.back().tick.tick, tick_ - 1);
  EXPECT_EQ(seen[48].tick.fault, Cause::none);
  for (std::size_t i = 1; i < seen.size(); ++i)
    EXPECT_EQ(seen[i].tick.tick, seen[i - 1].tick.tick + 1);
  run(20);
  EXPECT_EQ(bytes_of(path("box.lcmlog")), box) << "a fault that stays is not another one";
  order({command::Reset{}});
  order({command::Abort{}});
  EXPECT_NE(bytes_of(path("box.lcmlog")), box) << "a new one is";
}

TEST_F(Recorded, BadPathsAndNumbersAreRejectedAtOnce) {
  EXPECT_THROW(start({.log = path("no/such/folder.lcmlog")}), std::system_error);
  EXPECT_THROW(start({.black_box = path("box"), .black_box_cycles = 0}), InputError);
  EXPECT_THROW(start({.black_box = path("no/such/box.lcmlog")}), std::system_error)
      << "before a fault comes";
}

// Each kind with fields that no default has: nothing of it is lost, and an old reader finds it in the same field.
TEST(RecordedEvents, EveryCommandComesBack) {
  constexpr MoveDynamics dynamics{1.5, 2.5, 3.5, 4.5};
  const Command commands[] = {{},
                              {command::Enable{}},
                              {command::Start{StartAt::master_position, -1, 460}},
                              {command::Start{.tick = 1600}},
                              {command::Stop{{3.5, 4.5}}},
                              {command::SetPosition{12.5, true}},
                              {.what = command::Override{0.3}, .at = 400},
                              {command::Home{12, 24, 1.5, 5.5, 2.5, 6.5, 7.5}},
                              {command::MoveRelative{-3, dynamics, BufferMode::blending_high}},
                              {.what = command::MoveAdditive{-3, dynamics}, .at = 7},
                              {command::MoveSuperimposed{-3, dynamics}},
                              {command::MoveVelocity{-3, {2.5, 3.5, 4.5}, BufferMode::buffered}},
                              {command::Halt{{.deceleration = 3.5, .jerk = 4.5}}},
                              {command::Couple{.tick = 99}}};
  for (const Command& command : commands) {
    const std::string bytes = encoded(RecordedCycle{.command = command});
    const auto back = std::get<RecordedCycle>(*decoded("JOUNCE.cycle", bytes));
    EXPECT_EQ(back.command.kind(), command.kind());
    EXPECT_EQ(back.command.at, command.at);
    EXPECT_EQ(encoded(back), bytes) << name(command.kind());
    if (command.kind() == Kind::enable || command.kind() == Kind::none) continue;
    RecordedCycle bare{.command = {*made<AxisCommand>(command.kind())}};
    EXPECT_NE(encoded(bare), bytes) << name(command.kind());
  }
}

// The members that no client sends.
TEST(RecordedEvents, GroupsTicksAndConditionsComeBack) {
  const auto back = [](const Command& command) {
    const std::string bytes = encoded(RecordedCycle{.command = command});
    return std::get<RecordedCycle>(*decoded("JOUNCE.cycle", bytes)).command.what;
  };
  constexpr std::int64_t large = (std::int64_t{1} << 60) + 1;  // a double would round it
  EXPECT_EQ(std::get<command::Arm>(back({command::Arm{.group = large}})).group, large);
  const auto start = std::get<command::Start>(
      back({command::Start{StartAt::master_position, large, 460.5, large + 2}}));
  EXPECT_EQ(start.when, StartAt::master_position);
  EXPECT_EQ(start.tick, large);
  EXPECT_EQ(start.position, 460.5);
  EXPECT_EQ(start.group, large + 2);
  const auto extend = std::get<command::Extend>(
      back({command::Extend{.position = 1.5, .shift = 2.5, .until = 3.5}}));
  EXPECT_EQ(extend.position, 1.5);
  EXPECT_EQ(extend.shift, 2.5);
  EXPECT_EQ(extend.until, 3.5);
  const auto jog =
      std::get<command::MoveVelocity>(back({command::MoveVelocity{.hold_to_run = true}}));
  EXPECT_TRUE(jog.hold_to_run);
}

TEST(RecordedEvents, ACountThatIsNoWholeNumberIsRejected) {
  const std::string whole =
      encoded(RecordedCycle{.command = {command::TouchProbe{.input = 2, .count = 7}}});
  const std::string seven("\x40\x1c\0\0\0\0\0\0", 8);                    // big-endian
  const std::string wrong[] = {std::string("\x7f\xf8\0\0\0\0\0\0", 8),   // NaN
                               std::string("\x40\x1e\0\0\0\0\0\0", 8),   // 7.5
                               std::string("\xbf\xf0\0\0\0\0\0\0", 8),   // -1
                               std::string("\x41\xe0\0\0\0\0\0\0", 8)};  // 2^31
  ASSERT_NE(whole.find(seven), std::string::npos);
  for (const std::string& bytes : wrong) {
    std::string damaged = whole;
    damaged.replace(damaged.find(seven), 8, bytes);
    EXPECT_THAT(test::error_of([&] { (void)decoded("JOUNCE.cycle", damaged); }, "no error"),
                HasSubstr("must be a whole number from 0 to 2147483647"));
  }
}

TEST(RecordedEvents, ComeBackAsTheyWere) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  RecordedCycle cycle{.axis = 3, .movement = 99};
  cycle.command = {.what = command::MoveAbsolute{.position = -0.1,
                                                 .dynamics = {1.1, 2.2, 3.3, 4.4},
                                                 .direction = Direction::negative,
                                                 .buffer = BufferMode::blending_next},
                   .at = 12345,
                   .id = 77};
  cycle.inputs = {
      .master = {1.5, -2.5, nan, 4.5},
      .feedback = {.position = 0.1, .velocity = nan, .torque = -0.7, .ready = false, .fault = true},
      .positive_switch = true,
      .watchdog = true};
  cycle.inputs.feedback.sensors.positive = {.wired = true, .on = true, .edge = -0.3};
  cycle.tick.tick = 1LL << 40;
  cycle.tick.position = 1.0 / 3;
  cycle.tick.fault = Cause::overspeed;
  cycle.tick.override_ = 0.7;
  cycle.tick.switches.outputs = 0x80000001;
  cycle.tick.refused = Refusal{Cause::not_armed, 1, nan, 3};
  const auto back = std::get<RecordedCycle>(*decoded("JOUNCE.cycle", encoded(cycle)));
  EXPECT_EQ(encoded(back), encoded(cycle));
  const auto& move = std::get<command::MoveAbsolute>(back.command.what);
  EXPECT_EQ(move.position, -0.1);
  EXPECT_EQ(move.direction, Direction::negative);
  EXPECT_EQ(move.dynamics.deceleration, 3.3);
  EXPECT_EQ(move.buffer, BufferMode::blending_next);
  EXPECT_EQ(back.command.at, 12345);
  EXPECT_EQ(back.command.id, 77U);
  EXPECT_TRUE(back.inputs.feedback.sensors.positive.on);
  EXPECT_EQ(back.inputs.feedback.sensors.positive.edge, -0.3);
  EXPECT_FALSE(back.inputs.feedback.sensors.negative.wired);
  EXPECT_EQ(back.inputs.feedback.torque, -0.7);
  EXPECT_TRUE(back.inputs.positive_switch);
  EXPECT_FALSE(back.inputs.negative_switch);
  EXPECT_EQ(back.tick.switches.outputs, 0x80000001U);
  EXPECT_EQ(back.tick.refused->where, 3);
  EXPECT_FALSE(first_difference(cycle.tick, back.tick)) << "NaN is NaN";

  Tick other = cycle.tick;
  other.switches.outputs = 1;
  EXPECT_EQ(first_difference(cycle.tick, other)->field, "outputs");
  EXPECT_FALSE(first_difference(cycle.tick, other, false));
  other.position = -0.0;
  Tick zero = other;
  zero.position = 0;
  EXPECT_EQ(first_difference(zero, other)->field, "position") << "to the bit: -0 is not 0";
}

TEST(RecordedEvents, EveryFieldOfATickCounts) {
  // Every field that a tick has, changed by itself.
  const Tick tick;
  std::vector<Tick> others;
  const auto with = [&](auto change) {
    others.push_back(tick);
    change(others.back());
  };
  with([](Tick& t) { t.tick = 1; });
  with([](Tick& t) { t.time = 1; });
  with([](Tick& t) { t.state = State::homing; });
  with([](Tick& t) { t.master = 1; });
  with([](Tick& t) { t.master_velocity = 1; });
  with([](Tick& t) { t.position = 1; });
  with([](Tick& t) { t.velocity = 1; });
  with([](Tick& t) { t.acceleration = 1; });
  with([](Tick& t) { t.job = 1; });
  with([](Tick& t) { t.armed = 1; });
  with([](Tick& t) { t.waiting = true; });
  with([](Tick& t) { t.progress = Progress::running; });
  with([](Tick& t) { t.fault = Cause::stalled; });
  with([](Tick& t) { t.skipped = 1; });
  with([](Tick& t) { t.finished = 1; });
  with([](Tick& t) { t.stopped = 1; });
  with([](Tick& t) { t.reason = Cause::stalled; });
  with([](Tick& t) { t.override_ = 0.5; });
  with([](Tick& t) { t.rate = 0.5; });
  with([](Tick& t) { t.held = true; });
  with([](Tick& t) { t.homed = true; });
  with([](Tick& t) { t.power = true; });
  with([](Tick& t) { t.offset = 1; });
  with([](Tick& t) { t.actual_position = 1; });
  with([](Tick& t) { t.following_error = 1; });
  with([](Tick& t) { t.torque = 1; });
  with([](Tick& t) { t.in_position = true; });
  with([](Tick& t) { t.switches.outputs = 1; });
  with([](Tick& t) { t.refused = Refusal{.cause = Cause::in_motion}; });
  for (std::size_t i = 0; i < others.size(); ++i)
    EXPECT_TRUE(first_difference(tick, others[i])) << "change " << i + 1;
}

TEST(RecordedEvents, ASearchWithoutADistanceIsZeroInTheRecord) {
  RecordedAxis axis;
  axis.config.limits = test::limits(3, 4, 5);
  const auto back = [&] { return std::get<RecordedAxis>(*decoded("JOUNCE.axis", encoded(axis))); };
  EXPECT_FALSE(back().config.homing.distance);
  const std::string without = encoded(axis);
  axis.config.homing.distance = 0;
  EXPECT_EQ(encoded(axis), without);
  axis.config.homing.distance = 9;
  EXPECT_NE(encoded(axis), without);
  EXPECT_EQ(back().config.homing.distance, 9);
}

TEST(RecordedEvents, AnAxisKeepsItsConfiguration) {
  RecordedAxis axis{.axis = 1, .name = "Zuführung", .units = {"deg", "mm"}, .switches = true};
  axis.config.period = 250'000;
  axis.config.limits = test::limits(3, 4, 5);
  axis.config.limits.position_min = -7;
  axis.config.following_error = 0.25;
  axis.config.homing = {.method = 24, .search_velocity = 2, .distance = 9};
  axis.config.require_home = true;
  const auto back = std::get<RecordedAxis>(*decoded("JOUNCE.axis", encoded(axis)));
  EXPECT_EQ(encoded(back), encoded(axis));
  EXPECT_EQ(back.name, "Zuführung");
  EXPECT_EQ(back.config.period, 250'000);
  EXPECT_EQ(back.config.limits.position_min, -7);
  EXPECT_FALSE(back.config.limits.position_max);
  EXPECT_EQ(back.config.following_error, 0.25);
  EXPECT_EQ(back.config.homing.method, 24);
  EXPECT_EQ(back.config.homing.distance, 9);
  EXPECT_TRUE(back.config.require_home);
  EXPECT_TRUE(back.switches);
  EXPECT_FALSE(decoded("LASER", encoded(axis)));
  EXPECT_THROW(decoded("JOUNCE.job", encoded(axis)), InputError);
}

}  // namespace
}  // namespace jounce::record_test
