#include "jounce/web/server.hpp"

#include <atomic>
#include <chrono>
#include <thread>
#include <utility>

#include <httplib.h>

#include "jounce/profiles/error.hpp"
#include "jounce/web/gate.hpp"

namespace jounce::web {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t threads = Server::most_readers + 6;
constexpr auto period = 50ms;  // of events
constexpr std::size_t longest_order = 1024;

Origin origin_of(const httplib::Request& request) {
  return {request.get_header_value("Host"), request.get_header_value("Origin"),
          request.get_header_value("Sec-Fetch-Site")};
}

/// Unlike httplib's own, without SO_REUSEPORT: with it another process could share the port.
void reuse_address(socket_t socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

}  // namespace

struct Server::Impl {
  Impl(std::uint16_t wanted, std::string its_token, Site its_site)
      : token(std::move(its_token)), site(std::move(its_site)) {
    bound(http);
    guard();
    serve();
    const int got = wanted == 0 ? http.bind_to_any_port("127.0.0.1")
                    : http.bind_to_port("127.0.0.1", int{wanted}) ? int{wanted}
                                                                  : -1;
    if (got <= 0)
      throw InputError("web", std::to_string(wanted), "the port is taken, or not permitted");
    port = static_cast<std::uint16_t>(got);
    listener = std::thread([this] { http.listen_after_bind(); });
    for (int i = 0; i < 5000 && !http.is_running(); ++i)
      std::this_thread::sleep_for(1ms);  // else stop() would do nothing
  }

  ~Impl() {
    running = false;
    http.stop();
    listener.join();
  }

  /// Nobody holds a thread or the memory for long.
  static void bound(httplib::Server& http) {
    http.new_task_queue = [] { return new httplib::ThreadPool(threads); };
    http.set_socket_options(reuse_address);
    http.set_tcp_nodelay(true);
    http.set_read_timeout(5s);
    http.set_write_timeout(5s);
    http.set_keep_alive_max_count(100);
    http.set_keep_alive_timeout(1);
    http.set_payload_max_length(longest_order);
  }

  void guard() {
    http.set_default_headers(
        {{"Content-Security-Policy",
          "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src "
          "data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
         {"X-Frame-Options", "DENY"},
         {"X-Content-Type-Options", "nosniff"},
         {"Referrer-Policy", "no-referrer"},
         {"Cross-Origin-Resource-Policy", "same-origin"},
         {"Cache-Control", "no-store"}});
    http.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& out) {
      const std::string no = objection(origin_of(request), port);
      if (no.empty()) return httplib::Server::HandlerResponse::Unhandled;
      out.status = 403;
      out.set_content(no + "\n", "text/plain");
      return httplib::Server::HandlerResponse::Handled;
    });
    http.set_exception_handler([](const httplib::Request&, httplib::Response& out,
                                  const std::exception_ptr&) { out.status = 500; });
  }

  void serve() {
    const auto text = [this](const char* path, const std::string& content, const char* type) {
      http.Get(path, [&content, type](const httplib::Request&, httplib::Response& out) {
        out.set_content(content, type);
      });
    };
    text("/", site.page, "text/html; charset=utf-8");
    text("/panel\\.js", site.script, "text/javascript; charset=utf-8");
    text("/panel\\.css", site.style, "text/css; charset=utf-8");
    http.Get("/events", [this](const httplib::Request&, httplib::Response& out) { events(out); });
    http.Post("/order", [this](const httplib::Request& request, httplib::Response& out) {
      order(request, out);
    });
  }

  void order(const httplib::Request& request, httplib::Response& out) const {
    if (!same(request.get_header_value("X-Jounce-Token"), token)) {
      out.status = 403;
      out.set_content("open the address that jounce run printed, to give orders\n", "text/plain");
      return;
    }
    const Answer answer = site.order(request.body);
    out.status = answer.status;
    out.set_content(answer.json, "application/json");
  }

  void events(httplib::Response& out) {
    if (readers.fetch_add(1) >= most_readers) {
      --readers;
      out.status = 503;
      out.set_content("eight pages are open already\n", "text/plain");
      return;
    }
    out.set_chunked_content_provider(
        "text/event-stream",
        [this, seen = std::int64_t{0}](std::size_t /*offset*/, httplib::DataSink& sink) mutable {
          if (!running) return false;
          const std::string event = "data: " + site.event(seen) + "\n\n";
          if (!sink.write(event.data(), event.size())) return false;
          std::this_thread::sleep_for(period);
          return true;
        },
        [this](bool /*complete*/) { --readers; });
  }

  std::string token;
  Site site;
  std::uint16_t port = 0;
  std::atomic<bool> running{true};
  std::atomic<int> readers{0};
  httplib::Server http;
  std::thread listener;
};

Server::Server(std::uint16_t port, std::string token, Site site)
    : impl_(std::make_unique<Impl>(port, std::move(token), std::move(site))) {}
Server::~Server() = default;

std::uint16_t Server::port() const {
  return impl_->port;
}

}  // namespace jounce::web
