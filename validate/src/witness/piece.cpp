// SPDX-License-Identifier: Apache-2.0
#include "validate/src/witness/piece.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "jounce/profiles/error.hpp"

namespace jounce::validate_detail {
namespace {

void require_breaks(const SignalView& signal, std::span<const double> breaks) {
  if (breaks.size() < 2 || breaks.front() != signal.start() || breaks.back() != signal.end()) {
    throw InputError("breaks", std::to_string(breaks.size()) + " of them",
                     "must begin at the start of the signal and end at its end");
  }
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    if (!(breaks[i] > breaks[i - 1])) {
      throw InputError("breaks[" + std::to_string(i) + "]", breaks[i],
                       "must be greater than " + number(breaks[i - 1]) + ", the previous break");
    }
  }
}

}  // namespace

Jet SignalPiece::at(double x) const {
  const double inside = std::clamp(x, begin, end);
  return signal->jet(inside, inside - begin < end - inside ? Side::right : Side::left);
}

std::vector<SignalPiece> pieces(const SignalView& signal, double shortest) {
  const auto breaks = signal.breaks();
  require_breaks(signal, breaks);
  std::vector<SignalPiece> found;
  for (std::size_t i = 1; i < breaks.size(); ++i)
    if (breaks[i] - breaks[i - 1] > shortest) found.push_back({&signal, breaks[i - 1], breaks[i]});
  return found;
}

Scales scales(const std::vector<SignalPiece>& pieces) {
  Scales sizes;
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  for (const SignalPiece& piece : pieces) {
    for (const double s : std::array{0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0}) {
      const Jet f = piece.at(piece.begin + s * piece.length());
      least = std::min(least, f[0]);
      greatest = std::max(greatest, f[0]);
      for (std::size_t k = 0; k < f.size(); ++k)
        sizes.peak[k] = std::max(sizes.peak[k], std::abs(f[k]));
    }
  }
  sizes.range = std::max(0.0, greatest - least);
  return sizes;
}

}  // namespace jounce::validate_detail
