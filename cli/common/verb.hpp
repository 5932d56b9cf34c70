// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "jounce/about/option_target.hpp"
#include "jounce/about/value_check.hpp"

namespace jounce {
struct ProgramInfo;
}

namespace CLI {  // NOLINT(readability-identifier-naming): the name of a library
class App;
class Option;
}  // namespace CLI

/// The words of the command line: verbs, and the options that each takes.
///
///   const auto options = std::make_shared<Options>();
///   const Verb verb = line.verb("map", "How fast the line may run", "jounce map knife.toml");
///   verb.option("FILE", options->file, "Spec of a knife; - is standard input").required();
///   verb.option("--steps", options->steps, "Lengths").check(whole(2, 100'000));
///   verb.work([options] { return run(*options); });
///
/// The parser behind it (CLI11) stays in verb.cpp, command_line.cpp.
namespace jounce::cli {

/// Exit statuses, the same in every verb.
enum Exit : int {
  fine = 0,
  finding = 1,    ///< a limit is broken, a validation failed, the problem is infeasible
  bad_input = 2,  ///< or bad usage
  fault = 3,      ///< fault of the machine or of Jounce itself
};

/// Action of a verb after parsing the command line; returns the exit status.
using Work = std::function<int()>;

using checks::ends_in, checks::one_of, checks::output_file, checks::output_folder, checks::seconds,
    checks::seconds_or_none, checks::whole, checks::within;

/// Words that can be the value of an option, for the completion of the shell.
using Words = std::function<std::vector<std::string>()>;
using WordsOfOptions = std::map<const CLI::Option*, Words>;

/// An option of a verb, for further settings. Each call returns the same option.
class Option {
 public:
  Option(CLI::Option* option, WordsOfOptions& words) : option_(option), words_(&words) {}

  const Option& required() const;
  const Option& check(ValueCheck check) const;
  const Option& shown() const;      ///< --help names the value that it has where it is not given
  const Option& hidden() const;     ///< not in --help
  const Option& one_each() const;   ///< option of a list: one value each time it is given
  const Option& separated() const;  ///< option of a list: values between commas
  const Option& needs(const Option& other) const;
  const Option& excludes(const std::vector<Option>& others) const;
  const Option& completed_by(Words words) const;

 private:
  CLI::Option* option_;
  WordsOfOptions* words_;
};

/// A verb, while its options and its action are defined.
class Verb {
 public:
  Verb(CLI::App& verb, Work& chosen, WordsOfOptions& words)
      : verb_(&verb), chosen_(&chosen), words_(&words) {}

  /// A name without dashes is a positional.
  Option option(const std::string& name, OptionTarget target, const std::string& help) const;
  Option flag(const std::string& name, bool& target, const std::string& help) const;
  /// The option --axis NAME, for specs of several axes.
  Option axis(std::string& target) const;
  /// --over master or time, for a cam with a [master].
  Option over(std::string& target) const;
  /// --machine SPEC, for a G-code program.
  Option machine(std::string& target) const;

  void work(Work work) const;
  const Verb& hidden() const;  ///< not in --help

 private:
  CLI::App* verb_;
  Work* chosen_;
  WordsOfOptions* words_;
};

/// The command line of the program.
class CommandLine {
 public:
  CommandLine();
  ~CommandLine();

  /// Adds a verb. The examples stand at the end of its --help, one a line.
  Verb verb(const std::string& name, const std::string& description, const std::string& examples);

  /// Executes the command and returns the exit status. Prints help and errors.
  int run(int argc, char** argv);

  /// Its visible verbs and options, for manual pages and completion.
  [[nodiscard]] ProgramInfo info() const;

 private:
  std::unique_ptr<CLI::App> app_;
  Work chosen_;
  WordsOfOptions words_;
};

/// Each adds one verb: its options, its help with an example, and what it does.
void add_new(CommandLine& line);
void add_laws(CommandLine& line);
void add_explain(CommandLine& line);
void add_design(CommandLine& line);
void add_check(CommandLine& line);
void add_convert(CommandLine& line);
void add_diff(CommandLine& line);
void add_fit(CommandLine& line);
void add_optimize(CommandLine& line);
void add_validate(CommandLine& line);
void add_sweep(CommandLine& line);
void add_identify(CommandLine& line);
void add_inverse(CommandLine& line);
void add_contour(CommandLine& line);
void add_plot(CommandLine& line);
void add_map(CommandLine& line);
void add_position(CommandLine& line);
void add_events(CommandLine& line);
void add_report(CommandLine& line);
void add_edit(CommandLine& line);
void add_stream(CommandLine& line);
void add_master(CommandLine& line);
void add_stop(CommandLine& line);
void add_order(CommandLine& line);
void add_run(CommandLine& line);
void add_monitor(CommandLine& line);
void add_page(CommandLine& line);
void add_replay(CommandLine& line);
void add_completion(CommandLine& line);
void add_man(CommandLine& line);

}  // namespace jounce::cli
