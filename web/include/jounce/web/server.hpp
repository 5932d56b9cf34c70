// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace jounce::web {

/// An answer to a command.
struct Answer {
  int status = 200;  ///< status of HTTP
  std::string json{};
};

/// Content of a server. Several threads call the functions concurrently.
struct Site {
  std::string page{};    ///< HTML, at /
  std::string script{};  ///< JavaScript, at /panel.js
  std::string style{};   ///< CSS, at /panel.css
  /// Returns the next event, in JSON; `seen` is 0 for a new reader, and its own position from then
  /// on.
  std::function<std::string(std::int64_t& seen)> event;
  std::function<Answer(const std::string& body)> obey;  ///< handler of a POST to /order
  /// True if a command waits for no other one: a stop.
  std::function<bool(const std::string& body)> urgent;
};

/// A socket that listens on 127.0.0.1; the destructor closes it.
class Listening {
 public:
  /// `port` 0: any free port. Throws InputError for a port that is in use or not permitted.
  explicit Listening(std::uint16_t port);
  /// A socket that already listens, inherited from another process; this object then owns it.
  static Listening inherited(int descriptor);
  ~Listening();
  Listening(Listening&& other) noexcept;
  Listening& operator=(Listening&&) = delete;

  [[nodiscard]] std::uint16_t port() const;
  [[nodiscard]] int descriptor() const { return descriptor_; }
  int release();  ///< returns the descriptor, which the caller then owns

 private:
  Listening() = default;
  int descriptor_ = -1;
};

/// Serves one site on 127.0.0.1 alone, on its own threads, during its lifetime:
///
///     const Server server(Listening(8080), token, site);    // 0: any free port
///     print("http://127.0.0.1:{}/#{}", server.port(), token);
///
/// GET / and its script and style, GET /events (server-sent events, 20 a second), POST /order. One
/// request per connection. A request with an objection() is rejected (403). So is a command without
/// the header X-Jounce-Token, before its body is read. The page may load nothing from elsewhere,
/// and may not be framed.
///
/// Everything is bounded. A request: its size (8 KB of head, 1 KB of body, whose length it must
/// give) and its total time. Connections without the token: their number; the oldest is closed for
/// a new one. Readers of events: their number; one without the token is closed for one with it. A
/// command therefore always gets a connection.
class Server {
 public:
  static constexpr int most_readers = 8;  ///< readers of events, at most
  static constexpr int most_guests = 64;  ///< connections without the token, at most
  static constexpr int most_commands =
      16;  ///< commands waiting for an axis at a time; stops do not count
  static constexpr int request_seconds = 5;  ///< time limit for a whole request, and for an answer

  Server(Listening listening, std::string token, Site site);
  /// Ends all connections.
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  [[nodiscard]] std::uint16_t port() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace jounce::web
