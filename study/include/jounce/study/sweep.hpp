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
  broken,      ///< a limit; the figures are there
  impossible,  ///< nothing can be made of these numbers; no figures
};

struct SweepRow {
  std::size_t number = 0;       ///< number of the case, from 0
  std::vector<double> figures;  ///< in the order of SweepSpec::given; NaN where impossible
  Verdict verdict = Verdict::impossible;
  std::string why = {};  ///< unless within: the worst limit, or why nothing could be made
};

/// Makes one case and looks at it. Invalid numbers are a result, not an exception.
/// Threads may call it at once.
SweepRow evaluated(const SweepSpec& spec, std::size_t number);

/// A row as one line of text and back, every number in full: what journals and messages are made of.
/// Nothing for a text that is no row of this sweep.
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

/// On threads of this process, each of which takes the next case; 0: as many as there are cores.
Farm on_threads(unsigned jobs = 0);

struct SweepOptions {
  Farm farm = on_threads();
  std::string journal = {};  ///< a file to go on from, and to keep for that; "": none
  /// After each case: how many are done, of all; false stops. May be left out.
  std::function<bool(std::size_t done, std::size_t cases)> keep_going = {};
};

struct SweepResult {
  std::vector<SweepRow> rows;  ///< by number; all of them unless stopped
  std::size_t resumed = 0;     ///< that the journal had
  std::size_t evaluated = 0;
  bool complete = false;
};

/// Runs a sweep; the rows are the same for every process and order.
///
///     const SweepSpec spec = read_sweep("sweep.toml");
///     const SweepResult result = run_sweep(spec, {.journal = "results.csv.journal"});
///     if (!result.complete) ...                                // stopped: the same call goes on
///
/// **The journal** has a line for each case as soon as it is made, so that a killed run goes on where
/// it was: what is in it is not made again. A last line that was torn is made again. Throws InputError
/// for a journal of another sweep, spec or program, and while another process works on it.
SweepResult run_sweep(const SweepSpec& spec, const SweepOptions& options = {});

}  // namespace jounce
