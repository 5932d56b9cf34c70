// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include "jounce/base/file.hpp"

// The program itself: threads, kills and mpirun give the same bytes.

namespace jounce::sweep_verb_test {
namespace {

using ::testing::HasSubstr;
using namespace std::chrono_literals;

struct Ran {
  int status = 0;
  std::string output;  ///< both streams
};

class SweepVerb : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::path(::testing::TempDir()) / ("sweep_verb_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
    write_file(path("move.toml"), R"(jounce = 1
kind = "move"
units = { position = "mm" }
[move]
profile = "s_curve"
to = 30
velocity = 10
acceleration = 20
jerk = 400
[limits]
velocity = 11
[drive]
model = "servo_400w"
position_per_rev = 10
)");
    sweep(20, 3);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  void sweep(int samples, int seed) const {
    write_file(path("sweep.toml"), R"(jounce = 1
kind = "sweep"
spec = "move.toml"
minimize = ["duration", "peak torque"]
[[parameter]]
key = "move.velocity"
tolerance = "20 %"
[[parameter]]
key = "move.jerk"
values = [300, 400]
[monte_carlo]
samples = )" + std::to_string(samples) +
                                       "\nseed = " + std::to_string(seed) + "\n");
  }

  Ran run(const std::string& words) const {
    const std::string command = "cd " + folder_.string() + " && " + words + " 2>&1";
    Ran ran;
    std::FILE* pipe = popen(command.c_str(), "r");
    char buffer[4096];
    while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, pipe))
      ran.output.append(buffer, n);
    const int status = pclose(pipe);
    ran.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return ran;
  }
  Ran jounce(const std::string& words) const { return run(JOUNCE_EXE " " + words); }

  /// Starts it, ends it by a signal once its journal has more than `lines` lines; its status as waitpid() has it.
  int killed(const std::vector<std::string>& words, std::size_t lines, int signal = SIGKILL) const {
    const pid_t child = fork();
    if (child == 0) {
      if (chdir(folder_.c_str()) != 0 || setpgid(0, 0) != 0) _exit(127);
      std::vector<char*> arguments;
      for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
      arguments.push_back(nullptr);
      if (std::freopen("/dev/null", "w", stdout) == nullptr) _exit(127);
      execvp(arguments[0], arguments.data());
      _exit(127);
    }
    for (int i = 0; i < 20'000 && journal_lines() <= lines; ++i) {
      int status = 0;
      if (waitpid(child, &status, WNOHANG) == child) return status;  // it was faster
      std::this_thread::sleep_for(1ms);
    }
    int status = 0;
    kill(-child, signal);
    waitpid(child, &status, 0);
    return status;
  }

  std::size_t journal_lines() const {
    const std::string file = path("a.csv.journal");
    if (!std::filesystem::exists(file)) return 0;
    const std::string text = read_file(file);
    const auto ends = std::count(text.begin(), text.end(), '\n');
    return ends > 0 ? static_cast<std::size_t>(ends - 1) : 0;
  }

  std::string bytes(const std::string& name) const { return read_file(path(name)); }

 private:
  std::filesystem::path folder_;
};

TEST_F(SweepVerb, GivesTheSameBytesOnAnyNumberOfThreads) {
  const Ran one = jounce("sweep sweep.toml -o one.csv --npy one.npy --jobs 1");
  EXPECT_EQ(one.status, 0) << one.output;
  const Ran two = jounce("sweep sweep.toml -o two.csv --npy two.npy --jobs 2 --plot two.svg");
  EXPECT_EQ(two.output, one.output);
  EXPECT_EQ(bytes("one.csv"), bytes("two.csv"));
  EXPECT_EQ(bytes("one.npy"), bytes("two.npy"));
  EXPECT_FALSE(std::filesystem::exists(path("two.csv.journal")));
  EXPECT_THAT(bytes("two.svg"), HasSubstr("peak torque [N m]"));
  EXPECT_THAT(one.output, HasSubstr("40 cases, 2 combinations of 20 samples"));
}

TEST_F(SweepVerb, PictureCountsTheFiguresThatItDoesNotShow) {
  const std::string grid =
      "jounce = 1\nkind = \"sweep\"\nspec = \"move.toml\"\n%"
      "[[parameter]]\nkey = \"move.velocity\"\nvalues = [5, 7, 9]\n";
  const auto picture = [&](const std::string& figures) {
    std::string text = grid;
    write_file(path("grid.toml"), text.replace(text.find('%'), 1, figures));
    EXPECT_EQ(jounce("sweep grid.toml -o grid.csv --plot grid.svg").status, 0);
    return bytes("grid.svg");
  };
  EXPECT_THAT(picture(""), HasSubstr(" more figures vary: choose with `figures = [...]`"));
  EXPECT_THAT(picture("figures = [\"duration\", \"peak velocity\"]\n"),
              testing::Not(HasSubstr("more figure")));
}

TEST_F(SweepVerb, ContinuesAfterKillsAndRepeatsNothing) {
  sweep(300, 3);  // so many that it is killed long before its end
  ASSERT_EQ(jounce("sweep sweep.toml -o whole.csv").status, 0);
  std::size_t seen = 0;
  for (const std::size_t lines : {8U, 25U, 60U}) {
    killed({JOUNCE_EXE, "sweep", "sweep.toml", "-o", "a.csv", "--jobs", "2"}, lines);
    ASSERT_FALSE(std::filesystem::exists(path("a.csv"))) << "done before it could be killed";
    EXPECT_GE(journal_lines(), seen);
    seen = journal_lines();
    EXPECT_GT(seen, lines);
  }
  const Ran last = jounce("sweep sweep.toml -o a.csv --json");
  ASSERT_EQ(last.status, 0) << last.output;
  const auto summary = nlohmann::json::parse(last.output);
  EXPECT_EQ(summary["resumed"], seen);
  EXPECT_EQ(summary["evaluated"], 600 - seen);
  EXPECT_EQ(bytes("a.csv"), bytes("whole.csv"));
  EXPECT_FALSE(std::filesystem::exists(path("a.csv.journal")));
}

TEST_F(SweepVerb, KeepsWhatItHasAtSigtermAndAtSigint) {
  sweep(300, 3);
  ASSERT_EQ(jounce("sweep sweep.toml -o whole.csv").status, 0);
  std::size_t seen = 0;
  for (const int signal : {SIGTERM, SIGINT}) {
    const int status =
        killed({JOUNCE_EXE, "sweep", "sweep.toml", "-o", "a.csv", "--jobs", "1"}, seen + 8, signal);
    ASSERT_FALSE(std::filesystem::exists(path("a.csv"))) << "done before it could be stopped";
    EXPECT_TRUE(WIFEXITED(status)) << "ended by the signal";
    EXPECT_EQ(WEXITSTATUS(status), 1);
    EXPECT_GT(journal_lines(), seen + 8);
    seen = journal_lines();
  }
  EXPECT_EQ(jounce("sweep sweep.toml -o a.csv").status, 0);
  EXPECT_EQ(bytes("a.csv"), bytes("whole.csv"));
}

TEST_F(SweepVerb, RejectsTheJournalOfAnotherSweep) {
  sweep(2000, 3);
  killed({JOUNCE_EXE, "sweep", "sweep.toml", "-o", "a.csv"}, 5);
  sweep(2000, 4);
  const Ran other = jounce("sweep sweep.toml -o a.csv");
  EXPECT_EQ(other.status, 2);
  EXPECT_EQ(other.output,
            "jounce: a.csv.journal: belongs to another sweep, spec or version of Jounce: delete it "
            "to start again\n");
}

TEST_F(SweepVerb, ReportsErrors) {
  EXPECT_THAT(jounce("sweep none.toml").output, HasSubstr("none.toml: cannot be read"));
  EXPECT_EQ(jounce("sweep none.toml").status, 2);
  EXPECT_EQ(jounce("sweep move.toml").status, 2);
  EXPECT_EQ(jounce("sweep sweep.toml --jobs 0").status, 2);
  EXPECT_EQ(jounce("sweep sweep.toml -o no/such/folder.csv").status, 2);
  EXPECT_EQ(jounce("sweep sweep.toml -o sweep.toml").status, 2);
}

#ifdef JOUNCE_MPIRUN

/// On this machine alone: shared memory and loopback, with or without a network.
constexpr const char* mpirun =
    "timeout 60 " JOUNCE_MPIRUN
    " --allow-run-as-root --oversubscribe --mca btl self,vader --mca plm isolated"
    " --mca oob_tcp_if_include lo --mca pml ob1 -n ";

TEST_F(SweepVerb, GivesTheSameBytesUnderMpi) {
  ASSERT_EQ(jounce("sweep sweep.toml -o one.csv --jobs 1").status, 0);
  for (const char* processes : {"1", "2", "4"}) {
    const Ran ran = run(mpirun + std::string(processes) + " " JOUNCE_EXE " sweep sweep.toml -o " +
                        processes + ".csv --json");
    EXPECT_EQ(ran.status, 0) << ran.output;
    EXPECT_THAT(ran.output, HasSubstr("\"evaluated\": 40"));
    EXPECT_EQ(bytes("one.csv"), bytes(std::string(processes) + ".csv"));
  }
}

TEST_F(SweepVerb, ContinuesUnderMpiAfterKilledThreads) {
  sweep(300, 3);
  ASSERT_EQ(jounce("sweep sweep.toml -o whole.csv").status, 0);
  killed({JOUNCE_EXE, "sweep", "sweep.toml", "-o", "a.csv", "--jobs", "2"}, 15);
  ASSERT_FALSE(std::filesystem::exists(path("a.csv"))) << "done before it could be killed";
  const std::size_t seen = journal_lines();
  const Ran ran = run(mpirun + std::string("3 " JOUNCE_EXE " sweep sweep.toml -o a.csv --json"));
  EXPECT_EQ(ran.status, 0) << ran.output;
  EXPECT_THAT(ran.output, HasSubstr("\"resumed\": " + std::to_string(seen)));
  EXPECT_EQ(bytes("a.csv"), bytes("whole.csv"));
}

TEST_F(SweepVerb, ReportsErrorsOnceUnderMpi) {
  const Ran ran = run(mpirun + std::string("3 " JOUNCE_EXE " sweep none.toml"));
  EXPECT_NE(ran.status, 0);
  const std::string what = "jounce: none.toml: cannot be read";
  const std::size_t first = ran.output.find(what);
  ASSERT_NE(first, std::string::npos) << ran.output;
  EXPECT_EQ(ran.output.find("none.toml: cannot be read", first + what.size()), std::string::npos);
}

#endif

}  // namespace
}  // namespace jounce::sweep_verb_test
