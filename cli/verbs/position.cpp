// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <fmt/format.h>

#include "jounce/machine/detail/group_position.hpp"

#include "cli/common/verb.hpp"

namespace jounce::cli {

void add_position(CommandLine& line) {
  struct Arguments {
    std::string file, group;
    std::vector<std::string> values;
    bool json = false;
  };
  const auto options = std::make_shared<Arguments>();
  const Verb verb =
      line.verb("position", "Convert a position between the tool and the joints of a machine",
                "jounce position machine.toml x=300 y=250 z=0\n"
                "jounce position machine.toml a0=10 a1=90 z_joint=0");
  verb.option("FILE", options->file, "Spec of kind machine, with a [[group]] with kinematics")
      .required();
  verb.option("VALUE", options->values, "All coordinates of the tool (x=300mm), or all joints")
      .required();
  verb.option("--group", options->group, "Name of the group, if the machine has several");
  verb.flag("--json", options->json, "Positions as JSON");
  verb.work([options] {
    const auto found = converted_position(options->file, options->group, options->values);
    fmt::print("{}\n", options->json ? found.json() : found.text());
    return found.inside() ? fine : finding;
  });
}

}  // namespace jounce::cli
