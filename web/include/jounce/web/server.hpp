// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace jounce::web {

/// An answer to an order.
struct Answer {
  int status = 200;  ///< status of HTTP
  std::string json{};
};

/// Content of a server. Several threads call the functions at once.
struct Site {
  std::string page{};    ///< HTML, at /
  std::string script{};  ///< JavaScript, at /panel.js
  std::string style{};   ///< CSS, at /panel.css
  /// The next event, in JSON; `seen` is 0 for a new reader, and its own place from then on.
  std::function<std::string(std::int64_t& seen)> event;
  std::function<Answer(const std::string& body)> order;  ///< handler of a POST to /order
  /// True if an order waits for no other one: a stop.
  std::function<bool(const std::string& body)> urgent;
};

/// A socket that listens on 127.0.0.1, and is closed at the end.
class Listening {
 public:
  /// 0: any free port. Throws InputError for a port that is taken or not permitted.
  explicit Listening(std::uint16_t port);
  /// One that listens already, inherited from another process; it now belongs to this object.
  static Listening inherited(int descriptor);
  ~Listening();
  Listening(Listening&& other) noexcept;
  Listening& operator=(Listening&&) = delete;

  [[nodiscard]] std::uint16_t port() const;
  [[nodiscard]] int descriptor() const { return descriptor_; }
  int release();  ///< the descriptor, which now belongs to the caller

 private:
  Listening() = default;
  int descriptor_ = -1;
};

/// Serves one site on 127.0.0.1 alone, on threads of its own, from its making to its end:
///
///     const Server server(Listening(8080), token, site);    // 0: any free port
///     print("http://127.0.0.1:{}/#{}", server.port(), token);
///
/// GET / and its script and style, GET /events (server-sent events, 20 a second), POST /order. One request a
/// connection. A request with an objection() is rejected (403), nor an order without the
/// header X-Jounce-Token, whose body is then not read. The page may load nothing from elsewhere, nor be framed.
///
/// Everything is bounded: a request in bytes (8 KB of head, 1 KB of body, whose length it must give) and in
/// total time; connections without the token in number, the oldest is closed for a new one; readers of
/// events in number, one without the token is closed for one with it. So an order always finds a connection.
class Server {
 public:
  static constexpr int most_readers = 8;  ///< most readers of events
  static constexpr int most_guests = 64;  ///< connections that have not shown the token
  static constexpr int most_orders =
      16;  ///< that wait for an axis at a time; stops are not counted
  static constexpr int request_seconds = 5;  ///< for a whole request; as long for an answer

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
