// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <vector>

#include "optimize/src/search/search_steps.hpp"

// One variable needs no solver, and the report can state exactly what was examined: equally spaced places, the
// edges between feasible and infeasible places, by bisection, and the minima, by golden section. The method
// assumes nothing about the whole range. It assumes that a cell between two places has at most one edge or one
// minimum.

namespace jounce::optimizer {
namespace {

class Line {
 public:
  explicit Line(Trials& trials) : trials_(trials) {}

  void run() {
    look();
    trials_.settle_scales();
    std::sort(places_.begin(), places_.end(),
              [](const Trial& a, const Trial& b) { return a.z < b.z; });
    for (Trial& place : places_) place.violation = again(place).violation;
    for (const std::size_t i : dips()) {
      narrow(places_[i == 0 ? 0 : i - 1], places_[std::min(i + 1, places_.size() - 1)]);
      if (trials_.best().violation == 0) edges(i);
    }
    if (trials_.best().violation > 0) return;
    // A minimum of the violation may have led to a feasible interval that the places missed.
    const Trial best = trials_.best();
    for (const Trial* beside : {below(best), above(best)})
      if (beside != nullptr && beside->violation > 0) bisect(best, *beside);
  }

 private:
  void look() {
    const int cells = std::clamp(trials_.max_evaluations() / 4, 8, 256);
    places_.push_back(trials_.at(trials_.start()));
    for (int i = 0; i <= cells; ++i) {
      const Choice z{static_cast<double>(i) / cells};
      if (z != trials_.start()) places_.push_back(trials_.at(z));
    }
  }

  [[nodiscard]] const Trial& again(const Trial& place) const {
    return *std::find_if(trials_.all().begin(), trials_.all().end(),
                         [&](const Trial& each) { return each.z == place.z; });
  }

  /// Places without a better neighbor, the best first; at most eight.
  [[nodiscard]] std::vector<std::size_t> dips() const {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const bool left = i == 0 || !better(places_[i - 1], places_[i]);
      const bool right = i + 1 == places_.size() || !better(places_[i + 1], places_[i]);
      if (left && right) all.push_back(i);
    }
    std::stable_sort(all.begin(), all.end(),
                     [&](std::size_t a, std::size_t b) { return better(places_[a], places_[b]); });
    if (all.size() > 8) all.resize(8);
    return all;
  }

  void edges(std::size_t i) {
    for (const std::size_t j : {i - 1, i + 1})  // i - 1 of 0 is past the end
      if (j < places_.size() && (places_[i].violation > 0) != (places_[j].violation > 0))
        places_[i].violation > 0 ? bisect(places_[j], places_[i]) : bisect(places_[i], places_[j]);
  }

  /// Bisects the edge between a feasible place and an infeasible one.
  void bisect(Trial inside, Trial outside) {
    while (distance(inside.z, outside.z) > 1e-3 * trials_.options().tolerance) {
      const Trial middle = trials_.at({(inside.z[0] + outside.z[0]) / 2});
      (middle.violation > 0 ? outside : inside) = middle;
    }
  }

  /// Golden section between two places.
  void narrow(const Trial& from, const Trial& to) {
    const double golden = (std::sqrt(5.0) - 1) / 2;
    double a = from.z[0], b = to.z[0];
    Trial low = trials_.at({b - golden * (b - a)});
    Trial high = trials_.at({a + golden * (b - a)});
    while (b - a > 1e-1 * trials_.options().tolerance) {
      if (better(high, low)) {
        a = low.z[0];
        low = high;
        high = trials_.at({a + golden * (b - a)});
      } else {
        b = high.z[0];
        high = low;
        low = trials_.at({b - golden * (b - a)});
      }
    }
  }

  [[nodiscard]] const Trial* below(const Trial& t) const { return beside(t, -1); }
  [[nodiscard]] const Trial* above(const Trial& t) const { return beside(t, 1); }

  /// The nearest evaluated place on that side.
  [[nodiscard]] const Trial* beside(const Trial& t, int side) const {
    const Trial* nearest = nullptr;
    for (const Trial& each : trials_.all()) {
      const double away = side * (each.z[0] - t.z[0]);
      if (away > 0 && (nearest == nullptr || away < side * (nearest->z[0] - t.z[0])))
        nearest = &each;
    }
    return nearest;
  }

  Trials& trials_;
  std::vector<Trial> places_;  ///< in order
};

}  // namespace

void walk_line(Trials& trials) {
  Line(trials).run();
}

}  // namespace jounce::optimizer
