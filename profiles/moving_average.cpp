#include "jounce/profiles/moving_average.hpp"

#include <string>

#include "jounce/profiles/between.hpp"
#include "jounce/profiles/error.hpp"

// With the head f(x) and the tail f(x - T) of the window,
//
//   (1)  g(x)  = 1/T * integral of f from x - T to x
//   (2)  g'(x) = (f(x) - f(x - T)) / T
//
// (2) is a curve with the breaks of head and tail. Each of its pieces is integrated from the value
// that (1) gives at its start, so that no error adds up along the curve; values are counted from f's
// first, so that a far origin costs no digits.

namespace jounce {
namespace {

Segment integrated(const Segment& f, double start_value) {
  const auto g = integral(f, start_value);
  if (!g) throw InputError("degree", f.degree, "the moving average would pass degree 11");
  return *g;
}

/// (1) at the right end of the window f.
template <class Over>
double mean(const Curve<Over>& f) {
  double total = 0;
  for (const Segment& piece : f.segments()) total += value(integrated(piece, 0), 1);
  return total / f.length();
}

}  // namespace

template <class Over>
Curve<Over> moving_average(const Curve<Over>& f, double window) {
  require_positive("window", window);
  const double origin = value(f.segments().front(), 0);
  const bool wraps = f.outside() == Outside::wrap;
  const auto from_origin = with(shifted(f, 0, -origin), wraps ? Outside::wrap : Outside::hold);
  const auto head = delayed(from_origin, 0, window);
  const auto tail = delayed(from_origin, window, window);
  const auto slope = sum(scaled(head, 1 / window), scaled(tail, -1 / window));  // (2)

  std::vector<Segment> pieces;
  pieces.reserve(slope.segments().size());
  for (std::size_t i = 0; i < slope.segments().size(); ++i) {
    const double x = slope.breaks()[i];
    const double at_start = mean(between(from_origin, x - window, x));
    pieces.push_back(scaled(integrated(slope.segments()[i], at_start), 1, origin));
  }
  return Curve<Over>(std::move(pieces), f.start(), from_origin.outside());
}

template Trajectory moving_average(const Trajectory&, double);
template Cam moving_average(const Cam&, double);

}  // namespace jounce
