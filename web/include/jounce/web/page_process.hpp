// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "jounce/web/panel.hpp"

/// A live page in its own process, started by the process that runs the axes.
namespace jounce::web {

/// The parent's side of a live page: the page is served while this object exists.
///
///     const PageProcess page(8080, {"jounce", "page", "--of-run", "feeder"}, &trace, notify);
///     print(page.address());
///
/// The child process runs this program again (/proc/self/exe), with the given words as its
/// arguments. For these words, the program must call serve_for_parent(). The parent opens the port,
/// so it can report at once if the port is in use. The parent keeps the port and the token, so a
/// page that is started again has the same address. The parent never accepts a connection. If the
/// child ends, the parent starts it again after a second, at most 5 times in a minute. When the
/// parent ends, for any reason, the child ends, too. No function waits for the child.
class PageProcess {
 public:
  /// `words` are the arguments of the child, beginning with the name of the program. `trace`:
  /// memory with the ticks of the parent's axes, which the child reads; null: none. `notify`
  /// receives a sentence when the child ends; it is called from another thread. Throws InputError
  /// for a port that is in use, and std::system_error if no process can be started.
  PageProcess(std::uint16_t port, std::vector<std::string> words, const Trace* trace,
              std::function<void(const std::string& notice)> notify);
  ~PageProcess();
  PageProcess(const PageProcess&) = delete;
  PageProcess& operator=(const PageProcess&) = delete;

  /// Address of the page, including the token. The token permits commands.
  [[nodiscard]] std::string address() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The child's side: serves the page until the parent ends. The child has a lower priority than the
/// parent, and the system ends it first if memory is short. `options.token` is not used, because
/// the parent sends the token. Returns false if no parent sends a token.
bool serve_for_parent(PanelOptions options, MakeLink make_link);

}  // namespace jounce::web
