// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/file.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <random>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include "jounce/profiles/error.hpp"

#include "base/src/utf16.hpp"

namespace jounce {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

void write_all(int handle, const Output& file) {
  for (std::size_t done = 0; done < file.bytes.size();) {
    const ssize_t written = write(handle, file.bytes.data() + done, file.bytes.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("cannot write " + (file.path == "-" ? "to standard output" : file.path));
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

/// The name of a file that is removed at the end, unless it was released.
struct Unlinked {
  std::string name;
  explicit Unlinked(std::string n) : name(std::move(n)) {}
  Unlinked(Unlinked&& other) noexcept : name(std::exchange(other.name, "")) {}
  Unlinked& operator=(Unlinked&&) = delete;
  ~Unlinked() {
    if (!name.empty()) unlink(name.c_str());
  }
};

/// A file under a temporary name in the same folder; removed unless it was renamed.
class Temporary {
 public:
  explicit Temporary(const Output& file) : path_(target(file.path)), at_("") {
    struct stat existing {};
    const bool replaces = stat(path_.c_str(), &existing) == 0;
    const Handle handle = created(replaces ? 0600 : 0666);
    write_all(handle.number, file);
    if (fsync(handle.number) != 0 && errno != EINVAL) fail("cannot write " + path_);
    if (replaces) fchmod(handle.number, existing.st_mode & 07777U);
  }

  void rename() {
    if (std::rename(at_.name.c_str(), path_.c_str()) != 0) fail("cannot write " + path_);
    at_.name.clear();
  }

 private:
  /// The file that a link points to, which need not exist: the link itself is kept.
  static std::string target(std::filesystem::path path) {
    std::error_code error;
    for (int links = 0; std::filesystem::is_symlink(std::filesystem::symlink_status(path, error));
         ++links) {
      if (links == most_links) {
        errno = ELOOP;
        fail("cannot write " + path.string());
      }
      path =
          path.parent_path() / std::filesystem::read_symlink(path);  // an absolute one replaces it
    }
    return path.string();
  }
  static constexpr int most_links = 40;  ///< limit of the kernel

  /// Creates the file, with these rights less the umask. After mkstemp(), which makes a private
  /// file, the program would need the umask, which it can only read by changing it for all threads.
  Handle created(mode_t rights) {
    std::random_device random;
    for (int tries = 0; tries < most_tries; ++tries) {
      at_.name = path_ + '.';
      for (int i = 0; i < 6; ++i) at_.name += static_cast<char>('a' + random() % 26);
      Handle handle(open(at_.name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, rights));
      if (handle.number >= 0) return handle;
      if (errno != EEXIST) break;
    }
    at_.name.clear();
    fail("cannot write " + path_);
  }
  static constexpr int most_tries = 100;  ///< for a name that is free

  std::string path_;
  Unlinked at_;
};

/// True if the name stands for something that must not be replaced: a device, a pipe, a terminal.
bool is_special(const std::string& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
         !std::filesystem::is_directory(status);
}

constexpr int patience_of_pipe = 5;  ///< s

/// Opens a pipe for writing when a program reads it: a blocking open() has no limit.
int opened_pipe(const std::string& path) {
  constexpr int slice = 20'000;  // us
  for (int waited = 0; waited < 1'000'000 * patience_of_pipe; waited += slice) {
    const int pipe = open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    if (pipe >= 0) fcntl(pipe, F_SETFL, 0);
    if (pipe >= 0 || errno != ENXIO) return pipe;
    usleep(slice);
  }
  throw std::system_error(ENXIO, std::generic_category(),
                          "cannot write " + path + ": no program reads this pipe within " +
                              std::to_string(patience_of_pipe) + " s");
}

void write_directly(const Output& file) {
  const Handle handle(file.path == "-"                      ? dup(STDOUT_FILENO)
                      : std::filesystem::is_fifo(file.path) ? opened_pipe(file.path)
                                                            : open(file.path.c_str(), O_WRONLY));
  if (handle.number < 0) fail("cannot write " + file.path);
  write_all(handle.number, file);
}

/// True if both names lead to one file.
bool is_same(const std::string& a, const std::string& b) {
  std::error_code error;
  if (a == "-" || b == "-") return a == b;
  // A relative name whose first folder does not exist would stay relative.
  const auto one = std::filesystem::weakly_canonical(std::filesystem::absolute(a, error), error);
  if (error) return a == b;
  const auto other = std::filesystem::weakly_canonical(std::filesystem::absolute(b, error), error);
  return error ? a == b : one == other;
}

bool is_folder(const std::string& path) {
  std::error_code none;
  return std::filesystem::is_directory(path, none);
}

}  // namespace

namespace {

constexpr std::size_t most_of_device = std::size_t{1} << 28;  ///< bytes; it may have no end

[[noreturn]] void fail_to_read(const std::string& path, int cause) {
  if (cause == EISDIR) throw InputError("", "", "is a folder: name a file").at(path);
  throw InputError("", "", "cannot be read: " + std::generic_category().message(cause)).at(path);
}

/// True if a program has the empty pipe open for writing: tee() of nothing then fails, and returns 0 otherwise.
/// It takes no byte away.
bool has_writer(int pipe) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return true;
  const Handle out(ends[0]);
  const Handle in(ends[1]);
  return tee(pipe, in.number, 1, SPLICE_F_NONBLOCK) != 0;
}

/// Waits until a program has the pipe open for writing, or has had it. A blocking open() has no such limit.
void wait_for_writer(int pipe, const std::string& path) {
  constexpr int slice = 20;  // ms
  for (int waited = 0; waited < 1000 * patience_of_pipe; waited += slice) {
    pollfd seen{pipe, POLLIN, 0};
    if (poll(&seen, 1, slice) > 0) return;
    if (has_writer(pipe)) return;
  }
  throw InputError("", "",
                   "is a pipe that no program opened for writing within " +
                       std::to_string(patience_of_pipe) + " s: start its writer, or name a file")
      .at(path);
}

/// To be read from its start to its end.
Handle opened(const std::string& path) {
  if (is_folder(path)) fail_to_read(path, EISDIR);
  std::error_code none;
  const bool pipe = std::filesystem::is_fifo(path, none);
  Handle file(open(path.c_str(), O_RDONLY | O_CLOEXEC | (pipe ? O_NONBLOCK : 0)));
  if (file.number < 0) fail_to_read(path, errno);
  if (pipe) {
    wait_for_writer(file.number, path);
    fcntl(file.number, F_SETFL, 0);
  }
  return file;
}

/// The bytes of standard input. The second call gets none, unless the stream has been exchanged.
std::string standard_input() {
  static std::atomic<bool> was_read = false;
  std::string bytes{std::istreambuf_iterator<char>(std::cin), {}};
  if (was_read.exchange(!bytes.empty()) && bytes.empty())
    throw InputError("", "", "is named twice, and can be read once: name a file for one of the two")
        .at("standard input");
  return bytes;
}

std::string read_bytes(const std::string& path) {
  if (path == "-") return standard_input();
  const Handle file = opened(path);
  std::string bytes;
  std::vector<char> chunk(1 << 16);
  while (const ssize_t n = read(file.number, chunk.data(), chunk.size())) {
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail_to_read(path, errno);
    if (bytes.size() >= most_of_device && is_special(path))
      throw InputError("", "", "must be a regular file, or a pipe of at most 256 MiB").at(path);
    bytes.append(chunk.data(), static_cast<std::size_t>(n));
  }
  return bytes;
}

/// True if both names lead to one file that exists. "-" is no file.
bool is_one_file(const std::string& a, const std::string& b) {
  std::error_code none;
  return a != "-" && b != "-" && std::filesystem::equivalent(a, b, none);
}

/// Names what stands where text was meant.
void require_text(const std::string& path, const std::string& bytes, Archive archive) {
  const auto fail_with = [&](const char* rule) { throw InputError("", "", rule).at(path, 1); };
  if (bytes.starts_with("\x1F\x8B")) fail_with("is compressed by gzip: unpack it first (gunzip)");
  if (bytes.starts_with("\xD0\xCF\x11\xE0"))
    fail_with("is a file of an old Office program: save its table as .xlsx or as CSV");
  if (bytes.starts_with("PK\x03\x04") && archive == Archive::rejected)
    fail_with(
        "is a zip archive or a workbook: `jounce fit` and the key `points` of a spec read points "
        "from .xlsx; for any other use, save the table as CSV");
}

std::string utf8_of(const std::string& path, const std::string& utf16) {
  try {
    return base_detail::from_utf16(utf16);
  } catch (const InputError& error) {
    throw error.at(path, 1);
  }
}

}  // namespace

void require_no_input(const std::vector<std::string>& inputs, const std::string& output,
                      const std::string& option) {
  for (const std::string& input : inputs)
    if (is_one_file(input, output) || is_one_file(input.substr(0, input.rfind('#')), output))
      throw InputError(option, output, "is also an input: choose another name");
}

void require_other_file(const std::string& input, const std::string& output,
                        const std::string& option) {
  if (is_one_file(input, output))
    throw InputError(option, output, "is also the input: choose another name");
}

std::FILE* text_stream(bool json, std::initializer_list<std::string> files) {
  const bool taken = std::find(files.begin(), files.end(), "-") != files.end();
  if (json && taken)
    throw InputError("--json", "",
                     "standard output already receives another output: write that one to a file, "
                     "or leave out --json");
  return taken ? stderr : stdout;
}

std::string read_file(const std::string& path, Archive archive) {
  std::string bytes = read_bytes(path);
  require_text(path, bytes, archive);
  if (base_detail::is_utf16(bytes)) return utf8_of(path, bytes);
  if (bytes.starts_with("\xEF\xBB\xBF"))
    bytes.erase(0, 3);  // a byte order mark has no meaning in UTF-8
  return bytes;
}

void write_files(const std::vector<Output>& files, const std::vector<std::string>& inputs) {
  for (const Output& file : files)
    if (!is_special(file.path)) require_no_input(inputs, file.path);
  for (std::size_t i = 0; i < files.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (is_same(files[i].path, files[k].path))
        throw InputError(
            "", "",
            files[i].path == "-"
                ? "two outputs go to standard output: name a file for one of them"
                : "two outputs have the name " + files[i].path + ": give each its own name");
  std::vector<Temporary> written;
  for (const Output& file : files)
    if (file.path != "-" && !is_special(file.path)) {
      if (is_folder(file.path)) {
        errno = EISDIR;
        fail("cannot write " + file.path);
      }
      written.emplace_back(file);
    }
  for (const Output& file : files)
    if (file.path == "-" || is_special(file.path)) write_directly(file);
  for (Temporary& file : written) file.rename();
}

void write_file(const std::string& path, const std::string& bytes,
                const std::vector<std::string>& inputs) {
  write_files({{path, bytes}}, inputs);
}

}  // namespace jounce
