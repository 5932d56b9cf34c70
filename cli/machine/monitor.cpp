// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/command/cause.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/sender/driver.hpp"

#include "cli/common/verb.hpp"
#include "cli/machine/dashboard.hpp"
#include "cli/machine/link.hpp"
#include "cli/machine/terminal.hpp"

namespace jounce::cli {
namespace {

constexpr int queue_capacity = 256;  // two statuses each of the most axes of a machine, and more
constexpr Nanos turn = std::chrono::milliseconds(50);

struct MonitorArguments {
  std::vector<std::string> executors;  // sorted; empty: all that send messages
  LinkOptions link;
  double seconds = 0;
  double silence = 3;
  bool ascii = false;
  bool json = false;
};

void print_line(const std::string& axis, const wire::Status& s) {
  fmt::print(
      "{:<12} {:<9} tick {:<10} master {:<12} position {:<12.6g} velocity {:<12.6g} late "
      "{}{}{}{}{}\n",
      axis, name(s.state), s.tick,
      std::isnan(s.master_position) ? "none" : fmt::format("{:.6g}", s.master_position),
      s.slave_position, s.slave_velocity, s.late_ticks, s.held ? "  held" : "",
      s.homed ? "  homed" : "",
      s.last_error == 0 ? "" : fmt::format("  {}", name(static_cast<Cause>(s.last_error))),
      s.unwritten == 0 ? "" : fmt::format("  not written: {}", unwritten_of(s.unwritten)));
  std::fflush(stdout);
}

void print_json(const std::string& axis, const wire::Status& s) {
  const nlohmann::ordered_json line{{"name", axis},
                                    {"state", name(s.state)},
                                    {"tick", s.tick},
                                    {"master", s.master_position},
                                    {"position", s.slave_position},
                                    {"velocity", s.slave_velocity},
                                    {"late", s.late_ticks},
                                    {"error", s.last_error},
                                    {"actual", s.actual_position},
                                    {"following_error", s.following_error},
                                    {"override", s.override_},
                                    {"progress", name(s.progress)},
                                    {"held", s.held},
                                    {"homed", s.homed},
                                    {"unwritten", unwritten_of(s.unwritten)},
                                    {"queue_rows", s.queue_rows}};
  fmt::print("{}\n", line.dump());
  std::fflush(stdout);
}

void print_line(const std::string& axis, const wire::MasterStatus& m) {
  fmt::print("{:<12} master    tick {:<10} {}\n", axis, m.tick, said_of(m, true));
  std::fflush(stdout);
}

void print_json(const std::string& axis, const wire::MasterStatus& m) {
  const nlohmann::ordered_json line{
      {"name", axis},     {"master_name", m.master}, {"unit", m.unit},         {"tick", m.tick},
      {"lost", m.lost},   {"position", m.position},  {"velocity", m.velocity}, {"age", m.age_s},
      {"taken", m.taken}, {"refused", m.refused}};
  fmt::print("{}\n", line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  std::fflush(stdout);
}

/// Receives the statuses of the requested executors.
class Ear {
 public:
  explicit Ear(const MonitorArguments& options) : options_(options), link_(options.link) {
    for (const std::string& name : options.executors) {
      for (const auto lane : {wire::Lane::status, wire::Lane::masters})
        link_.transport().subscribe(wire::channel(name, lane), queue_capacity);
      axes_.push_back({.name = name});
    }
    for (const auto lane : {wire::Lane::status, wire::Lane::masters})
      if (options.executors.empty())
        link_.transport().subscribe(wire::channel("*", lane), queue_capacity);
  }

  /// Hands each status that comes within a turn to `take`, of an axis and of a master.
  template <class Take>
  void listen(Take take) {
    const Nanos end = steady_now() + turn;
    for (Nanos left = turn; left > Nanos{}; left = end - steady_now()) {
      const auto message = next_message(link_.transport(), left, rejects_, link_.key());
      if (!message || !wanted(message->executor)) continue;
      if (const auto* status = std::get_if<wire::Status>(&message->body)) {
        hear(axes_, message->executor, *status, steady_now());
        take(message->executor, *status);
      } else if (const auto* master = std::get_if<wire::MasterStatus>(&message->body)) {
        hear(axes_, message->executor, *master);
        take(message->executor, *master);
      }
    }
  }

  /// A sentence on what has sent no message for too long: a named axis, or all; empty: nothing.
  [[nodiscard]] std::string silent() const {
    const Nanos now = steady_now();
    Nanos last = begun_;
    for (const Watched& axis : axes_) {
      const Nanos heard = std::max(begun_, axis.heard);
      if (!options_.executors.empty() && now - heard > nanos(options_.silence)) return axis.name;
      last = std::max(last, heard);
    }
    return now - last > nanos(options_.silence) ? "every executor" : "";
  }

  [[nodiscard]] bool heard_any() const {
    return std::any_of(axes_.begin(), axes_.end(),
                       [](const auto& a) { return a.status.has_value(); });
  }
  [[nodiscard]] bool in_time() const {
    return options_.seconds == 0 || steady_now() - begun_ < nanos(options_.seconds);
  }
  [[nodiscard]] const std::vector<Watched>& axes() const { return axes_; }
  [[nodiscard]] Link& link() { return link_; }

 private:
  [[nodiscard]] bool wanted(const std::string& name) const {
    return options_.executors.empty() ||
           std::binary_search(options_.executors.begin(), options_.executors.end(), name);
  }

  const MonitorArguments& options_;
  Link link_;
  std::vector<Watched> axes_;
  Rejects rejects_;
  Nanos begun_ = steady_now();
};

int give_up(const std::string& who, const MonitorArguments& options) {
  fmt::print(stderr, "jounce: {} has sent no message for {} s: {}\n", who, options.silence,
             unheard_hint);
  return fault;
}

int print_all(Ear& ear, const MonitorArguments& options) {
  while (ear.in_time()) {
    ear.listen([&](const std::string& axis, const auto& status) {
      options.json ? print_json(axis, status) : print_line(axis, status);
    });
    if (const std::string who = ear.silent(); !who.empty()) return give_up(who, options);
  }
  return fine;
}

/// Sends the command of a key to the chosen axis. Returns its answer in a few words.
std::string tell(Ear& ear, const std::string& axis, Wish wish) {
  const char* const word = wish == Wish::stop ? "stop" : wish == Wish::hold ? "hold" : "resume";
  ClientCommand command = command::Hold{};
  if (wish == Wish::resume) command = command::Resume{};
  const wire::Body body =
      wish == Wish::stop ? wire::Body(wire::Stop{}) : wire::Body(wire::message_of(command));
  const wire::Reply reply = operator_command(ear.link().transport(), axis, body, ear.link().key(),
                                             std::chrono::seconds(1));
  if (reply.outcome == wire::Outcome::accepted) return fmt::format("{}: {} accepted", axis, word);
  if (reply.outcome == wire::Outcome::pending) return fmt::format("{}: {}: no answer", axis, word);
  return fmt::format(
      "{}: {} refused: {}", axis, word,
      reply.cause != 0 ? name(static_cast<Cause>(reply.cause)) : name(reply.refusal));
}

int watch(Ear& ear, const MonitorArguments& options) {
  Terminal terminal;
  View view{.ascii = options.ascii || !is_utf8(), .silence = nanos(options.silence)};
  while (ear.in_time()) {
    view.now = steady_now();
    terminal.measure(view);
    terminal.show(dashboard(ear.axes(), view));
    ear.listen([](const std::string& /*name*/, const auto& /*status*/) {});
    while (const auto key = terminal.key()) {
      const Wish wish = press(view, ear.axes(), *key);
      if (wish == Wish::quit) return fine;
      if (wish != Wish::nothing) view.note = tell(ear, view.chosen, wish);
    }
    // One that falls silent later is shown as such: it may come back.
    if (!ear.heard_any() && !ear.silent().empty()) return fault;
  }
  return fine;
}

int run_monitor(MonitorArguments options) {
  for (const std::string& name : options.executors) require_name_on_bus("NAME", name);
  std::sort(options.executors.begin(), options.executors.end());
  options.executors.erase(std::unique(options.executors.begin(), options.executors.end()),
                          options.executors.end());
  Ear ear(options);
  if (options.json || !is_screen()) return print_all(ear, options);
  const int status = watch(ear, options);
  return status == fault ? give_up(ear.silent(), options) : status;
}

}  // namespace

void add_monitor(CommandLine& line) {
  const auto options = std::make_shared<MonitorArguments>();
  const Verb verb = line.verb(
      "monitor", "Show the present state of executors",
      "jounce monitor                           all executors\n"
      "jounce monitor feeder knife\n"
      "jounce monitor feeder --seconds 10 --json > feeder.jsonl\n"
      "Keys: up and down choose an axis, h holds, r resumes, s and then y stops it, q quits.\n"
      "Output to a file or a pipe has one line for each status.");
  verb.option("NAME", options->executors, "Names of executors; default: all that send messages");
  verb.option("--seconds", options->seconds,
              "End after this number of seconds; default: with q or Ctrl-C")
      .check(seconds());
  verb.option("--silence", options->silence,
              "End when no message arrives for this number of seconds; on a terminal, only before "
              "the first message")
      .check(seconds())
      .shown();
  add_link_options(verb, options->link);
  verb.flag("--ascii", options->ascii, "Draw bars and plots in ASCII; default: by the locale");
  verb.flag("--json", options->json, "One line of JSON for each status");
  verb.work([options] { return run_monitor(*options); });
}

}  // namespace jounce::cli
