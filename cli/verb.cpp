#include "verb.hpp"

namespace jounce::cli {

CLI::App* add_verb(CLI::App& app, const char* name, const char* description, const char* example) {
  CLI::App* verb = app.add_subcommand(name, description);
  verb->footer(std::string("Example:\n  ") + example);
  return verb;
}

void add_axis_option(CLI::App* verb, std::string& axis) {
  verb->add_option("--axis", axis, "NAME: this axis only, of a spec with several");
}

}  // namespace jounce::cli
