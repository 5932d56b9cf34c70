// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/security/key.hpp"

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sodium.h>
#include <sys/stat.h>
#include <unistd.h>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

constexpr std::size_t key_digits = 64;
constexpr std::size_t most_bytes = 256;  // including white space: a key file has no more

/// A file descriptor; the destructor closes it.
class File {
 public:
  File(const std::filesystem::path& path, int flags) : fd_(open(path.c_str(), flags, 0600)) {}
  ~File() {
    if (fd_ >= 0) close(fd_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  [[nodiscard]] int get() const { return fd_; }

 private:
  int fd_;
};

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& rule) {
  throw InputError("key", path.string(), rule);
}

/// Reads the whole file, after checking that no other user can have read it.
std::string private_text(const std::filesystem::path& path) {
  const File file(path, O_RDONLY | O_CLOEXEC);
  struct stat about {};
  if (file.get() < 0 || fstat(file.get(), &about) != 0)
    refuse(path, std::string("cannot be read: ") + std::strerror(errno));
  if (!S_ISREG(about.st_mode)) refuse(path, "must be a file");
  if ((about.st_mode & 077U) != 0)
    refuse(path, "must be readable by its owner only: chmod 600 " + path.string());
  std::string text(most_bytes + 1, '\0');
  const ssize_t size = read(file.get(), text.data(), text.size());
  if (size < 0) refuse(path, std::string("cannot be read: ") + std::strerror(errno));
  text.resize(static_cast<std::size_t>(size));
  return text;
}

}  // namespace

wire::Key read_key(const std::filesystem::path& path) {
  std::string text = private_text(path);
  wire::Key key{};
  std::size_t length = 0;
  const char* end = nullptr;
  // sodium_hex2bin() would skip zeros like white space.
  const bool hex =
      text.find('\0') == text.npos && sodium_hex2bin(key.data(), key.size(), text.data(),
                                                     text.size(), " \t\r\n", &length, &end) == 0;
  // A longer file was not read completely.
  const bool whole =
      text.size() <= most_bytes && hex && length == key.size() && end == text.data() + text.size();
  sodium_memzero(text.data(), text.size());
  if (!whole) refuse(path, "must hold " + std::to_string(key_digits) + " hexadecimal digits");
  return key;
}

void write_new_key(const std::filesystem::path& path) {
  if (sodium_init() < 0) throw std::system_error(EIO, std::generic_category(), "libsodium");
  wire::Key key;
  randombytes_buf(key.data(), key.size());
  std::string text(key_digits + 1, '\0');
  sodium_bin2hex(text.data(), text.size(), key.data(), key.size());
  text[key_digits] = '\n';
  const File file(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC);
  if (file.get() < 0 && errno == EEXIST)
    refuse(path, "exists already, and a key is never overwritten: remove it first");
  if (file.get() < 0 ||
      write(file.get(), text.data(), text.size()) != static_cast<ssize_t>(text.size()) ||
      fsync(file.get()) != 0)
    throw std::system_error(errno, std::generic_category(), path.string());
  sodium_memzero(text.data(), text.size());
}

}  // namespace jounce
