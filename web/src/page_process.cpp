// SPDX-License-Identifier: Apache-2.0
#include "jounce/web/page_process.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <deque>
#include <fstream>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "jounce/web/gate.hpp"
#include "jounce/web/server.hpp"

extern char** environ;

namespace jounce::web {
namespace {

using namespace std::chrono_literals;

constexpr int page_socket = 3;          // descriptor of the listening socket in the child
constexpr int page_trace = 4;           // descriptor of the trace in the child, if there is one
constexpr int above_both = 10;          // descriptors that do not collide with these
constexpr std::size_t most_starts = 5;  // in `memory`
constexpr Nanos memory = 60s;
constexpr Nanos pause = 1s;     // before it is started again
constexpr Nanos look = 100ms;   // between two checks of its presence
constexpr Nanos patience = 1s;  // wait for a page that shall end

[[noreturn]] void fail(int error, const char* what) {
  throw std::system_error(error, std::generic_category(), what);
}

/// Starts the child with these three descriptors and the socket, and with no signal blocked or
/// ignored. The child is in a new process group, which Ctrl-C does not reach: Ctrl-C is for the
/// executor, which still has axes to stop.
class Spawn {
 public:
  Spawn(int input, int socket, int trace) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, input,
                                     STDIN_FILENO);  // first: it may be page_socket
    posix_spawn_file_actions_adddup2(&actions_, socket, page_socket);
    if (trace >= 0) posix_spawn_file_actions_adddup2(&actions_, trace, page_trace);
    posix_spawn_file_actions_addclosefrom_np(&actions_,
                                             trace >= 0 ? page_trace + 1 : page_socket + 1);
    posix_spawnattr_init(&attributes_);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setsigdefault(&attributes_, &all);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(
        &attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  }
  ~Spawn() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  Spawn(const Spawn&) = delete;
  Spawn& operator=(const Spawn&) = delete;

  pid_t start(std::vector<std::string> words) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_t child = 0;
    const int error =
        posix_spawn(&child, "/proc/self/exe", &actions_, &attributes_, arguments.data(), environ);
    if (error != 0) fail(error, "cannot start the process of the live page");
    return child;
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

/// A started page: it ends where the pipe to it is closed.
class Child {
 public:
  Child(const std::vector<std::string>& words, int socket, int trace, const std::string& token) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) fail(errno, "a pipe to the live page");
    input_ = ends[1];
    const std::string line = token + "\n";  // fits the pipe, which has a reader: this one
    if (write(input_, line.data(), line.size()) < 0) fail(errno, "a pipe to the live page");
    try {
      child_ = Spawn(ends[0], socket, trace).start(words);
    } catch (...) {
      close(ends[0]);
      close(input_);
      throw;
    }
    close(ends[0]);
  }
  ~Child() {
    close(input_);
    for (Nanos waited{}; !has_ended() && waited < patience; waited += look)
      std::this_thread::sleep_for(look);
    if (has_ended()) return;
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  bool has_ended() {
    if (!ended_) ended_ = waitpid(child_, nullptr, WNOHANG) != 0;
    return ended_;
  }

 private:
  int input_ = -1;
  pid_t child_ = 0;
  bool ended_ = false;
};

/// Makes the page less important than the executor: it has a lower priority, ends
/// with the executor, and is the first process to be killed if memory is short.
void give_way() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  setpriority(PRIO_PROCESS, 0, 10);
  std::ofstream("/proc/self/oom_score_adj") << 1000;
}

/// A line from standard input.
std::string line_in() {
  std::string line;
  for (char c = 0; line.size() < 256 && read(STDIN_FILENO, &c, 1) == 1 && c != '\n';) line += c;
  return line;
}

/// Waits until the other end of standard input is closed: the executor has ended.
void wait_for_end_of_input() {
  std::array<char, 256> dropped{};
  while (read(STDIN_FILENO, dropped.data(), dropped.size()) > 0) {
  }
}

}  // namespace

struct PageProcess::Impl {
  Impl(std::uint16_t port, std::vector<std::string> arguments, const Trace* to_read,
       std::function<void(const std::string& notice)> say)
      : listening(port), words(std::move(arguments)), notify(std::move(say)) {
    if (to_read != nullptr) trace = above(to_read->reading_descriptor());
    auto first = child_now();
    starts.push_back(steady_now());
    keeper = std::thread([this, child = std::move(first)]() mutable { keep(std::move(child)); });
  }
  ~Impl() {
    {
      const std::scoped_lock lock(mutex);
      ending = true;
    }
    end.notify_all();
    keeper.join();
    if (trace >= 0) close(trace);
  }

  /// Moves a descriptor to a number that is free in the child.
  static int above(int descriptor) {
    const int moved = fcntl(descriptor, F_DUPFD_CLOEXEC, above_both);
    close(descriptor);
    if (moved < 0) fail(errno, "the trace of the live page");
    return moved;
  }
  std::unique_ptr<Child> child_now() {
    return std::make_unique<Child>(words, listening.descriptor(), trace, token);
  }

  /// Waits so long, or until the end; whether it has come.
  bool ends_within(Nanos time) {
    std::unique_lock lock(mutex);
    return end.wait_for(lock, time, [this] { return ending; });
  }

  void keep(std::unique_ptr<Child> child) {
    while (!ends_within(look)) {
      if (!child->has_ended()) continue;
      if (!may_start_again())
        return notify("the live page has ended " + std::to_string(most_starts) +
                      " times within a minute and is not started again; the axes continue. Serve "
                      "another one with `jounce page`");
      notify("the live page has ended and is started again; the axes continue");
      if (ends_within(pause)) return;
      try {
        child = child_now();
      } catch (const std::system_error& error) {
        return notify(std::string("the live page is not started again: ") + error.what() +
                      "; the axes continue");
      }
    }
  }

  bool may_start_again() {
    const Nanos now = steady_now();
    while (!starts.empty() && now - starts.front() > memory) starts.pop_front();
    if (starts.size() >= most_starts) return false;
    starts.push_back(now);
    return true;
  }

  const Listening listening;
  const std::vector<std::string> words;
  const std::function<void(const std::string& notice)> notify;
  const std::string token = new_token();
  int trace = -1;  // descriptor for the children; -1: none
  std::deque<Nanos> starts;
  std::mutex mutex;
  std::condition_variable end;
  bool ending = false;
  std::thread keeper;
};

PageProcess::PageProcess(std::uint16_t port, std::vector<std::string> words, const Trace* trace,
                         std::function<void(const std::string& notice)> notify)
    : impl_(std::make_unique<Impl>(port, std::move(words), trace, std::move(notify))) {}
PageProcess::~PageProcess() = default;

std::string PageProcess::address() const {
  return "http://127.0.0.1:" + std::to_string(impl_->listening.port()) + "/#" + impl_->token;
}

bool serve_for_parent(PanelOptions options, MakeLink make_link) {
  give_way();
  options.token = line_in();
  if (options.token.empty()) return false;
  if (auto trace = Trace::opened(page_trace); trace && trace->axes() == options.axes.size())
    options.trace = std::make_shared<const Trace>(*std::move(trace));
  const Panel panel(options, Listening::inherited(page_socket), std::move(make_link));
  wait_for_end_of_input();
  return true;
}

}  // namespace jounce::web
