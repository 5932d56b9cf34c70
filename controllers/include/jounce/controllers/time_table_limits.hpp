// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "jounce/pvt/pt.hpp"

/// Limits of the controllers for time tables. Each throws InputError that names the point and the
/// controller's error, if it has one.

namespace jounce::googol {

inline constexpr std::size_t pt_fifo = 1024;  ///< segments in a FIFO, memory 1 (32 with memory 0)

inline constexpr double largest_long = 2147483647;  ///< largest long of 32 bits on the controller

/// Times are a `long` of ms (GT_PtData, manual 7.4): whole numbers up to largest_long. A table that is
/// played more than once (loops other than 1) must fit in one static FIFO.
void require_pt(std::span<const PtPoint> points, std::size_t loops = 1);

inline constexpr std::size_t follow_fifo =
    512;  ///< segments of a follow table, memory 1 (16 with 0)

/// The rule that a master position of a follow table breaks: GT_FollowData (7.6) takes a `long` of
/// whole pulses. "" if it breaks none.
std::string broken_follow_rule(double master);

}  // namespace jounce::googol

namespace jounce::himc {

inline constexpr std::size_t pvt_points = 50;

/// MovePVT (HMPL manual 5.2.8): at most 50 points, times from 0 and ascending (error 0x83aa08b6).
void require_pvt(std::span<const double> times);

/// The error by which MovePVT refuses a table that breaks a limit of the axis; "" for other quantities.
const char* pvt_limit_error(const std::string& quantity);

}  // namespace jounce::himc
