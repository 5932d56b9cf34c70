// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "jounce/study/detail/sweep.hpp"

namespace jounce {

/// Distribution of a figure over all possible cases.
struct FigureSpread {
  KeyFigure given = {};              ///< name, unit, and the value for the given spec
  std::optional<double> limit = {};  ///< upper limit in the sweep or in the spec; nullopt: none
  double least = 0;                  ///< least value
  double median = 0;                 ///< median
  double greatest = 0;               ///< greatest value
  double mean = 0;                   ///< mean
  double deviation = 0;              ///< standard deviation, computed with n - 1; 0 for one case
  std::size_t least_case = 0;        ///< index of the row with the least value in SweepResult::rows
  std::size_t greatest_case = 0;     ///< index of the row with the greatest value in
                                     ///< SweepResult::rows
};

/// A share with its 95 % confidence interval.
struct Share {
  double value = 0;  ///< the share, 0 to 1
  double low = 0;    ///< lower end of the interval
  double high = 0;   ///< upper end of the interval
};

/// Returns the share of `hits` among `n` > 0 independent draws, with its interval (E. B. Wilson,
/// "Probable inference, the law of succession, and statistical inference", J. Am. Stat. Assoc. 22,
/// 1927).
Share share_of(std::size_t hits, std::size_t n);

/// Summary of the rows of a sweep.
struct SweepSummary {
  std::size_t cases = 0;                   ///< number of rows
  std::size_t within = 0;                  ///< number of rows within all limits
  std::size_t broken = 0;                  ///< number of rows that break a limit
  std::size_t impossible = 0;              ///< number of rows without a motion
  std::vector<FigureSpread> figures = {};  ///< one for each figure; empty if no case is possible
  /// Share of the rows that are within all limits; nullopt if no parameter is random. The
  /// confidence interval is valid only for independent samples (SweepSpec::independent()).
  std::optional<Share> yield = {};
  /// Index of the possible row with the smallest margin; nullopt: no row is possible.
  std::optional<std::size_t> worst = {};
  /// Indices of the rows in the Pareto front: among the rows within all limits, in ascending order
  /// of the figure of the first objective. Empty without objectives.
  std::vector<std::size_t> front = {};
};

/// Returns the summary of the rows.
SweepSummary summary_of(const SweepSpec& spec, const SweepResult& result);

/// Returns the summary as text for people.
std::string summary_text(const SweepSpec& spec, const SweepResult& result,
                         const SweepSummary& summary);
/// Returns the whole summary as JSON, for programs.
std::string summary_json(const SweepSpec& spec, const SweepResult& result,
                         const SweepSummary& summary);

/// Returns the numbers of a case as text: "drive.load_inertia = 1e-05 kg m^2, master.velocity =
/// 200".
std::string numbers_text(const SweepSpec& spec, std::size_t number);
/// Returns only the listed values of a case, which all samples of a combination have in common.
std::string listed_text(const SweepSpec& spec, std::size_t number);

/// Returns the index of a figure in SweepSpec::given, by its name. Every figure in objectives and
/// limits has an index.
std::size_t column_of(const SweepSpec& spec, const std::string& figure);

/// Describes the progress of a sweep in words, for SweepOptions::keep_going: "1200 of 5000, 2 min
/// left". The remaining time is estimated from the speed since the first call, because the cases of
/// a journal take no time.
class SweepClock {
 public:
  std::string text(std::size_t done, std::size_t cases);

 private:
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  std::size_t first_ = 0;
};

}  // namespace jounce
