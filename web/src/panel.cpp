// SPDX-License-Identifier: Apache-2.0
#include "jounce/web/panel.hpp"

#include <atomic>
#include <mutex>
#include <thread>
#include <utility>
#include <variant>

#include <nlohmann/json.hpp>

#include "jounce/profiles/error.hpp"
#include "jounce/stream/sender/driver.hpp"
#include "jounce/web/server.hpp"

#include "web/src/board.hpp"
#include "web/src/page.hpp"
#include "web/src/page_command.hpp"

namespace jounce::web {
namespace {

constexpr int waiting_statuses =
    64;  // a link keeps the oldest: they are read faster than they arrive
constexpr auto longest_wait =
    std::chrono::milliseconds(300);  // limit for a command that waited for others
constexpr Nanos turn = std::chrono::milliseconds(50);
constexpr Nanos again = std::chrono::seconds(1);  // interval of attempts to open a lost link again

Answer answer(int status, const std::string& reason) {
  const nlohmann::ordered_json said{{"ok", status == 200}, {"reason", reason}};
  return {status, said.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)};
}

}  // namespace

struct Panel::Impl {
  Impl(const PanelOptions& its_options, Listening listening, MakeLink its_make_link)
      : options(its_options),
        make_link(std::move(its_make_link)),
        jogs(make_link, options.key),
        board(options.axes) {
    open_ears();
    server.emplace(std::move(listening), options.token,
                   Site{.files = files_of(page(options.title, options.warning)),
                        .commands = {"POST /order"},
                        .event = [this](std::int64_t& seen) { return event(seen); },
                        .obey = [this](const Request& request) { return obey(request.body); },
                        .urgent = [](const Request& request) { return is_stop(request.body); },
                        .freshness = longest_wait});
    listener = std::thread([this] { listen(); });
  }

  ~Impl() {
    server.reset();  // first: it calls event() and obey()
    running = false;
    listener.join();
  }

  void open_ears() {
    ears = make_link();
    for (const std::string& axis : options.axes)
      for (const auto lane : {wire::Lane::status, wire::Lane::masters})
        ears->subscribe(wire::channel(axis, lane), waiting_statuses);
  }

  /// Runs until the end, in any state of the link: the page shows for how long each axis has been
  /// silent.
  void listen() {
    while (running) {
      try {
        if (!ears) open_ears();
        take_next();
      } catch (const std::exception&) {
        ears.reset();
        std::this_thread::sleep_for(again);
      }
    }
  }

  void take_next() {
    const auto message = next_message(*ears, turn, rejects, options.key);
    if (!message) return;
    const std::scoped_lock lock(mutex);
    if (const auto* const status = std::get_if<wire::Status>(&message->body))
      board.take(message->executor, *status, steady_now());
    else if (const auto* const master = std::get_if<wire::MasterStatus>(&message->body))
      board.take(message->executor, *master);
  }

  std::string event(std::int64_t& seen) {
    const std::scoped_lock lock(mutex);
    return board.json_since(seen, steady_now());
  }

  static bool is_stop(const std::string& body) {
    try {
      const std::string what = read_command(body).what;
      return what == "stop" || what == "release";
    } catch (const InputError&) {
      return false;
    }
  }

  Answer obey(const std::string& body) {
    try {
      const PageCommand command = read_command(body);
      if (!board.has(command.axis))
        throw InputError("axis", command.axis, "is not an axis of this page");
      const CallOutcome outcome = outcome_of(command);
      return answer(outcome.ok()                            ? 200
                    : outcome.error == StreamError::refused ? 409
                                                            : 504,
                    outcome.reason);
    } catch (const InputError& error) {
      return answer(400, error.what());
    } catch (const TransportError& error) {
      return answer(504, error.what());
    }
  }

  CallOutcome outcome_of(const PageCommand& command) {
    if (command.what == "jog") return jogs.jog(command.axis, command.value, command.hold);
    if (command.what == "release") {
      jogs.release(command.axis, command.hold);
      return {};
    }
    const auto link = make_link();
    return give(*link, command, options.key);
  }

  const PanelOptions options;
  const MakeLink make_link;
  Jogs jogs;
  std::unique_ptr<Transport> ears;  // link of the listener thread
  Rejects rejects;                  // likewise
  std::mutex mutex;                 // guards the changing parts of the board
  Board board;
  std::optional<Server> server;
  std::atomic<bool> running{true};
  std::thread listener;
};

Panel::Panel(const PanelOptions& options, Listening listening, MakeLink make_link)
    : impl_(std::make_unique<Impl>(options, std::move(listening), std::move(make_link))) {}
Panel::~Panel() = default;

std::string Panel::address() const {
  return "http://127.0.0.1:" + std::to_string(impl_->server->port()) + "/#" + impl_->options.token;
}

}  // namespace jounce::web
