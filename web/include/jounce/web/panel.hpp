// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jounce/executor/detail/trace.hpp"
#include "jounce/stream/security/key.hpp"
#include "jounce/stream/transport/transport.hpp"
#include "jounce/web/jogs.hpp"
#include "jounce/web/server.hpp"

namespace jounce::web {

/// Options of a live page.
struct PanelOptions {
  std::vector<std::string> axes{};  ///< names of the axes on the page
  std::optional<wire::Key> key{};   ///< key of the executors; nullopt: none
  std::string title{};              ///< title of the page
  std::string token{};              ///< token that commands need; see new_token() (gate.hpp)
  std::string warning{};            ///< text at the top of the page; "": none
  /// Ticks of the axes, in their order, from the executor. Null: the page uses the status messages.
  std::shared_ptr<const Trace> trace{};
};

/// A live page: the present state of several axes, and the commands of an operator.
///
///     const PanelOptions options{.axes = {"feeder"}, .token = new_token()};
///     const Panel panel(options, Listening(8080), [&] { return open_transport(url); });
///     print(panel.address());   // "http://127.0.0.1:8080/#3f0c...": permits commands
///
/// The page acts as an operator. It receives the status messages of the axes and sends commands
/// over the stream protocol; with a key, the commands are authenticated. Run it in a process
/// without axes. A stop does not wait for other commands. A viewer without the token in the address
/// can read, but cannot send commands.
class Panel {
 public:
  /// `listening` is the socket of the page. For `make_link`, see MakeLink. Throws TransportError if
  /// the link cannot be opened.
  Panel(const PanelOptions& options, Listening listening, MakeLink make_link);
  ~Panel();
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;

  /// Address of the page, including the token. The token permits commands.
  [[nodiscard]] std::string address() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace jounce::web
