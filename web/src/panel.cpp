// SPDX-License-Identifier: Apache-2.0
#include "jounce/web/panel.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>
#include <utility>
#include <variant>

#include <nlohmann/json.hpp>

#include "jounce/base/detail/listed.hpp"
#include "jounce/base/input_errors.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/sender/driver.hpp"
#include "jounce/stream/sender/operate.hpp"
#include "jounce/web/server.hpp"

#include "web/src/board.hpp"
#include "web/src/page.hpp"
#include "web/src/page_command.hpp"
#include "web/src/scope.hpp"
#include "web/src/word_order.hpp"

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
        board(options.axes),
        boots(options.axes.size()),
        seen_ticks(options.axes.size(), -1) {
    if (!options.trace)
      own.emplace(Trace::of(std::vector<std::int64_t>(options.axes.size(), 1'000'000)));
    open_ears();
    server.emplace(std::move(listening), options.token,
                   Site{.files = files_of(page(options.title, options.warning)),
                        .commands = {"POST /order", "POST /command"},
                        .readings = {"/trace", "/path", "/tables", "/commands"},
                        .event = [this](std::int64_t& seen) { return event(seen); },
                        .obey = [this](const Request& request) { return obey(request); },
                        .urgent = [](const Request& request) { return is_stop(request); },
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
      for (const auto lane : {wire::Lane::status, wire::Lane::masters, wire::Lane::group})
        ears->subscribe(wire::channel(axis, lane), waiting_statuses);
  }

  /// Runs until the end, in any state of the link: the page shows for how long each axis has been
  /// silent.
  void listen() {
    while (running) {
      try {
        if (!ears) open_ears();
        take_next();
        take_ticks();
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
    if (const auto* const status = std::get_if<wire::Status>(&message->body)) {
      board.take(message->executor, *status, steady_now());
      if (own && board.has(message->executor)) trace_status(message->executor, *status);
    } else if (const auto* const master = std::get_if<wire::MasterStatus>(&message->body))
      board.take(message->executor, *master);
    else if (const auto* const group = std::get_if<wire::GroupStatus>(&message->body))
      board.take(message->executor, *group);
  }

  [[nodiscard]] const Trace& trace() const { return own ? *own : *options.trace; }

  std::size_t index_of(const std::string& axis) const {
    const auto at = std::find(options.axes.begin(), options.axes.end(), axis);
    if (at == options.axes.end())
      throw InputError("axis", axis,
                       (axis.empty() ? "is missing: give one of "
                                     : "is not an axis or group of this page, which has ") +
                           listed(options.axes));
    return static_cast<std::size_t>(at - options.axes.begin());
  }

  /// A status message as a tick of the trace.
  void trace_status(const std::string& name, const wire::Status& status) {
    const std::size_t axis = index_of(name);
    if (std::exchange(boots[axis], status.boot) != status.boot) {
      own->clear(axis);
      seen_ticks[axis] = -1;
    }
    if (const auto newest = own->newest(axis); newest && status.tick <= *newest) return;
    own->set_period(axis, status.cycle_ns);
    own->add(axis, {.tick = status.tick,
                    .values = {status.slave_position, status.actual_position,
                               status.following_error, status.slave_velocity, wire::Status::unknown,
                               status.torque, status.master_position, wire::Status::unknown},
                    .state = status.state,
                    .fault = static_cast<Cause>(status.last_error),
                    .reason = static_cast<Cause>(status.reason)});
  }

  /// Adds the new ticks of all axes to the list of events.
  void take_ticks() {
    for (std::size_t axis = 0; axis < options.axes.size(); ++axis) {
      const auto newest = trace().newest(axis);
      if (!newest || *newest == seen_ticks[axis]) continue;
      const auto ticks = trace().ticks(axis, seen_ticks[axis] + 1, *newest);
      seen_ticks[axis] = *newest;
      const std::scoped_lock lock(mutex);
      board.take(options.axes[axis], ticks, trace().period(axis));
    }
  }

  std::string event(std::int64_t& seen) {
    const std::scoped_lock lock(mutex);
    return board.json_since(seen, steady_now());
  }

  static bool is_stop(const Request& request) {
    if (request.path != "/order") return false;
    const std::string& body = request.body;
    try {
      const std::string what = read_command(body).what;
      return what == "stop" || what == "release";
    } catch (const InputError&) {
      return false;
    }
  }

  Answer obey(const Request& request) {
    try {
      if (request.path == "/trace")
        return {200,
                scope_json(trace(), index_of(request.value("axis")), scope_query(request), !own)};
      if (request.path == "/path")
        return {200, path_json(trace(), index_of(request.value("axis")), request)};
      if (request.path == "/tables") return {200, tables_json(trace(), options.axes)};
      if (request.path == "/commands") return {200, word_orders_json()};
      const CallOutcome outcome = request.path == "/command" ? outcome_of_words(request.body)
                                                             : outcome_of_order(request.body);
      return answer(outcome.ok()                            ? 200
                    : outcome.error == StreamError::refused ? 409
                                                            : 504,
                    outcome.reason);
    } catch (const InputError& error) {
      return answer(400, all_sentences(error, ""));
    } catch (const TransportError& error) {
      return answer(504, error.what());
    }
  }

  CallOutcome outcome_of_words(const std::string& body) {
    const WordOrder order = read_word_order(body);
    index_of(order.axis);
    std::optional<Units> units;
    wire::GroupStatus group;
    {
      const std::scoped_lock lock(mutex);
      units = board.units(order.axis);
      group = board.group(order.axis);
    }
    if (!units) throw TransportError(order.axis + " has sent no message yet");
    const auto link = make_link();
    const ClientCommand command = command_of(order.words, *units, group.axes, group.units);
    return send_command(*link, order.axis, command, -1, options.key);
  }

  CallOutcome outcome_of_order(const std::string& body) {
    const PageCommand command = read_command(body);
    index_of(command.axis);
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
  std::optional<Trace> own;         // from status messages, if there is no trace of the executor
  std::unique_ptr<Transport> ears;  // link of the listener thread
  Rejects rejects;                  // likewise
  std::mutex mutex;                 // guards the changing parts of the board
  Board board;
  std::vector<std::int64_t> boots;       // from the last status of each axis; by the listener
  std::vector<std::int64_t> seen_ticks;  // newest tick of each axis in the log; by the listener
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
