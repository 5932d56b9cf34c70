// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "jounce/pvt/pt.hpp"

/// Limits of the controllers for tables over time. Each function throws InputError with the number
/// of the point and, if the controller has one, its error number.

namespace jounce::googol {

inline constexpr std::size_t pt_fifo = 1024;  ///< segments of a FIFO with memory 1; memory 0: 32

/// Greatest value of a `long` (32 bits) of the controller.
inline constexpr double largest_long = 2147483647;

/// Throws InputError unless GT_PtData (manual 7.4) accepts the points: each time is a `long`, so it
/// must be a whole number of ms, at most largest_long. A table that is played more than once
/// (`loops` other than 1) must fit into one static FIFO.
void require_pt(std::span<const PtPoint> points, std::size_t loops = 1);

/// Segments of a follow FIFO with memory 1; memory 0: 16.
inline constexpr std::size_t follow_fifo = 512;

/// Returns the rule that a master position of a follow table breaks, or "". GT_FollowData (manual
/// 7.6) accepts a `long`: whole pulses.
std::string broken_follow_rule(double master);

}  // namespace jounce::googol

namespace jounce::himc {

inline constexpr std::size_t pvt_points = 50;  ///< greatest number of points of MovePVT

/// Throws InputError unless MovePVT (HMPL manual 5.2.8) accepts the times: at most 50 points; the
/// times begin at 0 and ascend (error 0x83aa08b6).
void require_pvt(std::span<const double> times);

/// Returns the error number with which MovePVT rejects a table that exceeds a limit of the axis:
/// "0x83aa08a2" for the quantity "velocity", "0x83aa08ac" for "acceleration", "" for any other.
const char* pvt_limit_error(const std::string& quantity);

}  // namespace jounce::himc
