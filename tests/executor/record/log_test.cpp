// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/detail/log.hpp"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "support/temporary_folder.hpp"

namespace jounce::log_test {
namespace {

namespace fs = std::filesystem;

class TickLogTest : public test::WithFolder {
 protected:
  const fs::path& folder = folder_;
};

TEST_F(TickLogTest, WritesShortestDoublesAndAppearsWhenClosed) {
  const fs::path path = folder / "run.csv";
  TickLog log(path, {.x = "deg", .position = "mm"});
  log.add({.tick = 0, .time = 0, .state = State::standstill});
  log.add({.tick = 12,
           .time = 0.012,
           .state = State::synchronized_motion,
           .master = 0.1 + 0.2,
           .master_velocity = 1e-9,
           .position = -1.0 / 3,
           .velocity = 1e300,
           .acceleration = -0.0,
           .job = 18446744073709551615U,
           .held = true,
           .homed = true,
           .switches = {.outputs = 0x80000001U,
                        .count = 2,
                        .edge = {{{0.00025, 32, true}, {0.00075, 3, false}}}}});
  log.add({.tick = 13, .time = 0.013, .state = State::error_stop, .fault = Cause::aborted});
  EXPECT_FALSE(fs::exists(path));
  log.close();
  EXPECT_EQ(files(), 1U);

  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(),
            "tick,time [s],state,master [deg],master_velocity [deg/s],position [mm],"
            "velocity [mm/s],acceleration [mm/s^2],job,fault,outputs,edges [s],held,homed\n"
            "0,0,standstill,0,0,0,0,0,0,none,0,,0,0\n"
            "12,0.012,synchronized_motion,0.30000000000000004,1e-09,-0.3333333333333333,"
            "1e+300,-0,18446744073709551615,none,2147483649,+32@0.00025 -3@0.00075,1,1\n"
            "13,0.013,error_stop,0,0,0,0,0,0,aborted,0,,0,0\n");
}

TEST_F(TickLogTest, HasNoUnitOfAnUnknownMasterAndNoColumnsForAGroup) {
  {
    TickLog log(folder / "run.csv", {.x = "", .position = "mm"});
    log.close();
    std::ifstream file(folder / "run.csv");
    std::string head;
    std::getline(file, head);
    EXPECT_TRUE(head.starts_with("tick,time [s],state,master,master_velocity,position [mm],"))
        << head;
  }
  TickLog log(folder / "run.csv", {.x = "", .position = "mm"}, {.master = false});
  log.add({.tick = 7, .time = 0.007, .position = 2.5});
  log.close();
  std::ifstream file(folder / "run.csv");
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(),
            "tick,time [s],state,position [mm],velocity [mm/s],acceleration [mm/s^2],job,fault,"
            "outputs,edges [s],held,homed\n"
            "7,0.007,disabled,2.5,0,0,0,none,0,,0,0\n");
}

TEST_F(TickLogTest, LeavesNothingBehindIfItIsNeverClosed) {
  { TickLog(folder / "run.csv", {.x = "deg", .position = "mm"}).add({}); }
  EXPECT_EQ(files(), 0U);
}

TEST_F(TickLogTest, ReportsWhereItCannotWrite) {
  try {
    TickLog log(folder / "absent" / "run.csv", {});
    FAIL() << "opened a file in a folder that does not exist";
  } catch (const std::system_error& error) {
    EXPECT_NE(std::string(error.what()).find("absent"), std::string::npos) << error.what();
    EXPECT_EQ(error.code(), std::errc::no_such_file_or_directory);
  }
}

/// Simulates a full disk: no file of this process grows beyond `bytes`.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit full{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &full);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST_F(TickLogTest, ADiskThatIsFullAtTheStartIsFoundThere) {
  const FullDisk disk(100);
  EXPECT_THROW(TickLog(folder / "run.csv", {.x = "deg", .position = "mm"}), std::system_error);
  EXPECT_EQ(files(), 0U);
}

TEST_F(TickLogTest, OnAFullDiskKeepsWholeLinesAndReportsIt) {
  for (const rlim_t bytes : {rlim_t{5'000}, rlim_t{20'000}, rlim_t{20'001}}) {
    const fs::path path = folder / ("run" + std::to_string(bytes) + ".csv");
    {
      const FullDisk disk(bytes);
      TickLog log(path, {.x = "deg", .position = "mm"});
      for (int i = 0; i < 2000; ++i) log.add({.tick = i, .time = i * 0.001});
      log.close();
      EXPECT_FALSE(log.truncated().empty());
    }
    EXPECT_FALSE(fs::exists(path));
    std::ifstream file(path.string() + ".truncated");
    std::int64_t lines = -1;  // lines of ticks: the first line is the head
    std::string last;
    for (std::string line; std::getline(file, line); ++lines) last = line;
    EXPECT_GT(lines, 30);
    const std::string tick = std::to_string(lines - 1);
    EXPECT_EQ(last.substr(0, tick.size() + 1), tick + ",");
    EXPECT_EQ(std::count(last.begin(), last.end(), ','), 13);
  }
}

}  // namespace
}  // namespace jounce::log_test
