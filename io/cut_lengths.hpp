#pragma once

#include <string>
#include <vector>

#include "jounce/gear/cut_length_map.hpp"
#include "jounce/io/spec.hpp"

namespace jounce {

/// The cams that a spec of cuts makes over its cut length, all else as it says; and the lengths that
/// mean something, master unit.
struct CutLengths {
  CamOfLength cams;
  double shortest = 0;     ///< below it (or at it) there is no cam
  double synchronous = 0;  ///< where the slave is fastest for its limits: shorter cuts get slower
  struct Mark {
    double length = 0;
    std::string name = {};  ///< "synchronous", "longest without a stop"
  };
  std::vector<Mark> marks = {};
  double from = 0;  ///< a range that shows all of them
  double to = 0;
};

/// Throws InputError, placed in the document, for a kind that has no cut length.
CutLengths cut_lengths(const Spec& spec);

}  // namespace jounce
