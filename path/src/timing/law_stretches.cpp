// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>

#include "jounce/path/law.hpp"
#include "jounce/profiles/detail/large_pages.hpp"

#include "path/src/timing/not_limited.hpp"

// The numbers of a stretch in their order. Each of them is stored if it differs from the expected value in any bit;
// `length` is always stored. The numbers of a usual ramp are those with (*).
//
//   time, start, v0, piece   those at the end of the previous stretch (not stored for the first stretch of a block)
//   pieces                   1
//   length                   (*)
//   v1                       (*) v0
//   peak                     (*) the greater one of v0 and v1
//   acceleration             (*) infinite, as at a corner
//   deceleration             acceleration
//   jerk                     (*) infinite
//   duration                 (*) length / peak, if the velocity is constant
namespace jounce {
namespace {

using path_detail::unlimited;

/// The numbers that are stored of a stretch, as bits.
struct Given {
  static constexpr std::uint16_t time = 1U << 0U;
  static constexpr std::uint16_t start = 1U << 1U;
  static constexpr std::uint16_t v0 = 1U << 2U;
  static constexpr std::uint16_t piece = 1U << 3U;
  static constexpr std::uint16_t pieces = 1U << 4U;
  static constexpr std::uint16_t v1 = 1U << 5U;
  static constexpr std::uint16_t peak = 1U << 6U;
  static constexpr std::uint16_t acceleration = 1U << 7U;
  static constexpr std::uint16_t deceleration = 1U << 8U;
  static constexpr std::uint16_t jerk = 1U << 9U;
  static constexpr std::uint16_t duration = 1U << 10U;
  static constexpr std::uint16_t usual_ramp = v1 | peak | acceleration | jerk | duration;
  static constexpr std::uint16_t corner = 0;
};

/// The places of the numbers of a usual ramp.
struct RampNumbers {
  static constexpr std::size_t length = 0;
  static constexpr std::size_t v1 = 1;
  static constexpr std::size_t peak = 2;
  static constexpr std::size_t acceleration = 3;
  static constexpr std::size_t jerk = 4;
  static constexpr std::size_t duration = 5;
  static constexpr std::uint32_t count = 6;
};
static_assert(RampNumbers::count == LawStretches::numbers_of_ramps);

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool is_constant(const LawInterval& s) {
  return s.v0 == s.peak && s.v1 == s.peak;
}

double expected_duration(const LawInterval& s) {
  return is_constant(s) ? s.length / s.peak : 0;
}

}  // namespace

void LawStretches::reserve(std::size_t stretches, std::size_t numbers) {
  profiles_detail::reserve_large(given_, stretches);
  profiles_detail::reserve_large(blocks_, stretches / in_a_block + 1);
  profiles_detail::reserve_large(numbers_, numbers);
}

void LawStretches::push_back(const LawInterval& s) {
  if (given_.size() % in_a_block == 0) {
    end_.time = s.time;
    end_.start = s.start;
    end_.v0 = s.v0;
    end_.piece = s.piece;
    blocks_.emplace_back();
    Block& block = blocks_.back();
    block.time = s.time;
    block.start = s.start;
    block.v0 = s.v0;
    block.piece = s.piece;
    block.data = static_cast<std::uint32_t>(numbers_.size());
  }
  const bool follows = same(s.time, end_.time) && same(s.start, end_.start) &&
                       same(s.v0, end_.v0) && s.piece == end_.piece && s.pieces == 1 &&
                       same(s.deceleration, s.acceleration);
  if (follows && s.acceleration < unlimited) {
    given_.push_back(Given::usual_ramp);
    // One by one: a copy of a local array would wait until the processor has stored it.
    for (const double* number : {&s.length, &s.v1, &s.peak, &s.acceleration, &s.jerk, &s.duration})
      numbers_.push_back(*number);
  } else if (follows && same(s.acceleration, unlimited) && same(s.jerk, unlimited) &&
             same(s.v1, s.v0) && same(s.peak, s.v0) && same(s.duration, s.length / s.peak)) {
    given_.push_back(Given::corner);
    numbers_.push_back(s.length);
  } else {
    push_unusual(s);
  }
  end_.time = s.time + s.duration;
  end_.start = s.start + s.length;
  end_.v0 = s.v1;
  end_.piece = s.piece + s.pieces;
}

void LawStretches::push_unusual(const LawInterval& s) {
  std::uint32_t flags = 0;
  const auto add = [&](std::uint32_t flag, double value, double expected) {
    if (same(value, expected)) return;
    flags |= flag;
    numbers_.push_back(value);
  };
  add(Given::time, s.time, end_.time);
  add(Given::start, s.start, end_.start);
  add(Given::v0, s.v0, end_.v0);
  add(Given::piece, s.piece, end_.piece);
  add(Given::pieces, s.pieces, 1);
  numbers_.push_back(s.length);
  add(Given::v1, s.v1, s.v0);
  add(Given::peak, s.peak, std::max(s.v0, s.v1));
  add(Given::acceleration, s.acceleration, unlimited);
  add(Given::deceleration, s.deceleration, s.acceleration);
  add(Given::jerk, s.jerk, unlimited);
  add(Given::duration, s.duration, expected_duration(s));
  given_.push_back(static_cast<std::uint16_t>(flags));
}

void LawStretches::shrink() {
  const auto trim = [](auto& memory) {
    if (memory.capacity() - memory.size() > memory.size() / 8) memory.shrink_to_fit();
  };
  trim(given_);
  trim(blocks_);
  trim(numbers_);
}

/// Reads the stretch whose expected start is in `now_`. Members are written one by one: a copy would wait for them.
void LawStretches::Iterator::read() {
  LawInterval& s = now_;
  const double* from = of_->numbers_.data() + data_;
  const std::uint32_t flags = of_->given_[index_];
  s.pieces = 1;
  if (flags == Given::usual_ramp) {
    s.length = from[RampNumbers::length];
    s.v1 = from[RampNumbers::v1];
    s.peak = from[RampNumbers::peak];
    s.acceleration = s.deceleration = from[RampNumbers::acceleration];
    s.jerk = from[RampNumbers::jerk];
    s.duration = from[RampNumbers::duration];
    data_ += RampNumbers::count;
    return;
  }
  if (flags == Given::corner) {
    s.length = *from;
    s.v1 = s.peak = s.v0;
    s.acceleration = s.deceleration = s.jerk = unlimited;
    s.duration = s.length / s.peak;
    ++data_;
    return;
  }
  const auto next = [&](std::uint32_t flag, double expected) {
    return (flags & flag) != 0 ? *from++ : expected;
  };
  s.time = next(Given::time, s.time);
  s.start = next(Given::start, s.start);
  s.v0 = next(Given::v0, s.v0);
  s.piece = static_cast<std::uint32_t>(next(Given::piece, s.piece));
  s.pieces = static_cast<std::uint32_t>(next(Given::pieces, 1));
  s.length = *from++;
  s.v1 = next(Given::v1, s.v0);
  s.peak = next(Given::peak, std::max(s.v0, s.v1));
  s.acceleration = next(Given::acceleration, unlimited);
  s.deceleration = next(Given::deceleration, s.acceleration);
  s.jerk = next(Given::jerk, unlimited);
  s.duration = next(Given::duration, expected_duration(s));
  data_ = static_cast<std::uint32_t>(from - of_->numbers_.data());
}

LawStretches::Iterator& LawStretches::Iterator::operator++() {
  if (++index_ == of_->size()) return *this;
  if (index_ % in_a_block == 0) {
    const Block& block = of_->blocks_[index_ / in_a_block];
    now_.time = block.time;
    now_.start = block.start;
    now_.v0 = block.v0;
    now_.piece = block.piece;
  } else {
    now_.time += now_.duration;
    now_.start += now_.length;
    now_.v0 = now_.v1;
    now_.piece += now_.pieces;
  }
  read();
  return *this;
}

double LawStretches::Iterator::next_time() const {
  const std::size_t next = index_ + 1;
  if (next == of_->size()) return unlimited;
  if (next % in_a_block == 0) return of_->blocks_[next / in_a_block].time;
  return (of_->given_[next] & Given::time) != 0 ? of_->numbers_[data_] : now_.time + now_.duration;
}

LawStretches::Iterator LawStretches::end() const {
  Iterator last;
  last.of_ = this;
  last.index_ = size();
  return last;
}

LawStretches::Iterator LawStretches::from(std::size_t index) const {
  if (index >= size()) return end();
  const std::size_t block = index / in_a_block;
  Iterator at(*this, block * in_a_block, blocks_[block]);
  while (at.index_ < index) ++at;
  return at;
}

LawStretches::Iterator LawStretches::at(double t, std::size_t block) const {
  // Usual stretches before t are passed: only the start of the next one is computed.
  auto [time, start, v0, piece, data] = blocks_[block];
  std::size_t index = block * in_a_block;
  const std::size_t last = std::min(index + in_a_block, size()) - 1;
  for (; index < last; ++index) {
    const double* from = numbers_.data() + data;
    const std::uint32_t flags = given_[index];
    const bool ramp = flags == Given::usual_ramp;
    if (!ramp && flags != Given::corner) break;
    const double end = time + (ramp ? from[RampNumbers::duration] : *from / v0);
    if (!(t >= end)) break;
    if ((given_[index + 1] & Given::time) != 0) break;
    time = end;
    start += *from;
    if (ramp) v0 = from[RampNumbers::v1];
    ++piece;
    data += ramp ? RampNumbers::count : 1;
  }
  Iterator at(*this, index, {time, start, v0, piece, data});
  while (at.index_ < last && t >= at.next_time()) ++at;
  return at;
}

std::vector<LawInterval> LawStretches::unpacked() const {
  std::vector<LawInterval> all;
  all.reserve(size());
  for (const LawInterval& s : *this) all.push_back(s);
  return all;
}

}  // namespace jounce
