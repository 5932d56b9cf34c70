// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <vector>

#include "optimize/src/search/search_phases.hpp"

// A search with one variable needs no solver, and the report can state exactly what was examined:
// equally spaced places, the edges between feasible and infeasible places (by bisection), and the
// minima (by golden section). The method makes no assumption about the whole range. It assumes that
// a cell between two places has at most one edge or one minimum.

namespace jounce::optimize_detail {
namespace {

class Line {
 public:
  explicit Line(Evaluations& evaluations) : evaluations_(evaluations) {}

  void run() {
    look();
    evaluations_.settle_scales();
    std::sort(places_.begin(), places_.end(),
              [](const Evaluation& a, const Evaluation& b) { return a.z < b.z; });
    for (Evaluation& place : places_) place.violation = again(place).violation;
    for (const std::size_t i : dips()) {
      narrow(places_[i == 0 ? 0 : i - 1], places_[std::min(i + 1, places_.size() - 1)]);
      if (evaluations_.best().violation == 0) edges(i);
    }
    if (evaluations_.best().violation > 0) return;
    // A minimum of the violation may have led to a feasible interval that the places missed.
    const Evaluation best = evaluations_.best();
    for (const Evaluation* beside : {below(best), above(best)})
      if (beside != nullptr && beside->violation > 0) bisect(best, *beside);
  }

 private:
  void look() {
    const int cells = std::clamp(evaluations_.max_evaluations() / 4, 8, 256);
    places_.push_back(evaluations_.at(evaluations_.start()));
    for (int i = 0; i <= cells; ++i) {
      const Choice z{static_cast<double>(i) / cells};
      if (z != evaluations_.start()) places_.push_back(evaluations_.at(z));
    }
  }

  [[nodiscard]] const Evaluation& again(const Evaluation& place) const {
    return *std::find_if(evaluations_.all().begin(), evaluations_.all().end(),
                         [&](const Evaluation& each) { return each.z == place.z; });
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
  void bisect(Evaluation inside, Evaluation outside) {
    while (distance(inside.z, outside.z) > 1e-3 * evaluations_.options().tolerance) {
      const Evaluation middle = evaluations_.at({(inside.z[0] + outside.z[0]) / 2});
      (middle.violation > 0 ? outside : inside) = middle;
    }
  }

  /// Golden section between two places.
  void narrow(const Evaluation& from, const Evaluation& to) {
    const double golden = (std::sqrt(5.0) - 1) / 2;
    double a = from.z[0], b = to.z[0];
    Evaluation low = evaluations_.at({b - golden * (b - a)});
    Evaluation high = evaluations_.at({a + golden * (b - a)});
    while (b - a > 1e-1 * evaluations_.options().tolerance) {
      if (better(high, low)) {
        a = low.z[0];
        low = high;
        high = evaluations_.at({a + golden * (b - a)});
      } else {
        b = high.z[0];
        high = low;
        low = evaluations_.at({b - golden * (b - a)});
      }
    }
  }

  [[nodiscard]] const Evaluation* below(const Evaluation& t) const { return beside(t, -1); }
  [[nodiscard]] const Evaluation* above(const Evaluation& t) const { return beside(t, 1); }

  /// The nearest evaluated place on that side.
  [[nodiscard]] const Evaluation* beside(const Evaluation& t, int side) const {
    const Evaluation* nearest = nullptr;
    for (const Evaluation& each : evaluations_.all()) {
      const double away = side * (each.z[0] - t.z[0]);
      if (away > 0 && (nearest == nullptr || away < side * (nearest->z[0] - t.z[0])))
        nearest = &each;
    }
    return nearest;
  }

  Evaluations& evaluations_;
  std::vector<Evaluation> places_;  ///< in order
};

}  // namespace

void search_line(Evaluations& evaluations) {
  Line(evaluations).run();
}

}  // namespace jounce::optimize_detail
