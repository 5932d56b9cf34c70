// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "jounce/study/sweep.hpp"

namespace jounce {

/// A figure over all cases that are possible.
struct FigureSpread {
  KeyFigure given;                   ///< name, unit, and the value of the spec as it is given
  std::optional<double> limit = {};  ///< upper limit in the sweep or the spec, if any
  double least = 0;
  double median = 0;
  double greatest = 0;
  double mean = 0;
  double deviation = 0;        ///< standard deviation, of n - 1; 0 for one case
  std::size_t least_case = 0;  ///< by index of SweepResult::rows
  std::size_t greatest_case = 0;
};

/// A share with its interval of 95 % confidence.
struct Share {
  double value = 0;
  double low = 0;
  double high = 0;
};

/// Share with confidence interval, from `hits` among `n` > 0 independent draws: E. B. Wilson, "Probable
/// inference, the law of succession, and statistical inference", J. Am. Stat. Assoc. 22 (1927).
Share share_of(std::size_t hits, std::size_t n);

/// Summary of the rows of a sweep.
struct SweepSummary {
  std::size_t cases = 0;
  std::size_t within = 0;
  std::size_t broken = 0;
  std::size_t impossible = 0;
  std::vector<FigureSpread> figures;  ///< empty if no case is possible
  std::optional<Share> yield =
      {};  ///< yield: share of the samples within limits, if they are random
  std::optional<std::size_t> worst = {};  ///< index of the possible row with the smallest margin
  std::vector<std::size_t> front;         ///< Pareto, among rows within limits: indices, along the
                                          ///< first objective; empty without objectives
};

SweepSummary summary_of(const SweepSpec& spec, const SweepResult& result);

/// Text for people; the JSON is complete, for programs.
std::string summary_text(const SweepSpec& spec, const SweepResult& result,
                         const SweepSummary& summary);
std::string summary_json(const SweepSpec& spec, const SweepResult& result,
                         const SweepSummary& summary);

/// "drive.load_inertia = 1e-05 kg m^2, master.velocity = 200"
std::string numbers_text(const SweepSpec& spec, std::size_t number);
/// Only the listed values, which the samples of a combination have in common.
std::string listed_text(const SweepSpec& spec, std::size_t number);

/// The column of a figure, by name; the objectives and limits of a sweep are all among them.
std::size_t column_of(const SweepSpec& spec, const std::string& figure);

/// Progress of a sweep in words, for SweepOptions::keep_going: "1200 of 5000, 2 min left". The time
/// follows from the speed since the first call: cases of a journal take no time.
class SweepClock {
 public:
  std::string text(std::size_t done, std::size_t cases);

 private:
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  std::size_t first_ = 0;
};

}  // namespace jounce
