#pragma once

#include "jounce/io/detail/toml_reader.hpp"
#include "jounce/io/spec.hpp"

/// The parts of a spec, each read from its own tables of the document.
namespace jounce::detail {

/// start, [[segment]] with what is free, and periodic.
CamSpec read_cam(TomlReader& top, const Units& units, OptimizeSpec& optimize);

/// [optimize].
void read_optimize(TomlReader& top, OptimizeSpec& optimize);

/// [move], [[knot]], [axis].
MoveSpec read_move(TomlReader move, const Units& units);
Table read_knots(TomlReader& top, const Units& units, Rule rule);
AxisSpec read_axis(TomlReader axis, const Units& units);

/// [drive] and [drive.limits], where there is one.
std::optional<DriveSpec> read_drive(TomlReader& top, const Units& units);

}  // namespace jounce::detail
