// SPDX-License-Identifier: Apache-2.0
// Tests of residuals r_1 ... r_n of one quantity, each at the level 0.1 %:
//
//     (1)  Q = n (n + 2) sum_{k=1}^{m} rho_k^2 / (n - k),   rho_k = sum r_i r_(i+k) / sum r_i^2
//          chi-square with m degrees of freedom, if the r are white
//          G. M. Ljung, G. E. P. Box, On a measure of lack of fit in time series models, Biometrika 65 (1978);
//          with few samples it exceeds the quantile more often: measured 0.5 % of 60, 0.3 % of 101, 0.17 % of 300,
//          0.14 % of 1000 (40 000 recordings of Gaussian noise each); with m = 20 up to 0.6 %
//     (2)  F = sum of the last third's r^2 / sum of the first third's r^2
//          Fisher's F with a third of n, twice, if the r are Gaussian and do not grow
//          S. M. Goldfeld, R. E. Quandt, Some tests for homoscedasticity, J. Am. Stat. Assoc. 60 (1965)
//
// Degrees of freedom are even here, where both distributions are finite sums:
//
//     (3)  P(chi^2_2k > x) = exp(-x/2) sum_{i<k} (x/2)^i / i!
//     (4)  P(F_2k,2k > f) = sum_{i=k}^{2k-1} C(2k-1, i) p^i (1 - p)^(2k-1-i),   p = 1 / (1 + f)

#include "validate/src/identify/residual_tests.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "jounce/profiles/detail/tolerances.hpp"

namespace jounce::validate_detail {
namespace {

using profiles_detail::rounded_sum;

constexpr double level = 1e-3;
constexpr std::size_t least_samples = 20;

double squares(std::span<const double> r) {
  double sum = 0;
  for (const double x : r) sum += x * x;
  return sum;
}

/// (3)
double chi_square_beyond(double x, std::size_t k) {
  double term = std::exp(-x / 2), sum = 0;
  for (std::size_t i = 0; i < k; ++i) {
    sum += term;
    term *= x / 2 / static_cast<double>(i + 1);
  }
  return sum;
}

/// (4), each term from its logarithm.
double f_beyond(double f, std::size_t k) {
  const double n = 2 * static_cast<double>(k) - 1;
  double sum = 0;
  for (double i = static_cast<double>(k); i <= n; ++i)
    sum += std::exp(std::lgamma(n + 1) - std::lgamma(i + 1) - std::lgamma(n - i + 1) -
                    i * std::log1p(f) + (n - i) * (std::log(f) - std::log1p(f)));
  return sum;
}

/// The value at which a decreasing probability reaches the level, from 1 on.
double quantile(const std::function<double(double)>& beyond) {
  double low = 1, high = 2;
  while (beyond(high) > level) high *= 2;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (beyond(middle) > level ? low : high) = middle;
  }
  return high;
}

/// The F quantile for two sums of squares of 2k residuals each.
ResidualTest ratio(double after, double before, std::size_t k) {
  ResidualTest test;
  test.value = after == 0    ? 0
               : before == 0 ? std::numeric_limits<double>::infinity()
                             : after / before;
  test.limit = quantile([k](double f) { return f_beyond(f, k); });
  return test;
}

}  // namespace

ResidualTest whiteness(std::span<const double> r) {
  const std::size_t n = r.size();
  const double all = squares(r);
  if (n < least_samples || all == 0) return {};
  const std::size_t half = std::min<std::size_t>(10, n / 5) / 2;
  double sum = 0;
  for (std::size_t k = 1; k <= 2 * half; ++k) {
    double product = 0;
    for (std::size_t i = 0; i + k < n; ++i) product += r[i] * r[i + k];
    sum += product / all * (product / all) / static_cast<double>(n - k);
  }
  const auto size = static_cast<double>(n);
  return {size * (size + 2) * sum,  // (1)
          quantile([half](double x) { return chi_square_beyond(x, half); })};
}

ResidualTest growth(std::span<const double> r) {
  if (r.size() < least_samples) return {};
  const std::size_t k = r.size() / 6;
  return ratio(squares(r.last(2 * k)), squares(r.first(2 * k)), k);  // (2)
}

ResidualTest worsening(std::span<const double> before, std::span<const double> after) {
  if (after.size() < least_samples) return {};
  const std::size_t k = after.size() / 2;
  return ratio(squares(after.first(2 * k)), squares(before.first(2 * k)), k);
}

double resolution(std::span<const double> recorded) {
  std::vector<double> sorted(recorded.begin(), recorded.end());
  std::sort(sorted.begin(), sorted.end());
  double least = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const double step = sorted[i] - sorted[i - 1];
    // smaller differences are rounding of the numbers
    if (step > rounded_sum * std::abs(sorted[i]) && (least == 0 || step < least)) least = step;
  }
  return least;
}

}  // namespace jounce::validate_detail
