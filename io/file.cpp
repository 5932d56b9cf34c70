#include "jounce/io/file.hpp"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

void write_all(int handle, const Output& file) {
  for (std::size_t done = 0; done < file.bytes.size();) {
    const ssize_t written = write(handle, file.bytes.data() + done, file.bytes.size() - done);
    if (written < 0) fail("cannot write " + file.path);
    done += static_cast<std::size_t>(written);
  }
}

struct Handle {
  int number;
  explicit Handle(int n) : number(n) {}
  Handle(Handle&& other) noexcept : number(std::exchange(other.number, -1)) {}
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (number >= 0) close(number);
  }
};

/// A file under a temporary name beside its own; removed unless it was renamed.
class Temporary {
 public:
  explicit Temporary(const Output& file) : path_(target(file.path)), name_(path_ + ".XXXXXX") {
    const Handle handle(mkstemp(name_.data()));
    if (handle.number < 0) {
      name_.clear();
      fail("cannot write " + path_);
    }
    write_all(handle.number, file);
    if (fsync(handle.number) != 0 && errno != EINVAL) fail("cannot write " + path_);
    fchmod(handle.number, rights());
  }
  Temporary(Temporary&& other) noexcept
      : path_(std::move(other.path_)), name_(std::exchange(other.name_, "")) {}
  Temporary& operator=(Temporary&&) = delete;
  ~Temporary() {
    if (!name_.empty()) unlink(name_.c_str());
  }

  void rename() {
    if (std::rename(name_.c_str(), path_.c_str()) != 0) fail("cannot write " + path_);
    name_.clear();
  }

 private:
  /// What a link points to: the link itself is kept.
  static std::string target(const std::string& path) {
    return std::filesystem::is_symlink(path) ? std::filesystem::canonical(path).string() : path;
  }

  /// mkstemp makes a private file; a file keeps its rights, a new one gets those the user asked for.
  [[nodiscard]] mode_t rights() const {
    struct stat existing {};
    if (stat(path_.c_str(), &existing) == 0) return existing.st_mode & 07777U;
    const mode_t mask = umask(0);
    umask(mask);
    return 0666U & ~mask;
  }

  std::string path_;
  std::string name_;
};

/// Whether the name stands for something that must not be replaced: a device, a pipe, a terminal.
bool is_special(const std::string& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
         !std::filesystem::is_directory(status);
}

void write_directly(const Output& file) {
  const Handle handle(file.path == "-" ? dup(STDOUT_FILENO) : open(file.path.c_str(), O_WRONLY));
  if (handle.number < 0) fail("cannot write " + file.path);
  write_all(handle.number, file);
}

}  // namespace

namespace {

std::string read_bytes(const std::string& path) {
  if (path == "-") return {std::istreambuf_iterator<char>(std::cin), {}};
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path))
    throw InputError(
        "", "", "cannot be read: " + std::generic_category().message(errno == 0 ? EISDIR : errno))
        .at(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

std::string read_file(const std::string& path) {
  std::string bytes = read_bytes(path);
  if (bytes.starts_with("\xEF\xBB\xBF"))
    bytes.erase(0, 3);  // a byte order mark says nothing in UTF-8
  return bytes;
}

void write_files(const std::vector<Output>& files) {
  for (std::size_t i = 0; i < files.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (std::filesystem::weakly_canonical(files[i].path) ==
          std::filesystem::weakly_canonical(files[k].path))
        throw InputError("output", files[i].path, "two outputs cannot have one name");
  std::vector<Temporary> written;
  for (const Output& file : files)
    if (file.path != "-" && !is_special(file.path)) {
      if (std::filesystem::is_directory(file.path)) {
        errno = EISDIR;
        fail("cannot write " + file.path);
      }
      written.emplace_back(file);
    }
  for (const Output& file : files)
    if (file.path == "-" || is_special(file.path)) write_directly(file);
  for (Temporary& file : written) file.rename();
}

void write_file(const std::string& path, const std::string& bytes) {
  write_files({{path, bytes}});
}

}  // namespace jounce
