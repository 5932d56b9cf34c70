// SPDX-License-Identifier: Apache-2.0
#include "edit/src/only_one.hpp"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <system_error>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "jounce/base/hash.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::edit_detail {

// A name in the abstract namespace of Linux: the kernel removes it with its process, also after
// kill -9, and it leaves no file.
OnlyOne::OnlyOne(const std::string& path) : socket_(socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
  const std::string full = std::filesystem::weakly_canonical(path).string();
  const std::string name = "jounce-edit-" + hex(sha256(full));
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::copy(name.begin(), name.end(), address.sun_path + 1);
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  if (socket_ >= 0 && bind(socket_, reinterpret_cast<const sockaddr*>(&address), size) == 0) return;
  const int error = errno;
  if (socket_ >= 0) close(socket_);
  if (error == EADDRINUSE)
    throw InputError("", "",
                     "is open in another `jounce edit`: use the address that it printed, or end it")
        .at(path);
  throw std::system_error(error, std::generic_category(), "cannot lock " + path);
}

OnlyOne::~OnlyOne() {
  close(socket_);
}

}  // namespace jounce::edit_detail
