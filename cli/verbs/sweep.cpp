// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <thread>

#include <fmt/format.h>

#include "jounce/base/detail/interrupt.hpp"
#include "jounce/base/detail/progress_line.hpp"
#include "jounce/base/hash.hpp"
#include "jounce/plot/sweep_figure.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/study/detail/mpi_world.hpp"
#include "jounce/study/detail/sweep_files.hpp"
#include "jounce/study/detail/sweep_summary.hpp"

#include "cli/common/outputs.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct SweepArguments {
  std::string file;
  SweepFiles files;
  std::string plot;
  unsigned jobs = 0;
  bool json = false;
};

std::FILE* stream_of(const SweepArguments& options) {
  return text_stream(options.json, {options.files.csv, options.files.npy, options.plot});
}

SweepResult worked_through(const SweepSpec& spec, const SweepArguments& options, const Farm& farm) {
  const Interrupt interrupt;
  ProgressLine progress("sweep");
  SweepClock clock;
  return run_sweep(spec, {.farm = farm,
                          .journal = options.files.journal(),
                          .keep_going = [&](std::size_t done, std::size_t cases) {
                            progress.show(static_cast<double>(done) / static_cast<double>(cases),
                                          clock.text(done, cases));
                            return !interrupt.asked();
                          }});
}

int report(const SweepSpec& spec, const SweepResult& result, const SweepArguments& options) {
  if (!result.complete) {
    fmt::print(stderr, "jounce: {}\n", stopped_text(options.files, spec, result));
    return finding;
  }
  const SweepSummary summary = summary_of(spec, result);
  write_sweep(options.files, spec, result);
  if (!options.plot.empty())
    write_picture(options.plot, sweep_figure(spec, result, summary), spec.document.all_files(),
                  sweep_look(spec));
  if (const std::string journal = options.files.journal(); !journal.empty())
    std::remove(journal.c_str());
  fmt::print(stream_of(options), "{}",
             options.json ? summary_json(spec, result, summary) + "\n"
                          : summary_text(spec, result, summary));
  return summary.within > 0 ? fine : finding;
}

int run_here(const SweepArguments& options) {
  (void)stream_of(options);
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
  for (const std::string& output : {options.files.csv, options.files.npy, options.plot})
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
  verb.option("-o,--output", options->files.csv,
              "Table of all cases to write, CSV. After an interruption, the same command "
              "continues, from a journal that is written beside the table")
      .check(output_file({".csv"}));
  verb.option("--npy", options->files.npy, "The same table as a structured array for NumPy (.npy)")
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
