// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/cursor.hpp"

#include <algorithm>

#include "pvt/src/table/piece.hpp"

namespace jounce {
namespace {

using pvt_detail::horner;

/// The interval after the previous one, if x is in it; otherwise the table searches.
std::size_t interval_of(const Table& table, double x, std::size_t before) {
  const auto knots = table.breaks();
  const bool next = before + 2 < knots.size() && x >= knots[before + 1] && x < knots[before + 2];
  return next ? before + 1 : table.interval(x);
}

}  // namespace

Cursor::Cursor(const Table& table) : table_(&table), degree_(pvt_detail::degree_of(table.rule())) {}

Jet Cursor::jet(double x) {
  if (!(x >= from_ && x < to_)) [[unlikely]] {
    if (!(x >= table_->start() && x < table_->end())) return table_->jet(x);
    enter(interval_of(*table_, x, interval_));
  }
  const double s = x > from_ ? (x - from_) * per_length_ : 0;
  if (degree_ == 3)
    return {horner<3>(p_.data(), s), horner<2>(v_.data(), s), horner<1>(a_.data(), s),
            horner<0>(j_.data(), s)};
  if (degree_ == 5)
    return {horner<5>(p_.data(), s), horner<4>(v_.data(), s), horner<3>(a_.data(), s),
            horner<2>(j_.data(), s)};
  return {horner<1>(p_.data(), s), horner<0>(v_.data(), s), horner<0>(a_.data(), s),
          horner<0>(j_.data(), s)};
}

void Cursor::enter(std::size_t interval) {
  const pvt_detail::KnotColumns knots = pvt_detail::knots_of(table_->columns());
  const auto keep = [&](const auto& f) {
    per_length_ = f.per_length;
    std::copy(std::begin(f.p), std::end(f.p), p_.begin());
    std::copy(std::begin(f.v), std::end(f.v), v_.begin());
    std::copy(std::begin(f.a), std::end(f.a), a_.begin());
    std::copy(std::begin(f.j), std::end(f.j), j_.begin());
  };
  if (degree_ == 1) keep(pvt_detail::piece<1>(knots, interval));
  if (degree_ == 3) keep(pvt_detail::piece<3>(knots, interval));
  if (degree_ == 5) keep(pvt_detail::piece<5>(knots, interval));
  interval_ = interval;
  from_ = knots.x[interval];
  to_ = knots.x[interval + 1];
}

}  // namespace jounce
