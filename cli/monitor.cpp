#include <chrono>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "jounce/executor/cause.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/driver.hpp"

#include "link.hpp"
#include "verb.hpp"

namespace jounce::cli {
namespace {

struct Options {
  std::string executor;
  LinkOptions link;
  double seconds = 0;
  double silence = 3;
  bool json = false;
};

void print_line(const wire::Status& s, bool terminal) {
  fmt::print(
      "{}{:<9} tick {:<10} master {:<12.6g} position {:<12.6g} velocity {:<12.6g} late {}{}{}",
      terminal ? "\r\x1b[K" : "", name(s.state), s.tick, s.master_position, s.slave_position,
      s.slave_velocity, s.late_ticks,
      s.last_error == 0 ? "" : fmt::format("  {}", name(static_cast<Cause>(s.last_error))),
      terminal ? "" : "\n");
  std::fflush(stdout);
}

void print_json(const wire::Status& s) {
  const nlohmann::ordered_json line{{"state", name(s.state)},       {"tick", s.tick},
                                    {"master", s.master_position},  {"position", s.slave_position},
                                    {"velocity", s.slave_velocity}, {"late", s.late_ticks},
                                    {"error", s.last_error}};
  fmt::print("{}\n", line.dump());
  std::fflush(stdout);
}

int run(const Options& options) {
  if (!wire::is_executor_name(options.executor))
    throw InputError("NAME", options.executor, "must be 1 to 23 of A-Z a-z 0-9 _ -");
  Link link(options.link);
  link.transport().subscribe(wire::channel(options.executor, wire::Lane::status), 1);
  const bool terminal = isatty(STDOUT_FILENO) != 0 && !options.json;
  const Nanos begun = steady_now();
  Nanos heard = begun;
  while (options.seconds == 0 || steady_now() - begun < nanos(options.seconds)) {
    const auto message = next_status(link.transport(), options.executor,
                                     std::chrono::milliseconds(100), steady_now, link.key());
    const auto* status = message ? std::get_if<wire::Status>(&message->body) : nullptr;
    if (status != nullptr) {
      heard = steady_now();
      options.json ? print_json(*status) : print_line(*status, terminal);
    } else if (steady_now() - heard > nanos(options.silence)) {
      fmt::print(stderr,
                 "{}jounce: {} has been silent for {} s: is it running, on the same --url, with "
                 "the same --key?\n",
                 terminal ? "\n" : "", options.executor, options.silence);
      return fault;
    }
  }
  if (terminal) fmt::print("\n");
  return fine;
}

}  // namespace

void add_monitor(CLI::App& app, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* verb = add_verb(app, "monitor", "Show what an executor is doing now",
                            "jounce monitor feeder --seconds 10");
  verb->add_option("NAME", options->executor, "Name of the executor")->required();
  verb->add_option("--seconds", options->seconds,
                   "End after so many seconds; otherwise with Ctrl-C")
      ->check(seconds_option());
  verb->add_option("--silence", options->silence,
                   "Give up when nothing is heard for so many seconds")
      ->check(seconds_option())
      ->capture_default_str();
  add_link_options(*verb, options->link);
  verb->add_flag("--json", options->json, "A line of JSON for each status");
  verb->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace jounce::cli
