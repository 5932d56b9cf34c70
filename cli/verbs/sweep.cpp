// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <thread>

#include <fmt/format.h>

#include "jounce/base/file.hpp"
#include "jounce/base/hash.hpp"
#include "jounce/plot/sweep_figure.hpp"
#include "jounce/profiles/six_digits.hpp"
#include "jounce/study/mpi_world.hpp"
#include "jounce/study/sweep_files.hpp"
#include "jounce/study/sweep_summary.hpp"

#include "cli/common/interrupt.hpp"
#include "cli/common/outputs.hpp"
#include "cli/common/progress.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct SweepArguments {
  std::string file;
  std::string output;
  std::string npy;
  std::string plot;
  unsigned jobs = 0;
  bool json = false;
};

/// The journal, beside the first file that is written; "" if none is.
std::string journal_of(const SweepArguments& options) {
  for (const std::string& path : {options.output, options.npy})
    if (!path.empty() && path != "-") return path + ".journal";
  return "";
}

SweepResult worked_through(const SweepSpec& spec, const SweepArguments& options, const Farm& farm) {
  const Interrupt interrupt;
  Progress progress("sweep");
  SweepClock clock;
  return run_sweep(spec, {.farm = farm,
                          .journal = journal_of(options),
                          .keep_going = [&](std::size_t done, std::size_t cases) {
                            progress.show(static_cast<double>(done) / static_cast<double>(cases),
                                          clock.text(done, cases));
                            return !interrupt.asked();
                          }});
}

int stopped(const SweepSpec& spec, const SweepResult& result, const SweepArguments& options) {
  const std::string journal = journal_of(options);
  fmt::print(stderr, "jounce: stopped after {} of {} cases; {}\n", result.rows.size(), spec.cases(),
             journal.empty() ? "with -o, the same command would continue from there"
                             : "continue with the same command (" + journal + ")");
  return finding;
}

/// A Pareto front gets high panels, as its points are read one by one.
SvgOptions look(const SweepSpec& spec) {
  SvgOptions options;
  if (spec.objectives.size() == 2) options.panel_height = 320;
  return options;
}

int report(const SweepSpec& spec, const SweepResult& result, const SweepArguments& options) {
  if (!result.complete) return stopped(spec, result, options);
  const SweepSummary summary = summary_of(spec, result);
  std::vector<Output> files;
  if (!options.output.empty()) files.push_back({options.output, to_csv(spec, result)});
  if (!options.npy.empty()) files.push_back({options.npy, to_npy(spec, result)});
  write_files(files);
  if (!options.plot.empty())
    write_picture(options.plot, sweep_figure(spec, result, summary), look(spec));
  if (const std::string journal = journal_of(options); !journal.empty())
    std::remove(journal.c_str());
  fmt::print(text_stream({options.output, options.npy, options.plot}), "{}",
             options.json ? summary_json(spec, result, summary) + "\n"
                          : summary_text(spec, result, summary));
  return summary.within > 0 ? fine : finding;
}

int run_here(const SweepArguments& options) {
  const SweepSpec spec = read_sweep(options.file);
  return report(spec, worked_through(spec, options, on_threads(options.jobs)), options);
}

/// Every process reads the files; the first prints for all.
int run_under_mpi(const SweepArguments& options) {
  if (options.jobs != 0)
    throw InputError("--jobs", std::to_string(options.jobs),
                     "is for a single process: with mpirun, give the number of processes with -n");
  const MpiWorld world;
  try {
    if (world.size() == 1) return run_here(options);
    const SweepSpec spec = read_sweep(options.file);
    const Farm farm = world.farm(hex(spec.identity()));
    if (world.rank() == 0) return report(spec, worked_through(spec, options, farm), options);
    for (const int signal :
         {SIGINT, SIGTERM})  // the first process collects the current cases and stops all
      std::signal(signal, SIG_IGN);
    (void)run_sweep(spec, {.farm = farm});
    return fine;
  } catch (const std::exception& error) {
    // All processes find an error of the files. The first reports it; the others wait for that.
    if (world.rank() != 0) std::this_thread::sleep_for(std::chrono::seconds(1));
    fmt::print(stderr, "jounce: {}{}\n",
               world.rank() == 0 ? "" : fmt::format("rank {}: ", world.rank()), error.what());
    const bool input = dynamic_cast<const InputError*>(&error) != nullptr;
    std::fflush(stderr);
    world.abort(input ? bad_input : fault);
    return fault;
  }
}

int run_sweep(const SweepArguments& options) {
  for (const std::string& output : {options.output, options.npy, options.plot})
    if (!output.empty()) require_other_file(options.file, output);
  return mpi_place().started ? run_under_mpi(options) : run_here(options);
}

}  // namespace

void add_sweep(CommandLine& line) {
  const auto options = std::make_shared<SweepArguments>();
  const Verb verb = line.verb(
      "sweep", "Make variants of a spec and compare them: grids, tolerances, Pareto fronts",
      "jounce sweep sweep.toml -o results.csv --plot front.svg\nmpirun -n 4 jounce sweep "
      "sweep.toml -o results.csv");
  verb.option("SWEEP", options->file, "Sweep spec: the base spec, its parameters and their values")
      .required();
  verb.option("-o,--output", options->output,
              "Table of all cases to write, CSV. After an interruption, the same command "
              "continues, from a journal that is written beside the table")
      .check(output_file({".csv"}));
  verb.option("--npy", options->npy, "The same table as a structured array for NumPy (.npy)")
      .check(output_file({".npy"}));
  verb.option("--plot", options->plot,
              "Picture to write, .svg or .png: Pareto front, distributions, or figures over the "
              "parameter")
      .check(output_file({".svg", ".png"}));
  verb.option("--jobs", options->jobs, "Number of threads; default: one for each core")
      .check(whole(1, 4096));
  verb.flag("--json", options->json, "Summary as JSON, numbers with all digits");
  verb.work([options] { return run_sweep(*options); });
}

}  // namespace jounce::cli
