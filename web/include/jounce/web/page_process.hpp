// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "jounce/web/panel.hpp"

/// A live page in a process of its own, started by the process that runs the axes.
namespace jounce::web {

/// The parent's side: a page that is served as long as this object lives.
///
///     const PageProcess page(8080, {"jounce", "page", "--of-run", "feeder"}, notify);
///     print(page.address());
///
/// The child is this program again (/proc/self/exe) with the given words, and calls
/// serve_for_parent(). The parent opens the port, so a taken one is reported at the start, and
/// keeps it and the token, so a page that is started again has the same address; it never accepts a
/// connection. A page that ends is started again after a second, at most 5 times in a minute. It
/// ends with the parent, for any cause of the end. Nothing here waits for the page.
class PageProcess {
 public:
  /// `words` are the arguments of the child, its name first. `notify` receives a sentence when the
  /// page ends; it is called from another thread. Throws InputError for a port that is taken,
  /// std::system_error if no process can be started.
  PageProcess(std::uint16_t port, std::vector<std::string> words,
              std::function<void(const std::string& notice)> notify);
  ~PageProcess();
  PageProcess(const PageProcess&) = delete;
  PageProcess& operator=(const PageProcess&) = delete;

  [[nodiscard]] std::string address() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The child's side: serves the page until the parent ends. It gives way to the parent: it has a
/// lower priority, and is the first process to be killed if memory is short. Returns false if no
/// parent sends a token. `options.token` is ignored.
bool serve_for_parent(PanelOptions options, MakeLink make_link);

}  // namespace jounce::web
