#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jounce/stream/key.hpp"
#include "jounce/stream/transport.hpp"

namespace jounce::web {

struct PanelOptions {
  std::uint16_t port = 0;           ///< on 127.0.0.1; 0: any free one
  std::vector<std::string> axes{};  ///< names of the executors to show
  std::optional<wire::Key> key{};   ///< theirs, if they have one
  std::string title{};              ///< of the page
};

/// Makes a link of its own for each thread that needs one; called from several threads.
using MakeLink = std::function<std::unique_ptr<Transport>()>;

/// A live page of some axes: what they do, streaming, and the orders that an operator gives.
///
///     const Panel panel({.port = 8080, .axes = {"feeder"}}, [&] { return connect(url); });
///     print(panel.address());   // "http://127.0.0.1:8080/#3f0c...": with it orders can be given
///
/// It stands outside the executor, as any operator does: it hears the axes' statuses and sends
/// orders over the stream protocol, signed where there is a key, from threads of its own, which the
/// cycle knows nothing of; no order waits for another one. Whoever has the page but not the address as
/// printed can look, and order nothing.
class Panel {
 public:
  /// Throws InputError for a port that is taken, TransportError for a link that is not there.
  Panel(const PanelOptions& options, MakeLink make_link);
  ~Panel();
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;

  [[nodiscard]] std::string address() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace jounce::web
