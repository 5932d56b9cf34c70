// SPDX-License-Identifier: Apache-2.0
#include "jounce/drive/shared_drive.hpp"

#include <array>
#include <atomic>
#include <cmath>
#include <csignal>
#include <string>
#include <system_error>
#include <thread>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "jounce/profiles/error.hpp"

namespace jounce::shared_drive_test {
namespace {

const Cia402Config thousand{.increments_per_rev = 1000, .position_per_rev = 10};

/// One name a process and test: tests run side by side.
std::string unique(const char* name) {
  return std::string(name) + "-" + std::to_string(getpid());
}

TEST(Seqlock, NeverTearsAValue) {
  struct Value {
    std::array<std::uint64_t, 9> same{};
  };
  Seqlock<Value> lock;
  EXPECT_EQ(lock.read()->same[8], 0U);
  std::atomic<bool> quit{false};
  std::thread writer([&] {
    for (std::uint64_t k = 1; !quit; ++k) {
      Value value;
      value.same.fill(k);
      lock.write(value);
    }
  });
  std::uint64_t last = 0;
  for (int i = 0; i < 200'000; ++i) {
    const auto now = lock.read();
    if (!now) continue;
    for (const std::uint64_t word : now->same) ASSERT_EQ(word, now->same[0]);
    ASSERT_GE(now->same[0], last);
    last = now->same[0];
  }
  quit = true;
  writer.join();
}

TEST(SharedDrive, IsNotReadyUntilTheOtherSideIsThereAndFailsWhenItFallsSilent) {
  const std::string name = unique("silent");
  SharedDrive drive(name, thousand, 5);
  for (int i = 0; i < 20; ++i) {
    EXPECT_FALSE(drive.feedback().ready);
    EXPECT_FALSE(drive.feedback().fault) << "there is no drive program yet";
  }
  const SharedMemory other(name, SharedMemory::Side::drive);
  const Cia402Inputs operating{
      .statusword = statusword({.state = Cia402State::operation_enabled, .follows = true}),
      .mode = 8,
      .position_actual = 4200,
      .velocity_actual = -50,
      .torque_actual = 125};
  other->inputs.write({1, operating});
  const Feedback said = drive.feedback();
  EXPECT_TRUE(said.ready);
  EXPECT_EQ(said.position, 42);
  EXPECT_EQ(said.velocity, -0.5);
  EXPECT_EQ(said.torque, 0.125);
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(drive.feedback().fault);
  EXPECT_TRUE(drive.feedback().fault);
  EXPECT_FALSE(drive.feedback().ready);
  other->inputs.write({2, operating});
  EXPECT_TRUE(drive.feedback().ready) << "it is back";

  drive.command({.position = 42.5, .enable = true});
  const auto told = other->outputs.read();
  ASSERT_TRUE(told);
  EXPECT_EQ(told->cycle, 1U);
  EXPECT_EQ(told->data.target_position, 4250);
  EXPECT_EQ(told->data.controlword, 0x0f);
  EXPECT_EQ(told->data.mode, 8);
}

TEST(SharedDrive, ANameIsTakenOnceAndFreeAgainAfterwards) {
  const std::string name = unique("once");
  {
    const SharedDrive drive(name, thousand);
    EXPECT_THROW(SharedDrive(name, thousand), InputError);
  }
  EXPECT_THROW(SharedMemory(name, SharedMemory::Side::drive), std::system_error);
  const SharedDrive again(name, thousand);
  EXPECT_THROW(SharedDrive("a/b", thousand), InputError);
  EXPECT_THROW(SharedDrive("", thousand), InputError);
  EXPECT_THROW(SharedDrive(unique("x"), thousand, 0), InputError);
}

TEST(SharedDrive, WhatAKilledExecutorLeftBehindIsTakenOver) {
  const std::string name = unique("killed");
  const pid_t child = fork();
  if (child == 0) {
    SharedDrive drive(name, thousand);
    drive.command({.position = 1, .enable = true});
    raise(SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  const SharedMemory other(name, SharedMemory::Side::drive);
  EXPECT_EQ(other->outputs.read()->cycle, 1U) << "it is still there";
  const SharedDrive drive(name, thousand);
  EXPECT_EQ(other->outputs.read()->cycle, 0U) << "and begins anew";
}

/// The process of examples/drive-shm, ended by its destructor.
class DriveProcess {
 public:
  explicit DriveProcess(const std::string& name) : pid_(fork()) {
    if (pid_ != 0) return;
    execl(JOUNCE_DRIVE_SHM, "drive-shm", name.c_str(), "60", nullptr);
    _exit(127);
  }
  ~DriveProcess() {
    if (pid_ <= 0) return;
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  DriveProcess(const DriveProcess&) = delete;
  DriveProcess& operator=(const DriveProcess&) = delete;

  int wait() {
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t pid_;
};

TEST(SharedDrive, DrivesAnotherProcess) {
  const std::string name = unique("other");
  auto drive = std::make_unique<SharedDrive>(name, thousand, 5000);
  DriveProcess process(name);
  // Waits for what the other process does, with patience for a machine that is busy.
  double target = 10;  // initial position
  const auto until = [&](bool enable, auto done) {
    for (int i = 0; i < 30'000; ++i) {
      const Feedback said = drive->feedback();
      if (done(said)) return true;
      drive->command({.position = target, .enable = enable});
      usleep(1000);
    }
    return false;
  };
  ASSERT_TRUE(until(true, [](const Feedback& f) { return f.ready; }));
  EXPECT_EQ(drive->feedback().position, 10) << "nothing moved on the way up";
  for (int k = 1; k <= 100; ++k) {
    target = 10 + 0.5 * k;
    drive->command({.position = target, .enable = true});
    usleep(1000);
    (void)drive->feedback();
  }
  ASSERT_TRUE(until(true, [](const Feedback& f) { return f.position == 60; }));
  ASSERT_TRUE(until(false, [](const Feedback& f) { return !f.ready && !f.fault; }));
  drive.reset();  // the executor goes, and so does the process
  EXPECT_EQ(process.wait(), 0);
}

}  // namespace
}  // namespace jounce::shared_drive_test
