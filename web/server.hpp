#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace jounce::web {

/// An answer to an order.
struct Answer {
  int status = 200;  ///< of HTTP
  std::string json{};
};

/// What a server serves. The functions are called from several threads at once.
struct Site {
  std::string page{};    ///< HTML, at /
  std::string script{};  ///< JavaScript, at /panel.js
  std::string style{};   ///< CSS, at /panel.css
  /// The next event, in JSON; `seen` is 0 for a new reader, and its own place from then on.
  std::function<std::string(std::int64_t& seen)> event;
  std::function<Answer(const std::string& body)> order;  ///< what a POST to /order says
};

/// Serves one site on 127.0.0.1 alone, on threads of its own, from its making to its end:
///
///     const Server server(8080, token, site);    // 0: any free port
///     print("http://127.0.0.1:{}/#{}", server.port(), token);
///
/// GET / and its script and style, GET /events (server-sent events, 20 a second, eight readers at
/// once), POST /order. What objection() has something against is not answered (403), nor an order
/// without the header X-Jounce-Token. The page may load nothing from elsewhere, nor be framed.
class Server {
 public:
  static constexpr int most_readers = 8;

  /// Throws InputError for a port that is taken or not permitted.
  Server(std::uint16_t port, std::string token, Site site);
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
