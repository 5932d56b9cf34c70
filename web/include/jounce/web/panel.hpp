// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jounce/stream/security/key.hpp"
#include "jounce/stream/transport/transport.hpp"
#include "jounce/web/jogs.hpp"
#include "jounce/web/server.hpp"

namespace jounce::web {

struct PanelOptions {
  std::vector<std::string> axes{};  ///< names of the executors to show
  std::optional<wire::Key> key{};   ///< their key, if they have one
  std::string title{};              ///< title of the page
  std::string token{};              ///< required for commands; from new_token()
  std::string warning{};            ///< shown at the top of the page; empty: none
};

/// A live page of some axes: their present state, streamed, and the commands of an operator.
///
///     const PanelOptions options{.axes = {"feeder"}, .token = new_token()};
///     const Panel panel(options, Listening(8080), [&] { return connect(url); });
///     print(panel.address());   // "http://127.0.0.1:8080/#3f0c...": permits commands
///
/// It acts as an operator, and belongs in a process without axes: it receives the statuses of the
/// axes and sends commands over the stream protocol, signed if there is a key. A stop waits for no
/// other command. A viewer of the page without the printed address can read, but send no commands.
class Panel {
 public:
  /// Throws TransportError if the link cannot be opened.
  Panel(const PanelOptions& options, Listening listening, MakeLink make_link);
  ~Panel();
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;

  [[nodiscard]] std::string address() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace jounce::web
