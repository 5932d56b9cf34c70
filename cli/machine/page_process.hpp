// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "cli/machine/link.hpp"

namespace jounce::cli {

/// Descriptor under which a page that `jounce run` has started finds its listening socket.
inline constexpr int page_socket = 3;

/// A live page of these axes in a process of its own, `jounce page`, as long as this object lives:
///
///     const PageProcess page(8080, {"feeder"}, link);
///     print(page.address());
///
/// The process that runs the axes opens the port, so that one that is taken is reported at the start, and keeps
/// it and the token, so that a page that is started again has the same address; it never accepts a
/// connection. A page that ends is started again after a second, but no more than 5 times in a minute.
/// It is killed with this process, for any cause of its end. Nothing here waits for the page.
class PageProcess {
 public:
  /// Throws InputError for a port that is taken, std::system_error where no process can be started.
  PageProcess(std::uint16_t port, const std::vector<std::string>& axes, const LinkOptions& link);
  ~PageProcess();
  PageProcess(const PageProcess&) = delete;
  PageProcess& operator=(const PageProcess&) = delete;

  [[nodiscard]] std::string address() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace jounce::cli
