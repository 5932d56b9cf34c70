#include "verb.hpp"

#include <filesystem>
#include <system_error>

#include "jounce/profiles/error.hpp"

namespace jounce::cli {

CLI::App* add_verb(CLI::App& app, const char* name, const char* description, const char* example) {
  CLI::App* verb = app.add_subcommand(name, description);
  std::string lines = std::string("Example:\n") + example;
  for (std::size_t at = 0; (at = lines.find('\n', at)) != std::string::npos; at += 3)
    lines.insert(at + 1, "  ");
  verb->footer(lines);
  return verb;
}

void add_axis_option(CLI::App* verb, std::string& axis) {
  verb->add_option("--axis", axis, "NAME: this axis only, of a spec with several");
}

void require_other_file(const std::string& input, const std::string& output) {
  std::error_code none;  // a file that is not there is another one
  if (input != "-" && output != "-" && std::filesystem::equivalent(input, output, none))
    throw InputError("--output", output,
                     "is the input: it would be replaced by what is made from it");
}

}  // namespace jounce::cli
