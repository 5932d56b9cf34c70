#include "jounce/io/file.hpp"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

struct Temporary {
  std::string name;
  int handle;
  bool kept = false;

  ~Temporary() {
    if (handle >= 0) close(handle);
    if (!kept) unlink(name.c_str());
  }
};

Temporary temporary_beside(const std::string& path) {
  std::string name = path + ".XXXXXX";
  const int handle = mkstemp(name.data());
  if (handle < 0) fail("cannot write " + path);
  return {std::move(name), handle};
}

}  // namespace

std::string read_file(const std::string& path) {
  if (path == "-") return {std::istreambuf_iterator<char>(std::cin), {}};
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path))
    throw InputError(
        "", "", "cannot be read: " + std::generic_category().message(errno == 0 ? EISDIR : errno))
        .at(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_file(const std::string& path, const std::string& bytes) {
  if (path == "-") {
    std::cout.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush();
    if (!std::cout) fail("cannot write to standard output");
    return;
  }
  Temporary file = temporary_beside(path);
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = write(file.handle, bytes.data() + done, bytes.size() - done);
    if (written < 0) fail("cannot write " + path);
    done += static_cast<std::size_t>(written);
  }
  if (fsync(file.handle) != 0 && errno != EINVAL) fail("cannot write " + path);
  // mkstemp makes a private file; what a tool writes has the rights the user asked for.
  const mode_t mask = umask(0);
  umask(mask);
  fchmod(file.handle, 0666 & ~mask);
  if (std::rename(file.name.c_str(), path.c_str()) != 0) fail("cannot write " + path);
  file.kept = true;
}

}  // namespace jounce
