// SPDX-License-Identifier: Apache-2.0
#include "pvt/src/sample/best_places.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/profiles/detail/numeric.hpp"

#include "pvt/src/sample/longest.hpp"
#include "pvt/src/sample/whole_steps.hpp"

// Let e(i, j) be the share of the tolerances that an interval from place i to place j uses. Of all
// tables with k intervals that end at place j, the best one has the greatest share
//
//   (1)  E_0(0) = 0,   E_k(j) = min over i < j of max(E_(k-1)(i), e(i, j))
//
// This is exact over the places. Then the knots move. The places x - h ... x + h around each knot
// are candidates, and an interval leads from each of them to each candidate around the next knot,
// so (1) has one layer for each knot. h is halved several times.
//
// No interval crosses an end of a stretch that the table keeps, and no place is inside such a
// stretch.
namespace jounce::pvt_detail {
namespace {

constexpr int refinements = 8;
constexpr double most_parts = 64;
constexpr int around = 3;  ///< number of places on each side of a knot to which it may move

template <class Over>
class Places {
 public:
  Places(const Curve<Over>& f, const Target& target, const Tolerances& tolerances,
         const std::vector<Straight>& kept)
      : f_(f), target_(target), tolerances_(tolerances), kept_(kept) {
    for (const Straight& each : kept) fixed_.insert(fixed_.end(), {each.begin.x, each.end.x});
    fixed_.insert(fixed_.end(), {f.start(), f.end()});
    std::sort(fixed_.begin(), fixed_.end());
  }

  /// All places, ascending.
  [[nodiscard]] std::vector<Knot> all(const std::vector<Knot>& known) const {
    std::vector<Knot> places = known;
    places.push_back(held_at(f_, target_, f_.start(), Side::right));
    for (const Straight& each : kept_) places.insert(places.end(), {each.begin, each.end});
    for (const double x : f_.breaks()) add(places, x);
    const double steps_in =
        target_.x_step > 0 ? std::round(f_.length() / target_.x_step) : profiles_detail::inf;
    const auto parts = static_cast<std::size_t>(std::min(steps_in, most_parts));
    for (std::size_t i = 1; i < parts; ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(parts);
      add(places, rounded_to(f_.start() + f_.length() * part, target_.x_step));
    }
    places.push_back(held_at(f_, target_, f_.end(), Side::left));
    return sorted(std::move(places));
  }

  /// Solves (1) with all places in one layer.
  [[nodiscard]] std::optional<BestTable> best(const std::vector<Knot>& places, std::size_t most,
                                              bool fewest) const {
    const std::size_t n = places.size();
    const std::vector<double> shares = all_shares(places);
    std::vector<std::vector<std::size_t>> from;
    std::vector<double> now(n, profiles_detail::inf);
    now[0] = 0;
    double least = profiles_detail::inf;
    std::size_t best_count = 0;
    for (std::size_t count = 1; count < most && !(fewest && least <= 1); ++count) {
      std::vector<double> next(n, profiles_detail::inf);
      from.emplace_back(n, 0);
      for (std::size_t i = 0; i + 1 < n; ++i)
        for (std::size_t j = i + 1; j < n && now[i] < profiles_detail::inf; ++j)
          if (const double e = std::max(now[i], shares[i * n + j]); e < next[j]) {
            next[j] = e;
            from.back()[j] = i;
          }
      now = std::move(next);
      if (now[n - 1] >= least) continue;
      least = now[n - 1];
      best_count = count;
    }
    if (!(least <= 1)) return std::nullopt;
    BestTable table{{places.back()}, least};
    for (std::size_t j = n - 1; best_count > 0; --best_count) {
      j = from[best_count - 1][j];
      table.knots.push_back(places[j]);
    }
    std::reverse(table.knots.begin(), table.knots.end());
    return table;
  }

  /// Solves (1) with one layer for each knot, which contains places at distances of h around it.
  [[nodiscard]] BestTable moved(BestTable table, double h) const {
    std::vector<std::vector<Knot>> layers;
    for (const Knot& knot : table.knots) layers.push_back(near(knot, h));
    std::vector<std::vector<std::size_t>> from;
    std::vector<double> now{0};
    for (std::size_t k = 1; k < layers.size(); ++k) {
      std::vector<double> next(layers[k].size(), profiles_detail::inf);
      from.emplace_back(layers[k].size(), 0);
      for (std::size_t i = 0; i < now.size(); ++i)
        for (std::size_t j = 0; j < next.size(); ++j) {
          if (!(now[i] < next[j])) continue;
          const double e = std::max(now[i], share_of(layers[k - 1][i], layers[k][j]));
          if (e < next[j]) {
            next[j] = e;
            from.back()[j] = i;
          }
        }
      now = std::move(next);
    }
    if (!(now[0] < table.share)) return table;
    table.share = now[0];
    std::size_t j = 0;
    for (std::size_t k = layers.size() - 1; k > 0; --k) {
      j = from[k - 1][j];
      table.knots[k - 1] = layers[k - 1][j];
    }
    return table;
  }

 private:
  [[nodiscard]] bool is_inside_a_stretch(double x) const {
    return std::any_of(kept_.begin(), kept_.end(),
                       [&](const Straight& each) { return x > each.begin.x && x < each.end.x; });
  }

  [[nodiscard]] bool is_fixed(double x) const {
    return std::binary_search(fixed_.begin(), fixed_.end(), x);
  }

  /// Adds the knots at x, unless x is a fixed end: two knots if the curve steps there.
  void add(std::vector<Knot>& places, double x) const {
    if (!(x > f_.start() && x < f_.end()) || is_fixed(x) || is_inside_a_stretch(x)) return;
    if (target_.x_step > 0 && !is_whole(x, target_.x_step)) return;
    places.push_back(held_at(f_, target_, x, Side::right));
    const Knot left = held_at(f_, target_, x, Side::left);
    if (left.jet != places.back().jet) places.push_back(left);
  }

  static std::vector<Knot> sorted(std::vector<Knot> places) {
    std::stable_sort(places.begin(), places.end(),
                     [](const Knot& a, const Knot& b) { return a.x < b.x; });
    const auto same = [](const Knot& a, const Knot& b) { return a.x == b.x && a.jet == b.jet; };
    places.erase(std::unique(places.begin(), places.end(), same), places.end());
    return places;
  }

  [[nodiscard]] double share_of(const Knot& a, const Knot& b) const {
    const double spacing = target_.spacing * (1 - 1e-12);
    if (!(b.x > a.x) || b.x - a.x < spacing) return profiles_detail::inf;
    const auto limit = std::upper_bound(fixed_.begin(), fixed_.end(), a.x);
    if (limit != fixed_.end() && b.x > *limit) return profiles_detail::inf;
    const double e = share(f_, target_.rule, a, b, tolerances_);
    return e <= 1 ? e : profiles_detail::inf;
  }

  [[nodiscard]] std::vector<double> all_shares(const std::vector<Knot>& places) const {
    const std::size_t n = places.size();
    std::vector<double> shares(n * n, profiles_detail::inf);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j) shares[i * n + j] = share_of(places[i], places[j]);
    return shares;
  }

  [[nodiscard]] std::vector<Knot> near(const Knot& knot, double h) const {
    std::vector<Knot> places{knot};
    if (is_fixed(knot.x)) return places;
    for (int i = -around; i <= around; ++i)
      if (i != 0) add(places, rounded_to(knot.x + h * i / around, target_.x_step));
    return places;
  }

  const Curve<Over>& f_;
  const Target& target_;
  const Tolerances& tolerances_;
  const std::vector<Straight>& kept_;
  std::vector<double> fixed_;  ///< ends of the curve and of the straight stretches, ascending
};

}  // namespace

template <class Over>
std::optional<BestTable> best_over_places(const Curve<Over>& f, const Target& target,
                                          const Tolerances& tolerances,
                                          const std::vector<Straight>& kept,
                                          const std::vector<Knot>& known, std::size_t most,
                                          bool fewest) {
  if (target.quadratic || most > most_searched_knots ||
      f.segments().size() > most_searched_segments)
    return std::nullopt;
  const Places<Over> places(f, target, tolerances, kept);
  const std::vector<Knot> all = places.all(known);
  auto table = places.best(all, most, fewest);
  double h = f.length() / static_cast<double>(all.size());
  for (int i = 0; table && i < refinements; ++i, h /= 2) table = places.moved(std::move(*table), h);
  return table;
}

#define JOUNCE_INSTANTIATE(Over)                                                          \
  template std::optional<BestTable> best_over_places(                                     \
      const Curve<Over>&, const Target&, const Tolerances&, const std::vector<Straight>&, \
      const std::vector<Knot>&, std::size_t, bool);
JOUNCE_INSTANTIATE(OverTime)
JOUNCE_INSTANTIATE(OverMaster)
#undef JOUNCE_INSTANTIATE

}  // namespace jounce::pvt_detail
