// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pvt/src/table/piece.hpp"

// Block sampling, interval by interval: the coefficients once for each interval, then a loop over
// its samples, in vectors of the width for which the including file is compiled. Every sample is
// the result of the same operations, in any lane of any width.
namespace jounce::pvt_detail {

/// The positions of the samples: a list, or start + k step with two roundings.
struct Listed {
  const double* x;

  [[nodiscard]] JOUNCE_INLINE double at(std::size_t k) const { return x[k]; }
  /// Samples k, k + 1, ... in successive vectors.
  template <class Real>
  struct Stream {
    const double* next;

    JOUNCE_INLINE Stream(const Listed& at, std::size_t k) : next(at.x + k) {}
    [[nodiscard]] JOUNCE_INLINE Real get() const { return profiles_detail::load<Real>(next); }
    JOUNCE_INLINE void advance() { next += profiles_detail::lanes<Real>; }
  };
  /// Approximate number of samples between sample k and `end`, if they are as dense as the n
  /// samples before k.
  [[nodiscard]] JOUNCE_INLINE double ahead(std::size_t k, std::size_t n, double end) const {
    return (end - x[k]) / (x[k] - x[k - n]) * static_cast<double>(static_cast<long long>(n));
  }
};
struct Uniform {
  double start, step;

  [[nodiscard]] JOUNCE_INLINE double at(std::size_t k) const {
    return start + static_cast<double>(static_cast<long long>(k)) * step;
  }
  template <class Real>
  struct Stream {
    Real start, step, k;  // k: whole numbers, exact

    JOUNCE_INLINE Stream(const Uniform& at, std::size_t first)
        : start(profiles_detail::every<Real>(at.start)),
          step(profiles_detail::every<Real>(at.step)) {
      constexpr double count[8]{0, 1, 2, 3, 4, 5, 6, 7};
      k = profiles_detail::load<Real>(count) + static_cast<double>(static_cast<long long>(first));
    }
    [[nodiscard]] JOUNCE_INLINE Real get() const { return start + k * step; }
    JOUNCE_INLINE void advance() { k += static_cast<double>(profiles_detail::lanes<Real>); }
  };
  [[nodiscard]] JOUNCE_INLINE double ahead(std::size_t k, std::size_t, double end) const {
    return (end - at(k)) / step;
  }
};

/// Three columns of results.
struct Samples {
  double* p;
  double* v;
  double* a;
};

/// The kernels for one width of vectors, for samples [first, last), which ascend and lie in [x(0),
/// x(size - 1)).
struct SampleKernels {
  void (*listed)(const KnotColumns&, Interpolation, Listed, std::size_t first, std::size_t last,
                 Samples);
  void (*uniform)(const KnotColumns&, Interpolation, Uniform, std::size_t first, std::size_t last,
                  Samples);
  bool (*ascends)(const double* x, std::size_t size);  ///< false if any is NaN
};
extern const SampleKernels sample_anywhere, sample_avx2, sample_avx512;

/// The kernels with the widest vectors that this processor supports.
const SampleKernels& sample_kernels();

/// The first index in [low, high] for which `before` is false, or high. `before` changes at most
/// once, from true to false. The search starts at a guess, with steps that double; then it bisects.
template <class Before>
JOUNCE_INLINE std::size_t first_after(const Before& before, std::size_t low, std::size_t high,
                                      std::size_t guess) {
  std::size_t near = guess < low ? low : (guess > high ? high : guess);
  for (std::size_t step = 1; near < high && before(near); step *= 2) {
    low = near + 1;
    near = high - near > step ? near + step : high;
  }
  high = near;
  for (std::size_t step = 1; low < high; step *= 2) {
    const std::size_t back = high - low > step ? high - step : low;
    if (before(back)) {
      low = back + 1;
      break;
    }
    high = back;
  }
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (before(middle))
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

/// The first sample after k, at most `last`, that is not before `end`. n: number of samples in the
/// previous interval. The guess is usually right to within one, which needs no branch.
template <class Instants>
JOUNCE_INLINE std::size_t run_end(const Instants& at, std::size_t k, std::size_t last, double end,
                                  std::size_t n) {
  const auto before = [&](std::size_t i) __attribute__((always_inline)) {
    return at.at(i) < end;
  };
  const double ahead = at.ahead(k, n, end);
  const double room = static_cast<double>(static_cast<long long>(last - k));
  if (!(ahead < room)) return first_after(before, k + 1, last, last);
  const std::size_t guess = k + 1 + static_cast<std::size_t>(static_cast<long long>(ahead));
  if (guess >= k + 3 && guess + 2 < last && before(guess - 2) && !before(guess + 1)) [[likely]]
    return guess - 1 + static_cast<std::size_t>(before(guess - 1)) +
           static_cast<std::size_t>(before(guess));
  return first_after(before, k + 1, last, guess);
}

template <class Real, int degree>
JOUNCE_INLINE void sample_at(const Piece<degree>& f, Real x, std::size_t k, const Samples& out) {
  const Real s = (x - f.x0) * f.per_length;
  profiles_detail::store(out.p + k, position(f, s));
  profiles_detail::store(out.v + k, velocity(f, s));
  profiles_detail::store(out.a + k, acceleration(f, s));
}

/// Samples [first, last) of one interval: a vector at each end, and between them whole vectors that
/// are aligned in the first column, so that their stores cross no cache line. Samples in two
/// vectors are stored twice, with the same value.
template <class Real, int degree, class Instants>
JOUNCE_INLINE void sample_run(const Piece<degree>& f, const Instants& at, std::size_t first,
                              std::size_t last, const Samples& out) {
  constexpr std::size_t n = profiles_detail::lanes<Real>;
  using Stream = typename Instants::template Stream<Real>;
  if (last - first < n) {
    for (std::size_t k = first; k < last; ++k) sample_at<double>(f, at.at(k), k, out);
    return;
  }
  sample_at(f, Stream(at, first).get(), first, out);
  std::size_t k =
      first + n - (reinterpret_cast<std::uintptr_t>(out.p + first) / sizeof(double)) % n;
  Stream x(at, k);
  for (; k + n <= last; k += n, x.advance()) sample_at(f, x.get(), k, out);
  sample_at(f, Stream(at, last - n).get(), last - n, out);
}

template <class Real, int degree, class Instants>
JOUNCE_INLINE void sample_pieces(const KnotColumns& t, const Instants& at, std::size_t first,
                                 std::size_t last, const Samples& out) {
  std::size_t knot = 1;  // the first knot after the sample
  std::size_t n = 0;     // number of samples in the previous interval
  for (std::size_t k = first; k < last;) {
    const double x = at.at(k);
    knot = first_after(
        [&](std::size_t i) __attribute__((always_inline)) { return t.x[i] <= x; }, knot, t.size - 1,
        knot);
    const double end = t.x[knot];
    const std::size_t next = run_end(at, k, last, end, n);
    sample_run<Real>(piece<degree>(t, knot - 1), at, k, next, out);
    n = next - k;
    k = next;
  }
}

/// Compares every pair of neighbors, without an early end.
template <class Real>
JOUNCE_INLINE bool all_ascend(const double* x, std::size_t size) {
  profiles_detail::Mask<Real> good = Real{} <= Real{};
  std::size_t k = 0;
  for (; k + profiles_detail::lanes<Real> < size; k += profiles_detail::lanes<Real>)
    good &= profiles_detail::load<Real>(x + k) <= profiles_detail::load<Real>(x + k + 1);
  bool all = true;
  for (std::size_t i = 0; i < profiles_detail::lanes<Real>; ++i) all &= good[i] != 0;
  for (; k + 1 < size; ++k) all &= x[k] <= x[k + 1];
  return all;
}

template <class Real, class Instants>
JOUNCE_INLINE void sample_table(const KnotColumns& t, Interpolation rule, const Instants& at,
                                std::size_t first, std::size_t last, const Samples& out) {
  if (rule == Interpolation::linear)
    sample_pieces<Real, 1>(t, at, first, last, out);
  else if (rule == Interpolation::cubic_hermite)
    sample_pieces<Real, 3>(t, at, first, last, out);
  else
    sample_pieces<Real, 5>(t, at, first, last, out);
}

/// The kernels of one width. The positions are passed as copies: the results cannot overlap them.
template <class Real>
constexpr SampleKernels kernels_of() {
  return {[](const KnotColumns& t, Interpolation rule, Listed at, std::size_t first,
             std::size_t last, Samples out) { sample_table<Real>(t, rule, at, first, last, out); },
          [](const KnotColumns& t, Interpolation rule, Uniform at, std::size_t first,
             std::size_t last, Samples out) { sample_table<Real>(t, rule, at, first, last, out); },
          [](const double* x, std::size_t size) { return all_ascend<Real>(x, size); }};
}

}  // namespace jounce::pvt_detail
