// SPDX-License-Identifier: Apache-2.0
#include "study/src/sweep/journal.hpp"

#include <cassert>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "jounce/base/file.hpp"
#include "jounce/base/hash.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

constexpr std::size_t checksum_size = 16;  // hexadecimal digits of the SHA-256

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

std::string sealed(const std::string& line) {
  return hex(sha256(line)).substr(0, checksum_size) + ' ' + line + '\n';
}

std::string head(const std::string& identity) {
  return "# jounce journal 1 of " + identity + '\n';
}

}  // namespace

Journal::Journal(const std::string& path, const std::string& identity) : path_(path) {
  file_ = open(path.c_str(), O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) fail("cannot write " + path);
  try {
    if (flock(file_, LOCK_EX | LOCK_NB) != 0) {
      if (errno != EWOULDBLOCK) fail("cannot lock " + path);
      throw InputError("", "", "is in use by another run of this sweep: wait for its end").at(path);
    }
    read(identity);
  } catch (...) {
    close(file_);
    throw;
  }
}

Journal::~Journal() {
  close(file_);
}

void Journal::read(const std::string& identity) {
  const std::string text = read_file(path_);
  const std::size_t whole = text.rfind('\n') + 1;  // 0 if there is no line
  const std::string first = head(identity);
  const bool begun = first.starts_with(text);  // killed while it made its first line
  if (!begun && !text.starts_with(first)) {
    const bool ours = text.starts_with("# jounce journal ");
    throw InputError(
        "", "",
        ours ? "belongs to another sweep, spec or version of Jounce: delete it to start again"
             : "is not the journal of a sweep")
        .at(path_);
  }
  if (ftruncate(file_, begun ? 0 : static_cast<off_t>(whole)) != 0) fail("cannot write " + path_);
  if (begun && write(file_, first.data(), first.size()) != static_cast<ssize_t>(first.size()))
    fail("cannot write " + path_);
  for (std::size_t at = first.size(); !begun && at < whole;) {
    const std::size_t end = text.find('\n', at);
    const std::string line = text.substr(at, end - at);
    if (line.size() > checksum_size && sealed(line.substr(checksum_size + 1)) == line + '\n')
      lines_.push_back(line.substr(checksum_size + 1));
    at = end + 1;
  }
}

void Journal::append(const std::string& line) {
  assert(line.find('\n') == std::string::npos);
  const std::string all = sealed(line);
  const ssize_t written = write(file_, all.data(), all.size());
  if (written != static_cast<ssize_t>(all.size())) fail("cannot write " + path_);
}

}  // namespace jounce
