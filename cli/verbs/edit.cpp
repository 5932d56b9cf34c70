// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <memory>
#include <thread>

#include <fmt/format.h>

#include "jounce/base/detail/interrupt.hpp"
#include "jounce/edit/editor.hpp"

#include "cli/common/templates.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct EditArguments {
  std::string spec;
  int port = 0;
};

int run_edit(const EditArguments& options) {
  const Interrupt interrupt;
  const Editor editor(options.spec, web::Listening(static_cast<std::uint16_t>(options.port)),
                      templates());
  fmt::print(stderr, "jounce: editor of {} at {}\n", options.spec, editor.address());
  while (!interrupt.asked()) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  if (!editor.is_saved())
    fmt::print(stderr, "jounce: the unsaved text is in {}; `jounce edit {}` continues with it\n",
               editor.side_file(), options.spec);
  return fine;
}

}  // namespace

void add_edit(CommandLine& line) {
  const auto options = std::make_shared<EditArguments>();
  const Verb verb = line.verb(
      "edit", "Edit a spec of any kind in a browser: curves with the mouse, text beside them",
      "jounce edit cam.toml");
  verb.option("SPEC", options->spec,
              "Spec to edit; if it does not exist, the page offers examples to start from")
      .required();
  verb.option("--port", options->port, "Port on 127.0.0.1; 0: any free port")
      .check(whole(0, 65535))
      .shown();
  verb.work([options] { return run_edit(*options); });
}

}  // namespace jounce::cli
