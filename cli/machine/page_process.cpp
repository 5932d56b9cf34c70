// SPDX-License-Identifier: Apache-2.0
#include "cli/machine/page_process.hpp"

#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <deque>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "jounce/web/gate.hpp"
#include "jounce/web/server.hpp"

#include "cli/common/say.hpp"

extern char** environ;

namespace jounce::cli {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t most_starts = 5;  // in `memory`
constexpr Nanos memory = 60s;
constexpr Nanos pause = 1s;     // before it is started again
constexpr Nanos look = 100ms;   // between two checks of its presence
constexpr Nanos patience = 1s;  // wait for a page that shall end

[[noreturn]] void fail(int error, const char* what) {
  throw std::system_error(error, std::generic_category(), what);
}

/// Starts the child with these three descriptors and the socket, in a group of its own (Ctrl-C is for the
/// executor, which still has axes to stop), and with no signal blocked or ignored.
class Spawn {
 public:
  Spawn(int input, int socket) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, input,
                                     STDIN_FILENO);  // first: it may be page_socket
    posix_spawn_file_actions_adddup2(&actions_, socket, page_socket);
    posix_spawn_file_actions_addclosefrom_np(&actions_, page_socket + 1);
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
  Child(const std::vector<std::string>& words, int socket, const std::string& token) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) fail(errno, "a pipe to the live page");
    input_ = ends[1];
    const std::string line = token + "\n";  // fits the pipe, which has a reader: this one
    if (write(input_, line.data(), line.size()) < 0) fail(errno, "a pipe to the live page");
    try {
      child_ = Spawn(ends[0], socket).start(words);
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

std::vector<std::string> words_of(const std::vector<std::string>& axes, const LinkOptions& link) {
  std::vector<std::string> words{"jounce", "page", "--of-run", "--url", link.url};
  if (!link.key.empty()) words.insert(words.end(), {"--key", link.key});
  words.insert(words.end(), axes.begin(), axes.end());
  return words;
}

}  // namespace

struct PageProcess::Impl {
  Impl(std::uint16_t port, const std::vector<std::string>& axes, const LinkOptions& link)
      : listening(port), words(words_of(axes, link)) {
    auto first = std::make_unique<Child>(words, listening.descriptor(), token);
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
        return say(
            fmt::format("jounce: the live page has ended {} times within a minute and is not "
                        "started again; the axes continue. Serve another one with `jounce page`",
                        most_starts));
      say("jounce: the live page has ended and is started again; the axes continue");
      if (ends_within(pause)) return;
      try {
        child = std::make_unique<Child>(words, listening.descriptor(), token);
      } catch (const std::system_error& error) {
        return say(fmt::format("jounce: the live page is not started again: {}; the axes continue",
                               error.what()));
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

  const web::Listening listening;
  const std::vector<std::string> words;
  const std::string token = web::new_token();
  std::deque<Nanos> starts;
  std::mutex mutex;
  std::condition_variable end;
  bool ending = false;
  std::thread keeper;
};

PageProcess::PageProcess(std::uint16_t port, const std::vector<std::string>& axes,
                         const LinkOptions& link)
    : impl_(std::make_unique<Impl>(port, axes, link)) {}
PageProcess::~PageProcess() = default;

std::string PageProcess::address() const {
  return "http://127.0.0.1:" + std::to_string(impl_->listening.port()) + "/#" + impl_->token;
}

}  // namespace jounce::cli
