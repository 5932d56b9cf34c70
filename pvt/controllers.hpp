#pragma once

#include <cstddef>
#include <span>

#include "jounce/pvt/pt.hpp"

/// What the controllers take of the time tables. Each throws InputError that names the point and the
/// controller's error where it has one.

namespace jounce::googol {

inline constexpr std::size_t pt_fifo = 1024;  ///< segments in a FIFO, memory 1 (32 with memory 0)

/// Times are a `long` of ms (GT_PtData, manual 7.4): whole numbers. A table that is played more often
/// than once (loops other than 1) stands in one static FIFO.
void require_pt(std::span<const PtPoint> points, std::size_t loops = 1);

}  // namespace jounce::googol

namespace jounce::himc {

inline constexpr std::size_t pvt_points = 50;

/// MovePVT (HMPL manual 5.2.8): at most 50 points, times from 0 and ascending (error 0x83aa08b6).
/// Limits of velocity (08a2) and acceleration (08ac) are those of the spec, which `check` holds exactly.
void require_pvt(std::span<const double> times);

}  // namespace jounce::himc
