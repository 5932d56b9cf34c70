// SPDX-License-Identifier: Apache-2.0
// Every kind of motion, with all that happens while it plays, in a cycle that is recorded: none of it is
// a reason to touch the heap, to lock or to write.
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <unistd.h>

#include "jounce/axis/detail/live_cuts.hpp"
#include "jounce/axis/fifo_movement.hpp"
#include "jounce/axis/live_cam.hpp"
#include "jounce/axis/live_clutch.hpp"
#include "jounce/axis/live_gear.hpp"
#include "jounce/drive/shared_drive.hpp"
#include "jounce/drive/simulated_drive.hpp"
#include "jounce/executor/detail/cycle.hpp"
#include "jounce/executor/detail/recorder.hpp"

#include "axis/tables.hpp"
#include "executor/cycle/virtual_pacer.hpp"
#include "executor/hooks.hpp"

namespace jounce::quiet_motions_test {
namespace {

using namespace test;

const AxisConfig config{.limits = limits(1000, 1e5, 1e7)};

/// A feeder, and a knife behind its setpoint. Between the cycles anything may happen; the cycles alone are
/// listened to. One in a hundred wakes up late, and all are recorded.
class Stage {
 public:
  std::function<void()> between;

  explicit Stage(AxisDrive* drive = nullptr, const AxisConfig& feeder = config,
                 std::function<void()> at_first = {})
      : between(std::move(at_first)),
        machine_({{.name = "feeder", .config = feeder},
                  {.name = "knife",
                   .config = config,
                   .follow = {.what = Follow::What::setpoint, .index = 0}}}),
        cycle_(machine_, pacer_, exchange_, {.drives = {drive, nullptr}, .record = buffer_.get()}) {
    order(0, {command::Enable{}}, 100);
    order(1, {command::Enable{}});
  }

  /// Sends a command to axis 0 or 1, runs the cycles, and returns its last tick.
  Tick order(std::size_t axis, Command command, int cycles = 1) {
    command.id = ++number_;
    EXPECT_TRUE(exchange_.axes[axis]->commands.push(command));
    return run(axis, cycles);
  }
  Tick run(std::size_t axis, int cycles) {
    for (int i = 0; i < cycles; ++i) {
      if (++cycles_ % 100 == 0) pacer_.delay = 2'500'000;
      if (between) between();
      const Noise before = jounce::test::noise();
      cycle_.once();
      const Noise now = jounce::test::noise() - before;
      noise_ = {noise_.heap + now.heap, noise_.locks + now.locks, noise_.writes + now.writes};
      take();
    }
    return last_[axis];
  }
  Tick start(std::size_t axis, Movement& movement, int cycles = 1) {
    const Tick armed = order(axis, {command::Arm{.movement = &movement}});
    EXPECT_FALSE(armed.refused) << name(armed.refused->cause);
    return order(axis, {command::Start{}}, cycles);
  }

  [[nodiscard]] const Noise& noise() const { return noise_; }

 private:
  void take() {
    for (std::size_t i = 0; i < last_.size(); ++i) {
      while (exchange_.axes[i]->ticks.pop(last_[i])) continue;
      for (Answer answer; exchange_.axes[i]->answers.pop(answer);)
        EXPECT_FALSE(answer.refused)
            << "axis " << i << ", command " << answer.id << ": " << name(answer.refused->cause);
    }
  }

  Machine machine_;
  VirtualPacer pacer_;
  MachineExchange exchange_{2};
  std::unique_ptr<RecordBuffer> buffer_ = std::make_unique<RecordBuffer>();
  Cycle cycle_;
  Noise noise_;
  std::array<Tick, 2> last_;
  std::uint64_t number_ = 0;
  int cycles_ = 0;
};

/// A wave over time, row by row.
SegmentRow wave(std::size_t i) {
  const auto at = [](double x) { return 5 - 5 * std::cos(10 * x); };
  const auto rate = [](double x) { return 50 * std::sin(10 * x); };
  const double x = 0.02 * static_cast<double>(i + 1);
  return {.x_end = x, .p_end = at(x), .v_start = rate(x - 0.02), .v_end = rate(x), .degree = 3};
}

TEST(Quiet, RowsThatArriveInFlightTheirEndAndWhatComesAfter) {
  FifoPath path(1, {.each = 8, .limits = row_limits(config)});
  Stage stage;
  std::size_t pushed = 0;
  stage.between = [&] {
    while (pushed < 200 && path.fifos().push(0, wave(pushed)) == RowRule::none) ++pushed;
  };
  stage.run(0, 1);
  EXPECT_EQ(stage.start(0, path, 3800).state, State::discrete_motion);
  Tick now = stage.run(0, 400);
  EXPECT_EQ(now.fault, Cause::underrun) << "nothing came after row 200";
  EXPECT_EQ(now.velocity, 0);
  stage.between = [&] {
    while (pushed < 300 && path.fifos().push(0, wave(pushed)) == RowRule::none) ++pushed;
  };
  stage.order(0, {command::Reset{}}, 10);
  now = stage.order(0, {command::Resume{}}, 1000);
  EXPECT_EQ(now.state, State::discrete_motion);
  EXPECT_EQ(stage.noise(), Noise{});
}

TEST(Quiet, TablesOfRowsBehindAMasterSwitchedInFlight) {
  FifoFollow follow(1, {.each = 8, .stream = false, .loops = 0});
  const SegmentRow there{.x_end = 5, .p_end = 1, .v_start = 0, .v_end = 0, .degree = 3};
  const SegmentRow back{.x_end = 10, .p_end = 0, .v_start = 0, .v_end = 0, .degree = 3};
  for (int bank : {0, 1})
    for (const SegmentRow& row : {there, back})
      ASSERT_EQ(follow.fifos().push(bank, row), RowRule::none);
  Stage stage;
  stage.order(0, {command::MoveVelocity{.velocity = 100}}, 50);
  EXPECT_EQ(stage.start(1, follow, 500).state, State::synchronized_motion);
  int switched = 0;
  stage.between = [&] { switched += switched == 0 && follow.fifos().queue_switch() ? 1 : 0; };
  EXPECT_EQ(stage.run(1, 500).state, State::synchronized_motion);
  EXPECT_EQ(switched, 1);
  EXPECT_EQ(follow.fifos().active(), 1);
  EXPECT_EQ(stage.noise(), Noise{});
}

TEST(Quiet, GearsThatAreGoneIntoInMotionAndLeft) {
  LiveGear gear(1, {.numerator = 1, .denominator = 2, .acceleration = 2e4, .jerk = 1e6});
  LiveGear other(2, {.numerator = -1, .denominator = 3, .acceleration = 2e4, .jerk = 1e6});
  LiveGearInPos in_pos(3, {.numerator = 1,
                           .denominator = 1,
                           .master_sync_position = 60,
                           .slave_sync_position = 20,
                           .master_start_distance = 40});
  Stage stage;
  stage.order(0, {command::MoveVelocity{.velocity = 200}}, 60);
  stage.order(1, {command::Couple{.movement = &gear}}, 100);
  EXPECT_EQ(gear.progress(), Progress::running);
  stage.order(1, {command::Couple{.movement = &other}}, 100);
  EXPECT_EQ(other.progress(), Progress::running);
  EXPECT_EQ(stage.order(1, {command::GearOut{}}, 50).state, State::continuous_motion);
  stage.order(1, {command::Halt{}}, 200);
  stage.order(0, {command::Halt{}}, 200);
  stage.order(0, {command::SetPosition{.position = 0}});
  stage.order(1, {command::SetPosition{.position = 0}});
  stage.start(1, in_pos);
  stage.order(0, {command::MoveAbsolute{.position = 100, .dynamics = {.velocity = 100}}}, 900);
  EXPECT_EQ(in_pos.progress(), Progress::running);
  EXPECT_EQ(stage.order(1, {command::GearOut{}}, 50).fault, Cause::none);
  EXPECT_EQ(stage.noise(), Noise{});
}

TEST(Quiet, ClutchesPhaseShiftsAndStrokes) {
  LiveClutch clutch(1, 0.5, 10);
  LiveClutch other(2, -1, 10);
  Stage stage;
  stage.order(0, {command::MoveVelocity{.velocity = 100}}, 60);
  stage.order(1, {command::Couple{.movement = &clutch}}, 200);
  EXPECT_EQ(clutch.progress(), Progress::running);
  stage.order(1, {command::PhasingRelative{3, {.velocity = 20, .acceleration = 500}}}, 50);
  stage.order(1, {command::PhasingAbsolute{-1, {.velocity = 20, .acceleration = 500}}}, 500);
  stage.order(1, {command::Couple{.movement = &other}}, 200);
  EXPECT_EQ(other.progress(), Progress::running);
  stage.order(0, {command::ChangeVelocity{.velocity = 50, .position = 120}}, 800);
  EXPECT_NEAR(stage.run(0, 1).velocity, 50, 1e-9);
  EXPECT_NEAR(stage.run(1, 1).velocity, -50, 1e-6);
  stage.order(0, {command::Halt{}}, 200);
  stage.order(1, {command::Halt{}}, 200);
  stage.order(1, {command::MoveRepetitive{.position = 3, .wait = 0.0123}}, 800);
  EXPECT_EQ(stage.order(1, {command::Finish{}}, 500).state, State::standstill);
  EXPECT_EQ(stage.noise(), Noise{});
}

TEST(Quiet, CamsBehindALiveMasterAndASwapOfThem) {
  const auto cam = [](double reach) {
    return table(Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap,
                 {{0, 10, 20}, {0, reach, 0}, {0, 0, 0}, {0, 0, 0}});
  };
  LiveCam first(1, cam(3),
                {.start = StartMode::ramp_in, .velocity_diff = 300, .acceleration = 3e4});
  LiveCam second(2, cam(-2), {.start = StartMode::relative});
  Stage stage;
  stage.order(0, {command::MoveVelocity{.velocity = 100}}, 60);
  EXPECT_EQ(stage.start(1, first, 600).state, State::synchronized_motion);
  EXPECT_EQ(first.progress(), Progress::running);
  stage.order(1, {command::CamOut{}}, 20);
  stage.order(1, {command::Halt{}}, 300);
  EXPECT_EQ(stage.start(1, second, 300).state, State::synchronized_motion);
  stage.order(0, {command::Abort{}}, 5);
  EXPECT_EQ(stage.run(1, 500).state, State::error_stop) << "a frozen master is lost";
  EXPECT_EQ(stage.noise(), Noise{});
}

TEST(Quiet, CutsOnDemandAndTheWayHome) {
  FlyingShear shear{.cut_length = 20, .line_speed = 100, .sync_time = 0.05};
  shear.limits = limits(1000, 1e4);
  RotaryKnifeSpec knife{.diameter = 10, .cut_length = 20, .sync_angle = 0.5};
  knife.dwell = true;
  for (const CutMachine& machine : {CutMachine(shear), CutMachine(knife)}) {
    const auto task = std::make_shared<const CutTask>(CutJob{
        {machine, {.lengths = {20, 90}}}, {.speed = 100, .rates = {}, .slave = limits(1000, 1e4)}});
    LiveCuts cuts(1, task, config);
    Stage stage;
    stage.order(1, {command::SetPosition{.position = task->cutter.home()}});
    stage.order(0, {command::MoveVelocity{.velocity = 100}}, 60);
    stage.order(1, {command::Couple{.movement = &cuts}}, 800);
    stage.order(1, {command::Cut{.length = 25}}, 800);
    stage.order(1, {command::Cut{.waste = 80}}, 500);
    stage.order(1, {command::Cut{}}, 600);
    EXPECT_GE(cuts.plan().cuts(), 5);
    EXPECT_EQ(stage.order(1, {command::Park{}}, 900).state, State::standstill);
    EXPECT_EQ(stage.noise(), Noise{});
  }
}

TEST(Quiet, MovesThatArePlannedAnewAgainAndAgain) {
  Stage stage;
  const MoveDynamics slow{.velocity = 100, .acceleration = 1000, .deceleration = 2000, .jerk = 1e5};
  stage.order(0, {command::MoveAbsolute{.position = 50, .dynamics = slow}}, 150);
  stage.order(0, {command::MoveAbsolute{.position = -20, .dynamics = slow}}, 70);
  stage.order(0, {command::Override{.factor = 0.3}}, 70);
  stage.order(0, {command::MoveAdditive{.distance = 7, .dynamics = slow}}, 30);
  stage.order(0, {command::MoveSuperimposed{.distance = 3, .dynamics = {.velocity = 20}}}, 50);
  stage.order(0, {command::Hold{}}, 100);
  stage.order(0, {command::Resume{}}, 100);
  stage.order(0, {command::Override{.factor = 2}}, 50);
  stage.order(0, any({.kind = Kind::move_velocity, .position = -100, .dynamics = slow}), 120);
  stage.order(0, {command::MoveRelative{.distance = 30}}, 20);
  EXPECT_EQ(stage.order(0, {command::Stop{}}, 200).state, State::standstill);
  stage.order(0, {command::Home{.offset = 4}}, 10);
  stage.order(0, {command::MoveRelative{.distance = 30}}, 20);
  EXPECT_EQ(stage.order(0, {command::Disable{}}, 20).state, State::disabled);
  EXPECT_EQ(stage.noise(), Noise{});
}

TEST(Quiet, TablesThatTakeOverFromEachOtherInMotion) {
  const auto round = [](std::uint64_t id) {
    return std::make_unique<Job>(id, there_and_back(0, 5, 0.4, Extrapolation::wrap));
  };
  const auto a = round(1), b = round(2);
  Stage stage;
  stage.start(0, *a, 100);
  Job* waiting = b.get();
  Job* playing = a.get();
  for (int swap = 0; swap < 6; ++swap) {
    stage.order(0, {command::Arm{.movement = waiting}});
    const Tick now = stage.order(0, {command::Start{.when = StartAt::end_of_table}}, 450);
    EXPECT_EQ(now.job, waiting->id());
    EXPECT_EQ(now.state, State::discrete_motion);
    std::swap(waiting, playing);
  }
  stage.order(0, {command::Finish{}}, 900);
  EXPECT_EQ(stage.run(0, 1).state, State::standstill);
  EXPECT_EQ(stage.noise(), Noise{});
}

/// Back and forth until the drive cannot follow; then a reset, and again.
void drive_hard(Stage& stage) {
  stage.order(0, {command::MoveRelative{.distance = 10, .dynamics = {.velocity = 100}}}, 400);
  stage.order(0, {command::MoveVelocity{.velocity = 1000}}, 600);
  stage.order(0, {command::Reset{}}, 100);
  stage.order(0, {command::Enable{}}, 100);
  stage.order(0, {command::MoveRelative{.distance = -5, .dynamics = {.velocity = 50}}}, 400);
}

TEST(Quiet, ASimulatedDriveThatIsAskedForTooMuch) {
  Drive servo = servo_400w();
  servo.position_per_rev = 10;
  SimulatedDrive drive(servo, 1e-3);
  AxisConfig watched = config;
  watched.following_error = 2;
  watched.following_time = 0.002;
  Stage stage(&drive, watched);
  int behind = 0;
  stage.between = [&] { behind += drive.now().following_error != 0 ? 1 : 0; };
  drive_hard(stage);
  EXPECT_GT(behind, 100) << "it was no drive";
  EXPECT_EQ(stage.noise(), Noise{});
}

/// The process behind shared memory: a drive that follows exactly.
class OtherSide {
 public:
  explicit OtherSide(const std::string& name) : memory_(name, SharedMemory::Side::drive) {}
  void cycle() {
    if (const auto told = memory_->outputs.read(); told && told->cycle > 0) follow(told->data);
    const bool operates = state_ == Cia402State::operation_enabled;
    memory_->inputs.write({++cycles_,
                           {.statusword = statusword({.state = state_, .follows = operates}),
                            .mode = 8,
                            .position_actual = position_}});
  }
  [[nodiscard]] std::int32_t position() const { return position_; }

 private:
  void follow(const Cia402Outputs& told) {
    state_ = next(state_, told.controlword, before_, {.initialised = true, .stopped = true});
    before_ = told.controlword;
    if (state_ == Cia402State::operation_enabled) position_ = told.target_position;
  }

  SharedMemory memory_;
  Cia402State state_ = Cia402State::not_ready_to_switch_on;
  std::uint16_t before_ = 0;
  std::int32_t position_ = 0;
  std::uint64_t cycles_ = 0;
};

TEST(Quiet, ADriveBehindSharedMemoryThatAlsoFallsSilent) {
  const std::string name = "quiet-" + std::to_string(getpid());
  SharedDrive drive(name, {.increments_per_rev = 1000, .position_per_rev = 10}, 5);
  OtherSide other(name);
  Stage stage(&drive, config, [&] { other.cycle(); });
  drive_hard(stage);
  EXPECT_GT(other.position(), 1000) << "it was no drive";
  stage.between = {};
  EXPECT_EQ(stage.run(0, 50).fault, Cause::drive_fault);
  EXPECT_EQ(stage.noise(), Noise{});
}

}  // namespace
}  // namespace jounce::quiet_motions_test
