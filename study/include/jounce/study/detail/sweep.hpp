// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "jounce/study/detail/sweep_spec.hpp"

namespace jounce {

/// Verdict on a case of a sweep.
enum class Verdict {
  within,      ///< within all limits of the spec and of the sweep
  broken,      ///< at least one limit is broken; the figures exist
  impossible,  ///< no motion is possible with these numbers; there are no figures
};

/// Result of one case of a sweep.
struct SweepRow {
  std::size_t number = 0;  ///< number of the case, from 0
  std::vector<double> figures =
      {};  ///< one for each of SweepSpec::given; NaN if the case is impossible
  Verdict verdict = Verdict::impossible;  ///< verdict on the case
  /// Empty for `within`; otherwise the limit that is broken most, or the reason why the case is
  /// impossible.
  std::string why = {};
};

/// Computes and judges one case. Invalid numbers give a row, not an exception. Several threads may
/// call this function.
SweepRow evaluated(const SweepSpec& spec, std::size_t number);

/// Returns a row as one line of text, with all digits of each number, for journals and messages.
std::string line_of(const SweepRow& row);
/// Reads a row from a line; nullopt if the text is not a row of this sweep.
std::optional<SweepRow> row_of(const std::string& line, const SweepSpec& spec);

/// Computes a case and returns its line. Several threads call it at the same time.
using MakeLine = std::function<std::string(std::size_t number)>;

/// Receives the line of a case. To end the work, return false. Called by one thread at a time.
using TakeLine = std::function<bool(std::size_t number, const std::string& line)>;

/// Computes all given cases with MakeLine, in any order, and passes each line to TakeLine. Returns
/// after the last case, or when TakeLine returns false. If MakeLine throws, the work ends, and the
/// exception is rethrown.
using Farm =
    std::function<void(const std::vector<std::size_t>& numbers, const MakeLine&, const TakeLine&)>;

/// Returns a farm of threads in this process; each thread takes the next case. `jobs` is the number
/// of threads; 0: one for each core.
Farm on_threads(unsigned jobs = 0);

/// Options of run_sweep().
struct SweepOptions {
  Farm farm = on_threads();  ///< computes the cases
  /// File with the lines of finished cases; new lines are appended, and an interrupted sweep
  /// continues from it. "": none.
  std::string journal = {};
  /// Called after each case with the number of finished cases and the number of all cases. To stop
  /// the sweep, return false. May be empty.
  std::function<bool(std::size_t done, std::size_t cases)> keep_going = {};
};

/// Result of a sweep.
struct SweepResult {
  std::vector<SweepRow> rows =
      {};                     ///< by number of the case; all cases unless the sweep was stopped
  std::size_t resumed = 0;    ///< number of rows that came from the journal
  std::size_t evaluated = 0;  ///< number of rows that were computed
  bool complete = false;      ///< true if all cases are present
};

/// Runs a sweep. The rows depend neither on the number of processes nor on the order of the cases.
///
///     const SweepSpec spec = read_sweep("sweep.toml");
///     const SweepResult result = run_sweep(spec, {.journal = "results.csv.journal"});
///     if (!result.complete) ...                                // stopped: the same call resumes
///
/// **The journal** receives the line of each case at once. After an interruption, the next call
/// continues: it computes only cases that are not in the journal, and the case of an incomplete
/// last line. Throws InputError for a journal of another sweep, spec or program, and while another
/// process uses the journal.
SweepResult run_sweep(const SweepSpec& spec, const SweepOptions& options = {});

}  // namespace jounce
