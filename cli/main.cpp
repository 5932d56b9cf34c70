#include <exception>
#include <system_error>

#include <fmt/format.h>

#include "jounce/io/nearest.hpp"
#include "jounce/io/table_file.hpp"
#include "jounce/profiles/error.hpp"

#include "verb.hpp"

namespace jounce::cli {
namespace {

/// Help for people: a wide enough column, no type names in capitals beside every option.
class Help : public CLI::Formatter {
 public:
  Help() { column_width(34); }
  std::string make_option_opts(const CLI::Option* option) const override {
    std::string text;
    if (option->get_required()) return text;
    if (!option->get_default_str().empty()) text += " [" + option->get_default_str() + "]";
    return text;
  }
};

/// "jounce chek": the nearest verb or option, where one is near.
std::string hint(const CLI::App& app, int argc, char** argv) {
  std::vector<std::string> known;
  const CLI::App* scope = &app;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    known.clear();
    if (word.starts_with("--"))
      for (const auto* option : scope->get_options())
        for (const auto& name : option->get_lnames()) known.push_back("--" + name);
    else if (scope == &app)
      for (const auto* verb : app.get_subcommands({})) known.push_back(verb->get_name());
    const bool found =
        std::find(known.begin(), known.end(), word.substr(0, word.find('='))) != known.end();
    if (found && scope == &app && !word.starts_with("--")) scope = app.get_subcommand(word);
    const std::string near = found ? "" : nearest(word, known);
    if (!near.empty()) return " Did you mean " + near + "?";
  }
  return "";
}

int run(int argc, char** argv) {
  CLI::App app("Design, check, optimise, prove and play motion tables.", "jounce");
  app.formatter(std::make_shared<Help>());
  app.set_version_flag("--version", made_by());
  app.require_subcommand(1);
  app.footer(
      "Files are named as arguments; - is standard input or output, so verbs pipe.\n"
      "Exit status: 0 fine, 1 a finding, 2 bad input or usage, 3 a fault of the machine.\n"
      "jounce VERB --help shows an example of each verb.");
  Work work;
  for (const auto add : {add_new, add_design, add_check, add_optimize, add_validate, add_plot,
                         add_report, add_stream, add_run, add_monitor, add_stop})
    add(app, work);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", app.help());
    return fine;
  } catch (const CLI::CallForVersion&) {
    fmt::print("{}\n", made_by());
    return fine;
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "jounce: {}.{} See --help.\n", error.what(), hint(app, argc, argv));
    return bad_input;
  }
  return work();
}

}  // namespace
}  // namespace jounce::cli

int main(int argc, char** argv) {
  using namespace jounce::cli;
  try {
    return run(argc, argv);
  } catch (const jounce::InputError& error) {
    fmt::print(stderr, "jounce: {}\n", error.what());
    return bad_input;
  } catch (const std::system_error& error) {
    fmt::print(stderr, "jounce: {}\n", error.what());
    return fault;
  } catch (const std::exception& error) {
    fmt::print(stderr, "jounce: internal fault: {}\n", error.what());
    return fault;
  }
}
