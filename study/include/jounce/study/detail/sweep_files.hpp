// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/study/detail/sweep.hpp"

namespace jounce {

/// Returns a finished sweep as CSV: a head of comments (# key: value), a line of column names with
/// their units, and a row for each case. A row contains the number of the case (from 1), the
/// parameters, the figures, the verdict and its reason. The figures of an impossible case are
/// empty. Text in the last column is quoted if necessary.
std::string to_csv(const SweepSpec& spec, const SweepResult& result);

/// Returns a finished sweep as a NumPy file (format 1.0, 2.0 or 3.0): one structured array with a
/// field for each column. Names of fields have no unit: numpy.load(file)["peak torque"]. The fields
/// "case" and "verdict" are little-endian 64-bit integers (0: within the limits, 1: broken, 2:
/// impossible). All other fields are float64; they are NaN if the case is impossible.
std::string to_npy(const SweepSpec& spec, const SweepResult& result);

/// The files of a sweep.
struct SweepFiles {
  std::string csv = {};  ///< path for to_csv(); "-": standard output, "": none
  std::string npy = {};  ///< path for to_npy(); "-": standard output, "": none

  /// Returns the path of the journal: beside the first file that is written, "" if none is. See
  /// SweepOptions::journal.
  [[nodiscard]] std::string journal() const;
};

/// Writes the files of a finished sweep, all or none. Throws like write_files()
/// (jounce/base/file.hpp).
void write_sweep(const SweepFiles& files, const SweepSpec& spec, const SweepResult& result);

/// Returns a sentence on a sweep that was stopped: the number of finished cases, and how to
/// continue.
std::string stopped_text(const SweepFiles& files, const SweepSpec& spec, const SweepResult& result);

}  // namespace jounce
