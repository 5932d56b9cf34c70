// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <thread>
#include <vector>

#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/curve/curve.hpp"
#include "jounce/pvt/table.hpp"

/// Names that the C++ lines of the pages use and that a reader brings along. They are declared only: the lines are
/// compiled and never run.
namespace jounce::pages {

extern const Cam cam, shaft, f, g, before, after;
extern const CamSpec spec;
extern const Trajectory move, motion, master;
extern const Table table;
extern const std::vector<double> ways, v, a, j;
constexpr double pi = std::numbers::pi;
constexpr double deg = pi / 180;

void use(const auto&... values);
void show(const auto& value);
void output(double x, double y);

}  // namespace jounce::pages
