// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "jounce/study/sweep_spec.hpp"

namespace jounce {

/// Result of a case.
enum class Verdict {
  within,      ///< all limits of the spec and of the sweep
  broken,      ///< a limit is broken; the figures exist
  impossible,  ///< nothing can be made of these numbers; no figures
};

struct SweepRow {
  std::size_t number = 0;       ///< number of the case, from 0
  std::vector<double> figures;  ///< in the order of SweepSpec::given; NaN if impossible
  Verdict verdict = Verdict::impossible;
  std::string why = {};  ///< unless within: the worst limit, or why the case is impossible
};

/// Makes and assesses one case. Invalid numbers are a result, not an exception. Thread-safe.
SweepRow evaluated(const SweepSpec& spec, std::size_t number);

/// A row as one line of text and back, every number in full, for journals and messages. Nothing for
/// a text that is not a row of this sweep.
std::string line_of(const SweepRow& row);
std::optional<SweepRow> row_of(const std::string& line, const SweepSpec& spec);

/// Returns the line of a case. Called by several threads at once.
using MakeLine = std::function<std::string(std::size_t number)>;

/// Takes a case's line; false: no more is wanted. Called by one thread at a time.
using TakeLine = std::function<bool(std::size_t number, const std::string& line)>;

/// Makes and takes all these cases, in any order. Returns after the last, or when `take` returns false.
/// An exception of `make` ends the work and is rethrown.
using Farm =
    std::function<void(const std::vector<std::size_t>& numbers, const MakeLine&, const TakeLine&)>;

/// A farm of threads in this process, each of which takes the next case. `jobs` = 0: one thread for
/// each core.
Farm on_threads(unsigned jobs = 0);

struct SweepOptions {
  Farm farm = on_threads();
  std::string journal = {};  ///< the file to resume from and to keep up to date; "": none
  /// Called after each case with the number done and the total; false stops. Optional.
  std::function<bool(std::size_t done, std::size_t cases)> keep_going = {};
};

struct SweepResult {
  std::vector<SweepRow> rows;  ///< by number; all of them unless stopped
  std::size_t resumed = 0;     ///< number of rows from the journal
  std::size_t evaluated = 0;
  bool complete = false;
};

/// Runs a sweep; the rows are the same for every process and order.
///
///     const SweepSpec spec = read_sweep("sweep.toml");
///     const SweepResult result = run_sweep(spec, {.journal = "results.csv.journal"});
///     if (!result.complete) ...                                // stopped: the same call resumes
///
/// **The journal** gets a line for each case as soon as it is made, so a killed run resumes: the
/// cases in it are not made again. The case of an incomplete last line is. Throws InputError for a
/// journal of another sweep, spec or program, and while another process works on it.
SweepResult run_sweep(const SweepSpec& spec, const SweepOptions& options = {});

}  // namespace jounce
