// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jounce/profiles/error.hpp"

namespace jounce::web {

/// A request to a server, for a command or a reading of its site.
struct Request {
  bool is_get = false;  ///< GET, without a body; otherwise POST
  std::string path{};   ///< "/order"
  std::string query{};  ///< the part of the address behind the ?
  std::string body{};

  /// Returns the value of a key of the query, such as "form" in "form=csv&axis=1", without its
  /// percent escapes; "": it is missing.
  [[nodiscard]] std::string value(const std::string& key) const;
};

/// The answer to a command.
struct Answer {
  int status = 200;  ///< HTTP status
  std::string body{};
  std::string type = "application/json";  ///< media type of the body
};

/// A file of a site, which everybody on this computer can read.
struct SiteFile {
  std::string path{};  ///< "/panel.js"
  std::string type{};  ///< media type: "text/javascript; charset=utf-8"
  std::string text{};
};

/// The content of a server. Several threads call its functions at the same time.
struct Site {
  std::vector<SiteFile> files{};
  std::vector<std::string> commands{};  ///< methods and paths: "POST /order"
  /// Paths that GET reads without the token: "/trace". obey() answers these requests, in separate
  /// threads.
  std::vector<std::string> readings{};
  /// Returns the next event of /events, as JSON; "": there is no event at this time. `seen` is 0
  /// for a new reader; the function sets it to the number of the event that this reader has
  /// received.
  std::function<std::string(std::int64_t& seen)> event{};
  std::function<Answer(const Request& request)> obey{};  ///< processes a command
  /// True for a command that must not wait for other commands: a stop. Null: there is none.
  std::function<bool(const Request& request)> urgent{};
  std::size_t most_body = 1024;    ///< greatest size of the body of a command, bytes
  bool events_need_token = false;  ///< true: events are for readers with the token only
  /// Time for which a command may wait for others; an older one is rejected. nullopt: no limit.
  std::optional<std::chrono::milliseconds> freshness{};
};

/// A socket that listens on 127.0.0.1. The destructor closes it.
class Listening {
 public:
  /// Opens the socket. A `port` of 0 means any free port. Throws InputError for a port that is in
  /// use or not permitted.
  explicit Listening(std::uint16_t port);
  /// Takes over a socket that already listens, inherited from another process.
  static Listening inherited(int descriptor);
  ~Listening();
  Listening(Listening&& other) noexcept;
  Listening& operator=(Listening&&) = delete;

  /// Port of the socket.
  [[nodiscard]] std::uint16_t port() const;
  /// File descriptor of the socket, which this object owns.
  [[nodiscard]] int descriptor() const { return descriptor_; }
  int release();  ///< returns the descriptor; the caller then owns it

 private:
  Listening() = default;
  int descriptor_ = -1;
};

/// Serves a site on 127.0.0.1, in its own threads, until it is destroyed:
///
///     const Server server(Listening(8080), token, site);    // 0: any free port
///     use(server.port());                                   // 127.0.0.1, this port
///
/// **Requests**: GET for the files and the readings of the site; GET /events (server-sent events,
/// at most 20 a second); the commands of the site. A connection serves one request. A request with
/// an objection() (gate.hpp) is rejected with status 403. A command without the header
/// X-Jounce-Token is rejected in the same way, before its body is read. The page can load nothing
/// from other servers and cannot be shown in a frame.
///
/// **Limits.** A request has at most 8 KB of head and Site::most_body of body, must state the
/// length of its body, and must arrive within request_seconds. The number of connections without
/// the token is limited: a new connection closes the oldest one. The number of readers of events is
/// limited: a new reader with the token closes a reader without it. So a command always gets a
/// connection.
class Server {
 public:
  static constexpr int most_readers = 8;  ///< greatest number of readers of events
  static constexpr int most_guests = 64;  ///< greatest number of connections without the token
  /// Greatest number of commands that wait for an axis at a time, except stops.
  static constexpr int most_commands = 16;
  static constexpr int most_readings = 8;  ///< greatest number of readings that wait
  /// Time limit for a whole request, and for an answer, s.
  static constexpr int request_seconds = 5;

  /// `token`: the token that commands need.
  Server(Listening listening, std::string token, Site site);
  /// Ends all connections.
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Port of the server.
  [[nodiscard]] std::uint16_t port() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace jounce::web
