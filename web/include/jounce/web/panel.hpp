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
  std::optional<wire::Key> key{};   ///< theirs, if they have one
  std::string title{};              ///< title of the page
  std::string token{};              ///< without which no order is taken; as new_token() makes it
  std::string warning{};            ///< that stands on top of the page; empty: none
};

/// A live page of some axes: what they do, streaming, and the orders that an operator gives.
///
///     const PanelOptions options{.axes = {"feeder"}, .token = new_token()};
///     const Panel panel(options, Listening(8080), [&] { return connect(url); });
///     print(panel.address());   // "http://127.0.0.1:8080/#3f0c...": with it orders can be given
///
/// It is an operator like any other, and belongs in a process without axes: it receives the statuses of the
/// axes and sends orders over the stream protocol, signed where there is a key. A stop waits for no other
/// order. Someone who has the page but not the address as printed can look, and order nothing.
class Panel {
 public:
  /// Throws TransportError for a link that is not there.
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
