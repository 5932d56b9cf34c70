#pragma once

#include "jounce/pvt/detail/piece.hpp"

// Block sampling, segment by segment: the coefficients once an interval, then a loop over the samples
// in it, in vectors of the width that the including file is compiled for. Every sample is the value of
// the same operations, whatever the width and whatever lane it falls into.
namespace jounce::detail {

/// Where the samples are: at given instants, or at start + k step, rounded twice.
struct Listed {
  const double* x;

  [[nodiscard]] JOUNCE_INLINE double at(std::size_t k) const { return x[k]; }
  template <class Real>
  [[nodiscard]] JOUNCE_INLINE Real vector(std::size_t k) const {
    return load<Real>(x + k);
  }
  /// A guess of the first sample not before `end`, where the interval before had `n` samples.
  [[nodiscard]] JOUNCE_INLINE std::size_t guess(std::size_t k, std::size_t n, double) const {
    return k + n;
  }
};
struct Uniform {
  double start, step;

  [[nodiscard]] JOUNCE_INLINE double at(std::size_t k) const {
    return start + static_cast<double>(static_cast<long long>(k)) * step;
  }
  template <class Real>
  [[nodiscard]] JOUNCE_INLINE Real vector(std::size_t k) const {
    constexpr double count[8]{0, 1, 2, 3, 4, 5, 6, 7};
    return start + (load<Real>(count) + static_cast<double>(static_cast<long long>(k))) * step;
  }
  [[nodiscard]] JOUNCE_INLINE std::size_t guess(std::size_t k, std::size_t, double end) const {
    const double n = (end - start) / step;  // at least k, to rounding
    return n < 0x1p62 ? static_cast<std::size_t>(static_cast<long long>(n)) + 1 : k;
  }
};

/// Three columns of results.
struct Samples {
  double* p;
  double* v;
  double* a;
};

/// The kernels of one width: samples [first, last), which ascend and lie in [x(0), x(size - 1)).
struct SampleKernels {
  void (*listed)(const KnotColumns&, Rule, Listed, std::size_t first, std::size_t last, Samples);
  void (*uniform)(const KnotColumns&, Rule, Uniform, std::size_t first, std::size_t last, Samples);
};
extern const SampleKernels sample_anywhere, sample_avx2, sample_avx512;

/// The widest that this processor has.
const SampleKernels& sample_kernels();

/// The first index in [low, high] for which `before`, true for a while and then false, is false; high
/// where it never is: outwards from a guess in steps that double, then by halves.
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

template <class Real, int degree, class Instants>
JOUNCE_INLINE void sample_at(const Piece<degree>& f, const Instants& at, std::size_t k,
                             const Samples& out) {
  Real x;
  if constexpr (lanes<Real> == 1)
    x = at.at(k);
  else
    x = at.template vector<Real>(k);
  const Real s = (x - f.x0) * f.per_length;
  store(out.p + k, position(f, s));
  store(out.v + k, velocity(f, s));
  store(out.a + k, acceleration(f, s));
}

/// Samples [first, last) of one interval. The last vector ends with the last sample, over some that
/// are done already: they become what they are.
template <class Real, int degree, class Instants>
JOUNCE_INLINE void sample_run(const Piece<degree>& f, const Instants& at, std::size_t first,
                              std::size_t last, const Samples& out) {
  constexpr std::size_t n = lanes<Real>;
  if (last - first < n) {
    for (std::size_t k = first; k < last; ++k) sample_at<double>(f, at, k, out);
    return;
  }
  std::size_t k = first;
  for (; k + n <= last; k += n) sample_at<Real>(f, at, k, out);
  if (k < last) sample_at<Real>(f, at, last - n, out);
}

template <class Real, int degree, class Instants>
JOUNCE_INLINE void sample_pieces(const KnotColumns& t, const Instants& at, std::size_t first,
                                 std::size_t last, const Samples& out) {
  std::size_t knot = 1;  // the first after the sample
  std::size_t n = 0;     // samples in the interval before
  for (std::size_t k = first; k < last;) {
    const double x = at.at(k);
    knot = first_after(
        [&](std::size_t i) __attribute__((always_inline)) { return t.x[i] <= x; }, knot, t.size - 1,
        knot);
    const double end = t.x[knot];
    const std::size_t next = first_after(
        [&](std::size_t i) __attribute__((always_inline)) { return at.at(i) < end; }, k + 1, last,
        at.guess(k, n, end));
    sample_run<Real>(piece<degree>(t, knot - 1), at, k, next, out);
    n = next - k;
    k = next;
  }
}

template <class Real, class Instants>
JOUNCE_INLINE void sample_table(const KnotColumns& t, Rule rule, const Instants& at,
                                std::size_t first, std::size_t last, const Samples& out) {
  if (rule == Rule::linear)
    sample_pieces<Real, 1>(t, at, first, last, out);
  else if (rule == Rule::cubic_hermite)
    sample_pieces<Real, 3>(t, at, first, last, out);
  else
    sample_pieces<Real, 5>(t, at, first, last, out);
}

}  // namespace jounce::detail
