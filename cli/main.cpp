#include <algorithm>
#include <exception>
#include <span>
#include <system_error>

#include <fmt/format.h>

#include "jounce/io/nearest.hpp"
#include "jounce/io/table_file.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/transport.hpp"

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

/// What was wrong with the command line, with the nearest verb or option where one is near.
std::string complaint(const CLI::App& app, const CLI::ParseError& error, std::span<char*> words) {
  std::vector<std::string> verbs;
  for (const auto* verb : app.get_subcommands({})) verbs.push_back(verb->get_name());
  const std::string given = words.size() > 1 ? words[1] : "";
  if (given.empty()) return "no verb given";
  const auto ask = [](const std::string& near) {
    return near.empty() ? "" : ". Did you mean " + near + "?";
  };
  const bool is_verb = std::find(verbs.begin(), verbs.end(), given) != verbs.end();
  if (!is_verb && given[0] != '-')
    return "`" + given + "` is not a verb" + ask(nearest(given, verbs));

  std::vector<std::string> options;
  for (const auto* option : (is_verb ? app.get_subcommand(given) : &app)->get_options())
    for (const auto& name : option->get_lnames()) options.push_back("--" + name);
  for (const std::string word : words.subspan(is_verb ? 2 : 1)) {
    const std::string name = word.substr(0, word.find('='));
    if (!name.starts_with("--") || std::find(options.begin(), options.end(), name) != options.end())
      continue;
    return "`" + name + "` is not an option here" + ask(nearest(name, options));
  }
  return error.what();
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
  for (const auto add : {add_new, add_laws, add_design, add_check, add_optimize, add_sweep, add_validate,
                         add_identify, add_diff, add_convert, add_plot, add_map, add_events, add_contour,
                         add_report, add_stream, add_master, add_run, add_replay, add_monitor, add_stop, add_order})
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
    const std::span<char*> words(argv, static_cast<std::size_t>(argc));
    fmt::print(stderr, "jounce: {} (jounce --help shows all)\n", complaint(app, error, words));
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
  } catch (const jounce::TransportError& error) {
    fmt::print(stderr, "jounce: {}\n", error.what());
    return fault;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "jounce: there is not enough memory for this\n");
    return fault;
  } catch (const std::system_error& error) {
    fmt::print(stderr, "jounce: {}\n", error.what());
    return fault;
  } catch (const std::exception& error) {
    fmt::print(stderr, "jounce: internal fault: {}\n", error.what());
    return fault;
  }
}
