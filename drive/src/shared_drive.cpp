// SPDX-License-Identifier: Apache-2.0
#include "jounce/drive/shared_drive.hpp"

#include <algorithm>
#include <cerrno>
#include <new>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

void require_name(const std::string& name) {
  const auto good = [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  };
  if (name.empty() || name.size() > 64 || !std::all_of(name.begin(), name.end(), good))
    throw InputError("name", name,
                     "must have 1 to 64 characters, each a letter A-Z or a-z, a digit, _ or -");
}

[[noreturn]] void fail(const char* what, const std::string& path) {
  throw std::system_error(errno, std::generic_category(), what + (" " + path));
}

}  // namespace

void require_shared_drive(const std::string& name, const Cia402Config& config) {
  require_name(name);
  (void)Cia402Axis(config);
}

SharedMemory::SharedMemory(const std::string& name, Side side)
    : path_("/jounce-drive-" + name), side_(side) {
  require_name(name);
  const bool maker = side == Side::executor;
  file_ = shm_open(path_.c_str(), maker ? O_RDWR | O_CREAT | O_CLOEXEC : O_RDWR | O_CLOEXEC, 0600);
  if (file_ < 0) fail("cannot open shared memory", path_);
  try {
    // The lock ends with its process, for any reason of its end: memory without a lock is free.
    if (maker && flock(file_, LOCK_EX | LOCK_NB) != 0)
      throw InputError("name", name, "is used by another executor");
    if (maker && ftruncate(file_, sizeof(SharedProcessData)) != 0)
      fail("cannot size shared memory", path_);
    struct stat status {};
    if (fstat(file_, &status) != 0 ||
        status.st_size < static_cast<off_t>(sizeof(SharedProcessData))) {
      errno = ENODATA;
      fail("incomplete shared memory", path_);
    }
    void* at =
        mmap(nullptr, sizeof(SharedProcessData), PROT_READ | PROT_WRITE, MAP_SHARED, file_, 0);
    if (at == MAP_FAILED) fail("cannot map shared memory", path_);
    data_ = maker ? new (at) SharedProcessData{} : static_cast<SharedProcessData*>(at);
  } catch (...) {
    close(file_);
    throw;
  }
  if (maker) data_->magic.store(SharedProcessData::magic_number, std::memory_order_release);
  if (data_->magic.load(std::memory_order_acquire) == SharedProcessData::magic_number) return;
  munmap(data_, sizeof(SharedProcessData));
  close(file_);
  errno = ENODATA;
  fail("no executor provides shared memory", path_);
}

SharedMemory::~SharedMemory() {
  if (side_ == Side::executor) {
    data_->magic.store(0, std::memory_order_release);  // shows the end to the other side
    shm_unlink(path_.c_str());
  }
  munmap(data_, sizeof(SharedProcessData));
  close(file_);
}

SharedDrive::SharedDrive(const std::string& name, const Cia402Config& config, int silent_cycles)
    : memory_(name, SharedMemory::Side::executor), axis_(config), silent_cycles_(silent_cycles) {
  if (silent_cycles < 1)
    throw InputError("silent_cycles", std::to_string(silent_cycles), "must be at least 1");
}

Feedback SharedDrive::feedback() noexcept {
  const auto now = memory_->inputs.read();
  silent_ = now && now->cycle != inputs_.cycle ? 0 : std::min(silent_ + 1, silent_cycles_);
  if (now) inputs_ = *now;
  if (inputs_.cycle == 0) return {.ready = false};
  Feedback said = axis_.feedback(inputs_.data);
  if (silent_ == silent_cycles_) {
    said.ready = false;
    said.fault = true;
  }
  return said;
}

void SharedDrive::command(const DriveSetpoint& setpoint) noexcept {
  memory_->outputs.write({++cycle_, axis_.command(setpoint, inputs_.data)});
}

}  // namespace jounce
