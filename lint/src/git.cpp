// SPDX-License-Identifier: Apache-2.0
#include "lint/src/git.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace jounce::lint_detail {
namespace {

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> all;
  for (std::string& text : texts) all.push_back(text.data());
  all.push_back(nullptr);
  return all;
}

[[noreturn]] void fail(int error) {
  throw std::system_error(error, std::generic_category(), "cannot run git");
}

std::string read_all(int pipe) {
  std::string all;
  std::array<char, 4096> buffer{};
  for (ssize_t n; (n = read(pipe, buffer.data(), buffer.size())) != 0;) {
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) break;
    all.append(buffer.data(), static_cast<std::size_t>(n));
  }
  return all;
}

}  // namespace

GitAnswer git(std::vector<std::string> arguments, const std::optional<std::string>& index) {
  arguments.insert(arguments.begin(), "git");
  std::vector<std::string> environment;
  for (char** entry = environ; *entry != nullptr; ++entry) environment.emplace_back(*entry);
  if (index) environment.push_back("GIT_INDEX_FILE=" + *index);
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail(errno);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  pid_t child = 0;
  const int error = posix_spawnp(&child, "git", &actions, nullptr, pointers(arguments).data(),
                                 pointers(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  GitAnswer answer{.status = 0, .out = error == 0 ? read_all(ends[0]) : ""};
  close(ends[0]);
  if (error != 0) fail(error);
  while (waitpid(child, &answer.status, 0) < 0 && errno == EINTR) {
  }
  while (answer.out.ends_with('\n')) answer.out.pop_back();
  return answer;
}

}  // namespace jounce::lint_detail
