// SPDX-License-Identifier: Apache-2.0
#include "cli/machine/page.hpp"

#include <array>
#include <csignal>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "jounce/profiles/error.hpp"
#include "jounce/stream/transport/open_transport.hpp"
#include "jounce/web/gate.hpp"
#include "jounce/web/panel.hpp"

#include "cli/common/interrupt.hpp"
#include "cli/common/verb.hpp"
#include "cli/machine/link.hpp"
#include "cli/machine/open_network.hpp"
#include "cli/machine/page_process.hpp"

namespace jounce::cli {
namespace {

constexpr auto check_interval = std::chrono::milliseconds(100);

struct PageArguments {
  std::vector<std::string> axes;
  LinkOptions link;
  int port = 8080;
  double seconds = 0;
  bool of_run = false;
};

web::PanelOptions panel_of(const PageArguments& options, const Link& link, std::string token) {
  return {.axes = options.axes,
          .key = link.key(),
          .title = "Jounce",
          .token = std::move(token),
          .warning = is_open(options.link) ? std::string("Warning: ") + open_warning : ""};
}

/// Makes a page that `jounce run` has started less important than the executor: it has a lower priority, ends
/// with the executor, and is the first process to be killed if memory is short.
void give_way() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  setpriority(PRIO_PROCESS, 0, 10);
  std::ofstream("/proc/self/oom_score_adj") << 1000;
}

/// A line from standard input.
std::string line_in() {
  std::string line;
  for (char c = 0; line.size() < 256 && read(STDIN_FILENO, &c, 1) == 1 && c != '\n';) line += c;
  return line;
}

/// Until the other end of standard input is closed, as it is where the executor has ended, however it did.
void wait_for_end_of_input() {
  std::array<char, 256> dropped{};
  while (read(STDIN_FILENO, dropped.data(), dropped.size()) > 0) {
  }
}

int serve_for_run(const PageArguments& options) {
  give_way();
  const std::string token = line_in();
  if (token.empty()) return bad_input;
  const Link link(options.link);
  const web::Panel panel(panel_of(options, link, token), web::Listening::inherited(page_socket),
                         [&] { return open_transport(options.link.url); });
  wait_for_end_of_input();
  return fine;
}

int run_page(const PageArguments& options) {
  for (const std::string& axis : options.axes) require_name_on_bus("NAME", axis);
  if (options.of_run) return serve_for_run(options);
  const Interrupt interrupt;
  const Link link(options.link);
  if (is_open(options.link)) fmt::print(stderr, "jounce: warning: {}\n", open_warning);
  const web::Panel panel(panel_of(options, link, web::new_token()),
                         web::Listening(static_cast<std::uint16_t>(options.port)),
                         [&] { return open_transport(options.link.url); });
  fmt::print(stderr, "jounce: live page at {}\n", panel.address());
  const Nanos begin = steady_now();
  const auto in_time = [&] {
    return options.seconds == 0 || steady_now() - begin < nanos(options.seconds);
  };
  while (!interrupt.asked() && in_time()) std::this_thread::sleep_for(check_interval);
  return fine;
}

}  // namespace

void add_page(CommandLine& line) {
  const auto options = std::make_shared<PageArguments>();
  const Verb verb = line.verb(
      "page", "Serve a live web page of axes, from which a browser can also send commands",
      "jounce page feeder knife --port 8080\n"
      "jounce page feeder --url 'udpm://239.255.76.67:7667?ttl=1' --key line.key\n"
      "`jounce run --web` starts one beside its executor.");
  verb.option("NAME", options->axes, "Names of the executors to show").required();
  verb.option("--port", options->port, "Port on 127.0.0.1; 0: any free port")
      .check(whole(0, 65535))
      .shown();
  verb.option("--seconds", options->seconds,
              "End after this number of seconds; default: with Ctrl-C")
      .check(seconds());
  add_link_options(verb, options->link);
  verb.flag("--of-run", options->of_run, "Started by jounce run").hidden();
  verb.work([options] { return run_page(*options); });
}

}  // namespace jounce::cli
