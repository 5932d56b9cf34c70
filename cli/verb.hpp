#pragma once

#include <functional>
#include <string>

#include <CLI/CLI.hpp>

namespace jounce::cli {

/// Exit statuses, the same in every verb.
enum Exit : int {
  fine = 0,
  finding = 1,    ///< a limit is broken, a validation failed, the problem is infeasible
  bad_input = 2,  ///< or bad usage
  fault = 3,      ///< of the machine or of Jounce itself
};

/// What the chosen verb will do once the command line is understood; answers the exit status.
using Work = std::function<int()>;

/// Adds a verb: its options, its help with an example, and what it does.
void add_new(CLI::App& app, Work& work);
void add_laws(CLI::App& app, Work& work);
void add_design(CLI::App& app, Work& work);
void add_check(CLI::App& app, Work& work);
void add_convert(CLI::App& app, Work& work);
void add_diff(CLI::App& app, Work& work);
void add_optimize(CLI::App& app, Work& work);
void add_validate(CLI::App& app, Work& work);
void add_sweep(CLI::App& app, Work& work);
void add_identify(CLI::App& app, Work& work);
void add_contour(CLI::App& app, Work& work);
void add_plot(CLI::App& app, Work& work);
void add_map(CLI::App& app, Work& work);
void add_events(CLI::App& app, Work& work);
void add_report(CLI::App& app, Work& work);
void add_stream(CLI::App& app, Work& work);
void add_master(CLI::App& app, Work& work);
void add_stop(CLI::App& app, Work& work);
void add_order(CLI::App& app, Work& work);
void add_run(CLI::App& app, Work& work);
void add_monitor(CLI::App& app, Work& work);
void add_replay(CLI::App& app, Work& work);

/// A verb with its one-line description and the example that closes its --help.
CLI::App* add_verb(CLI::App& app, const char* name, const char* description, const char* example);

/// Throws InputError where both are one file: what is made must not replace what it is made from.
void require_other_file(const std::string& input, const std::string& output);

/// --axis NAME, for specs of several axes.
void add_axis_option(CLI::App* verb, std::string& axis);

}  // namespace jounce::cli
