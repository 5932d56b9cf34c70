// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "jounce/profiles/detail/random.hpp"

#include "optimize/src/search/search_phases.hpp"

// The global phase of a search. Measured on eleven constrained problems with 20 seeds each and 5000
// evaluations, half of them for this phase. The numbers are the runs of 20 that were solved to 1e-4
// after the local phase ("polish"). Problem g06 depends on the local phase alone and is not
// counted:
//
//            Rastrigin in a disc, n = 2, 3, 5   g08   Ackley 4   five wells   g04 g09 g11 Rosenbrock
//   this              20  11   0                 20      20         20         all 20
//   DIRECT_L          20   0   0                  3      20         20         all 20   (penalty)
//   MLSL, BOBYQA      20  13   1                  5      15         20         all 20   (penalty)
//   ISRES             17   5   0                 20      18         10         all 20
//
// DIRECT and MLSL do not support constraints. They need a penalty, whose right weight is unknown.
// MLSL and ISRES do not end by themselves. This phase is therefore a multi-start with NLopt's
// COBYLA, which supports constraints. It starts from good places that are far from earlier
// searches, as MLSL does (A. Rinnooy Kan and G. Timmer, Mathematical Programming 39, 1987). It ends
// by the rule of C. Boender and A. Rinnooy Kan (Math. Prog. 37, 1987): after N searches that found
// w basins, the expected number of basins is (1). The phase ends when that is below w + 1/2.
//
//   (1)  w (N - 1) / (N - w - 2)

namespace jounce::optimize_detail {
namespace {

Choice drawn_choice(std::size_t n, std::uint64_t& state) {
  Choice z(n);
  for (double& each : z) each = profiles_detail::uniform(state);
  return z;
}

bool expects_more(double searches, double basins) {
  if (searches <= basins + 2) return true;
  return basins * (searches - 1) / (searches - basins - 2) >= basins + 0.5;  // (1)
}

class BasinSearch {
 public:
  explicit BasinSearch(Evaluations& evaluations)
      : evaluations_(evaluations), state_(evaluations.options().seed) {}

  MultiStartCounts run(double share) {
    search_from(evaluations_.best());
    const int most = evaluations_.options().starts.value_or(std::numeric_limits<int>::max());
    while (evaluations_.used() < share && counts_.searches < most &&
           expects_more(counts_.searches, static_cast<double>(basins_.size()))) {
      const std::size_t first = evaluations_.all().size();
      for (std::size_t i = 0; i < 3 * (evaluations_.size() + 1); ++i)
        places_.push_back(evaluations_.at(drawn_choice(evaluations_.size(), state_)));
      if (evaluations_.all().size() == first) break;
      std::stable_sort(places_.begin(), places_.end(), better);
      const auto next = std::find_if(places_.begin(), places_.end(),
                                     [&](const Evaluation& place) { return is_far(place); });
      if (next != places_.end()) search_from(Evaluation(*next));
    }
    const auto best =
        std::min_element(basins_.begin(), basins_.end(),
                         [](const Basin& a, const Basin& b) { return better(a.end, b.end); });
    counts_.agreeing = best->searches;
    return counts_;
  }

 private:
  struct Basin {
    Evaluation end;
    int searches = 1;
  };

  /// About half the usual distance between the places so far.
  [[nodiscard]] double reach() const {
    const double places = static_cast<double>(places_.size()) + 1;
    return 0.5 * std::pow(places, -1 / static_cast<double>(evaluations_.size()));
  }

  [[nodiscard]] bool is_far(const Evaluation& place) const {
    if (!place.answer.possible) return false;
    return std::all_of(known_.begin(), known_.end(),
                       [&](const Choice& each) { return distance(each, place.z) >= reach(); });
  }

  /// Two ends are one basin if their values are equal: a variable without influence gives one basin many ends.
  [[nodiscard]] bool is_same(const Evaluation& a, const Evaluation& b) const {
    const double away = std::abs(a.answer.objective - b.answer.objective);
    const bool as_good =
        a.violation == 0 && b.violation == 0 && away <= 1e-2 * evaluations_.spread();
    return as_good || distance(a.z, b.z) <= 1e-2;
  }

  void search_from(const Evaluation& place) {
    const int n = static_cast<int>(evaluations_.size());
    Evaluation end = run_cobyla(evaluations_, place.z, std::min(0.2, reach()), 1e-3, 25 * (n + 1));
    if (better(place, end)) end = place;
    known_.push_back(place.z);
    known_.push_back(end.z);
    ++counts_.searches;
    for (Basin& basin : basins_) {
      if (!is_same(basin.end, end)) continue;
      ++basin.searches;
      if (better(end, basin.end)) basin.end = end;
      return;
    }
    basins_.push_back({end});
  }

  Evaluations& evaluations_;
  std::uint64_t state_;
  std::vector<Evaluation> places_;
  std::vector<Choice> known_;  ///< starts and ends of searches
  std::vector<Basin> basins_;
  MultiStartCounts counts_;
};

}  // namespace

void first_evaluations(Evaluations& evaluations) {
  const std::size_t n = evaluations.size();
  evaluations.at(evaluations.start());
  for (std::size_t k = 0; k < n; ++k) {  // a step towards the farther bound
    Choice z = evaluations.start();
    z[k] += z[k] < 0.5 ? 0.1 : -0.1;
    evaluations.at(z);
  }
  std::uint64_t state = evaluations.options().seed ^ 0x5bd1e995U;
  if (evaluations.is_global())
    for (std::size_t i = 0; i < 2 * n; ++i) evaluations.at(drawn_choice(n, state));
  while (!evaluations.any_possible()) evaluations.at(drawn_choice(n, state));
  evaluations.settle_scales();
}

MultiStartCounts multi_start(Evaluations& evaluations, double share) {
  return BasinSearch(evaluations).run(share);
}

}  // namespace jounce::optimize_detail
