// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "jounce/base/detail/interrupt.hpp"
#include "jounce/machine/watch.hpp"
#include "jounce/stream/transport/open_transport.hpp"
#include "jounce/web/gate.hpp"
#include "jounce/web/page_process.hpp"

#include "cli/common/verb.hpp"
#include "cli/machine/link.hpp"

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

web::PanelOptions panel_of(const PageArguments& options, const KeyedLink& link) {
  return {.axes = options.axes,
          .key = link.key(),
          .title = "Jounce",
          .token = web::new_token(),
          .warning = is_open(options.link) ? std::string("Warning: ") + unprotected_warning : ""};
}

int run_page(const PageArguments& options) {
  for (const std::string& axis : options.axes) require_name_on_bus("NAME", axis);
  const auto make_link = [&] { return open_transport(options.link.url); };
  if (options.of_run)
    return web::serve_for_parent(panel_of(options, open_link(options.link)), make_link) ? fine
                                                                                        : bad_input;
  const Interrupt interrupt;
  KeyedLink link = open_link(options.link);
  if (is_open(options.link)) fmt::print(stderr, "jounce: warning: {}\n", unprotected_warning);
  const web::Panel panel(panel_of(options, link),
                         web::Listening(static_cast<std::uint16_t>(options.port)), make_link);
  fmt::print(stderr, "jounce: live page at {}\n", panel.address());
  if (const std::string missing = dashboard::missing_text(link, options.axes); !missing.empty())
    fmt::print(stderr, "jounce: warning: {}\n", missing);
  for (const Duration duration(options.seconds); !interrupt.asked() && duration.goes_on();)
    std::this_thread::sleep_for(check_interval);
  return fine;
}

}  // namespace

void add_page(CommandLine& line) {
  const auto options = std::make_shared<PageArguments>();
  const Verb verb = line.verb(
      "page", "Serve a live web page of axes, from which a browser can also send commands",
      "jounce page feeder knife --port 8080\n"
      "jounce page feeder --url 'udpm://239.255.76.67:7667?ttl=1' --key line.key\n"
      "`jounce run --web` starts a page beside its executor.");
  verb.option("NAME", options->axes, "Names of the axes and groups to show").required();
  verb.option("--port", options->port, "Port on 127.0.0.1; 0: any free port")
      .check(whole(0, 65535))
      .shown();
  verb.option("--seconds", options->seconds,
              "End after this number of seconds; default: run until Ctrl-C")
      .check(seconds());
  add_link_options(verb, options->link);
  verb.flag("--of-run", options->of_run, "Started by jounce run").hidden();
  verb.work([options] { return run_page(*options); });
}

}  // namespace jounce::cli
