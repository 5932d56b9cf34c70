// SPDX-License-Identifier: Apache-2.0
#include "jounce/web/server.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <limits>
#include <list>
#include <optional>
#include <thread>
#include <utility>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>

#include "jounce/web/gate.hpp"

// One thread waits for all connections. A command waits for an axis and therefore runs in a thread
// of a pool. Boost.Beast is used because its limits can be set: the token is checked before the
// body of a request is read, and a whole request has a timeout.
namespace jounce::web {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using asio::ip::tcp;
using boost::system::error_code;
using namespace std::chrono_literals;

constexpr auto period = 50ms;  // interval of events
constexpr std::size_t most_head = 8192;
constexpr std::size_t most_read = 65536;  // bytes of a body that are read at once
constexpr std::chrono::seconds patience{Server::request_seconds};
constexpr std::size_t most_drained = std::size_t{1} << 20U;  // unread bytes, before a close
constexpr auto drain_time = 1s;

using Response = http::response<http::string_body>;

std::string header(const http::request<http::empty_body>& request, const char* name) {
  const auto value = request[name];
  return {value.data(), value.size()};
}

void guard(http::fields& fields) {
  constexpr std::array<std::pair<const char*, const char*>, 7> headers{
      {{"Content-Security-Policy",
        "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src "
        "data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
       {"X-Frame-Options", "DENY"},
       {"X-Content-Type-Options", "nosniff"},
       {"Referrer-Policy", "no-referrer"},
       {"Cross-Origin-Resource-Policy", "same-origin"},
       {"Cache-Control", "no-store"},
       {"Connection", "close"}}};
  for (const auto& [name, value] : headers) fields.set(name, value);
}

bool is_one_of(const std::vector<std::string>& all, const std::string& one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

}  // namespace

struct Server::Impl {
  class Connection;
  /// The threads for requests of one kind, and the number of these requests.
  struct Lane {
    Lane(std::size_t count, int greatest) : threads(count), most(greatest) {}
    asio::thread_pool threads;
    int waiting = 0;  // used by the thread of the connections
    int most;
  };

  Impl(Listening listening, std::string its_token, Site its_site);
  ~Impl();

  void accept();
  void make_room();
  bool make_room_for_reader(bool trusted);

  std::string token;
  Site site;
  std::uint16_t port;
  int readers = 0;
  asio::io_context io;
  tcp::acceptor acceptor{io};
  asio::steady_timer pause{io};
  std::list<std::weak_ptr<Connection>> connections;  // oldest first
  Lane urgent{4, std::numeric_limits<int>::max()};
  Lane others{4, most_commands};
  Lane readings{2, most_readings};
  std::thread thread;  // last: it uses the others
};

/// One request, on its own connection.
class Server::Impl::Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(tcp::socket socket, Impl& server) : stream_(std::move(socket)), server_(server) {
    parser_.header_limit(most_head);
    // The length is checked after the token. (Beast 1.74 takes `none` for 0.)
    parser_.body_limit(std::numeric_limits<std::uint64_t>::max());
  }
  ~Connection() {
    if (reads_events_) --server_.readers;
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  void begin() {
    error_code ignored;
    stream_.socket().set_option(tcp::no_delay(true), ignored);
    stream_.expires_after(patience);  // limit for the whole request
    http::async_read_header(stream_, buffer_, parser_,
                            [self = shared_from_this()](error_code error, std::size_t /*size*/) {
                              if (error == http::error::header_limit)
                                return self->answer(431,
                                                    "the head of a request must not exceed 8 KB\n");
                              if (!error) self->route();
                            });
  }

  void close() {
    error_code ignored;
    stream_.socket().close(ignored);
    timer_.cancel();
  }

  [[nodiscard]] bool is_guest() const { return !trusted_ && !reads_events_; }
  [[nodiscard]] bool is_strange_reader() const { return !trusted_ && reads_events_; }

 private:
  void route() {
    const auto& request = parser_.get();
    const Origin origin{header(request, "Host"), header(request, "Origin"),
                        header(request, "Sec-Fetch-Site")};
    if (const std::string no = objection(origin, server_.port); !no.empty())
      return answer(403, no + "\n");
    trusted_ = same(header(request, "X-Jounce-Token"), server_.token);
    const std::string target(request.target().data(), request.target().size());
    const auto question = std::min(target.find('?'), target.size());
    request_.is_get = request.method() == http::verb::get;
    request_.path = target.substr(0, question);
    request_.query = target.substr(std::min(question + 1, target.size()));
    if (request_.is_get) {
      for (const SiteFile& file : server_.site.files)
        if (target == file.path) return answer(200, file.text, file.type);
      if (target == "/events") return events();
      if (is_one_of(server_.site.readings, request_.path)) return hand_on(server_.readings);
    }
    const std::string command = std::string(request.method_string()) + ' ' + request_.path;
    if (is_one_of(server_.site.commands, command))
      return request_.is_get ? take_question() : take_command();
    answer(404, "there is no such page\n");
  }

  // ---- a command -------------------------------------------------------------------------------

  /// A command without a body.
  void take_question() {
    if (!trusted_) return answer(403, "to read this, open the address that jounce printed\n");
    hand_on_command();
  }

  void take_command() {
    const std::size_t most_body = server_.site.most_body;
    if (!trusted_) return answer(403, "to send commands, open the address that jounce printed\n");
    if (!parser_.content_length()) return answer(411, "a command needs a Content-Length\n");
    if (*parser_.content_length() > most_body)
      return answer(413, "a command must not exceed " + std::to_string(most_body / 1024) + " KB\n");
    body_.emplace(std::move(parser_));
    body_->body_limit(most_body);
    http::async_read(stream_, buffer_, *body_,
                     [self = shared_from_this()](error_code error, std::size_t /*size*/) {
                       if (error) return;
                       self->request_.body = std::move(self->body_->get().body());
                       self->hand_on_command();
                     });
  }

  void hand_on(Lane& lane) {
    if (lane.waiting >= lane.most)
      return answer(503, "too many requests wait: repeat this one later\n");
    ++lane.waiting;
    stream_.expires_never();  // the axis has its own timeout
    const auto came = std::chrono::steady_clock::now();
    asio::post(lane.threads, [self = shared_from_this(), &lane, came] {
      // The sender may be gone: an old command causes no motion.
      const auto& limit = self->server_.site.freshness;
      const bool late = &lane == &self->server_.others && limit &&
                        std::chrono::steady_clock::now() - came > *limit;
      Answer said =
          late
              ? Answer{503,
                       R"({"ok":false,"reason":"the command waited too long for an axis: repeat it"})"}
              : self->obeyed();
      asio::post(self->server_.io, [self, said = std::move(said), &lane] {
        --lane.waiting;
        self->answer(said.status, said.body, said.type);
      });
    });
  }
  void hand_on_command() {
    const bool at_once = server_.site.urgent && server_.site.urgent(request_);
    hand_on(at_once ? server_.urgent : server_.others);
  }

  [[nodiscard]] Answer obeyed() const {
    try {
      return server_.site.obey(request_);
    } catch (const std::exception&) {
      return {500, R"({"ok":false,"reason":"the page has failed"})"};
    }
  }

  // ---- answers ----------------------------------------------------------------------------------

  void answer(int status, const std::string& text,
              const std::string& type = "text/plain; charset=utf-8") {
    response_.result(static_cast<unsigned>(status));
    response_.version(11);
    guard(response_);
    response_.set(http::field::content_type, type);
    response_.body() = text;
    response_.prepare_payload();
    stream_.expires_after(patience);
    http::async_write(stream_, response_,
                      [self = shared_from_this()](error_code error, std::size_t /*size*/) {
                        if (!error) self->leave();
                      });
  }

  /// Closing a socket with unread bytes discards the answer: reads and drops them, up to a bound.
  void leave() {
    error_code ignored;
    stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    stream_.expires_after(drain_time);
    drain();
  }
  void drain() {
    stream_.async_read_some(asio::buffer(dropped_),
                            [self = shared_from_this()](error_code error, std::size_t size) {
                              self->drained_ += size;
                              if (!error && self->drained_ < most_drained) self->drain();
                            });
  }

  // ---- events -----------------------------------------------------------------------------------

  void events() {
    if (server_.site.events_need_token && !trusted_)
      return answer(403, "to read this, open the address that jounce printed\n");
    if (!server_.make_room_for_reader(trusted_))
      return answer(503, "eight pages are open already\n");
    reads_events_ = true;
    ++server_.readers;
    http::response<http::empty_body> head{http::status::ok, 11};
    guard(head);
    head.set(http::field::content_type, "text/event-stream");
    beast::ostream(out_) << head.base();
    write();
    watch();
  }

  void tick() {
    timer_.expires_after(period);
    timer_.async_wait([self = shared_from_this()](error_code error) {
      if (error || !self->stream_.socket().is_open()) return;
      const std::string event = self->server_.site.event(self->seen_);
      if (event.empty()) return self->tick();
      beast::ostream(self->out_) << "data: " << event << "\n\n";
      self->write();
    });
  }

  void write() {
    stream_.expires_after(patience);
    asio::async_write(stream_, out_.data(),
                      [self = shared_from_this()](error_code error, std::size_t size) {
                        if (error) return self->close();
                        self->out_.consume(size);
                        self->tick();
                      });
  }

  /// A reader sends nothing more: the next event on its socket is its end.
  void watch() {
    stream_.socket().async_wait(
        tcp::socket::wait_read,
        [self = shared_from_this()](error_code /*error*/) { self->close(); });
  }

  beast::tcp_stream stream_;
  Impl& server_;
  asio::steady_timer timer_{stream_.get_executor()};
  beast::flat_buffer buffer_{most_head + most_read};
  http::request_parser<http::empty_body> parser_;
  std::optional<http::request_parser<http::string_body>> body_;
  Request request_;
  Response response_;
  beast::flat_buffer out_;
  std::array<char, 4096> dropped_{};
  std::size_t drained_ = 0;
  std::int64_t seen_ = 0;
  bool trusted_ = false;
  bool reads_events_ = false;
};

Server::Impl::Impl(Listening listening, std::string its_token, Site its_site)
    : token(std::move(its_token)), site(std::move(its_site)), port(listening.port()) {
  acceptor.assign(tcp::v4(), listening.release());
  acceptor.non_blocking(true);
  accept();
  thread = std::thread([this] {
    for (bool ended = false; !ended;) {
      try {
        io.run();
        ended = true;
      } catch (const std::exception&) {
        // One connection has failed (out of memory): it is dropped, the others continue.
      }
    }
  });
}

Server::Impl::~Impl() {
  io.stop();
  thread.join();
  others.threads.stop();
  readings.threads.stop();
  for (Lane* lane : {&urgent, &others, &readings}) lane->threads.join();
}

void Server::Impl::accept() {
  acceptor.async_accept([this](error_code error, tcp::socket socket) {
    if (error) {  // no descriptor is available: retries after a while
      pause.expires_after(100ms);
      return pause.async_wait([this](error_code stopped) {
        if (!stopped) accept();
      });
    }
    make_room();
    const auto connection = std::make_shared<Connection>(std::move(socket), *this);
    connections.push_back(connection);
    connection->begin();
    accept();
  });
}

/// Closes the oldest guest if there are too many.
void Server::Impl::make_room() {
  connections.remove_if([](const auto& one) { return one.expired(); });
  int guests = 0;
  std::shared_ptr<Connection> oldest;
  for (const auto& one : connections) {
    auto connection = one.lock();
    if (!connection || !connection->is_guest()) continue;
    if (guests++ == 0) oldest = std::move(connection);
  }
  if (guests >= most_guests) {
    oldest->close();
    connections.remove_if([&](const auto& one) { return one.lock() == oldest; });
  }
}

/// True if one more may read events; closes one without the token if necessary.
bool Server::Impl::make_room_for_reader(bool trusted) {
  if (readers < most_readers) return true;
  if (!trusted) return false;
  for (auto at = connections.begin(); at != connections.end(); ++at) {
    const auto connection = at->lock();
    if (!connection || !connection->is_strange_reader()) continue;
    connection->close();
    connections.erase(at);
    return true;
  }
  return false;
}

std::string Request::value(const std::string& key) const {
  const std::string all = "&" + query + "&";
  const auto at = all.find("&" + key + "=");
  if (at == std::string::npos) return "";
  const auto begin = at + key.size() + 2;
  const std::string raw = all.substr(begin, all.find('&', begin) - begin);
  std::string text;
  for (std::size_t i = 0; i < raw.size(); ++i) {
    unsigned char byte = 0;
    const char* const digits = raw.data() + i + 1;
    const bool is_escape = raw[i] == '%' && i + 2 < raw.size() &&
                           std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2;
    text += is_escape ? static_cast<char>(byte) : raw[i];
    if (is_escape) i += 2;
  }
  return text;
}

Server::Server(Listening listening, std::string token, Site site)
    : impl_(std::make_unique<Impl>(std::move(listening), std::move(token), std::move(site))) {}
Server::~Server() = default;

std::uint16_t Server::port() const {
  return impl_->port;
}

}  // namespace jounce::web
