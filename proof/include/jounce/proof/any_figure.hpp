// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/plot/figure.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {

/// The picture of a file that `jounce plot` draws.
struct FigureRequest {
  std::string file = {};     ///< spec, table, or G-code program with `machine`
  std::string axis = {};     ///< name of one axis; "": all
  std::string machine = {};  ///< spec of kind "path" for a G-code program
  std::string over = {};     ///< "master", "time", or "": as the file describes it
  std::string before = {};   ///< file that is drawn paler underneath
  std::string drive = {};    ///< name for drive_figure() or loop_figure()
  bool follower = false;     ///< true: the follower of a cam
  std::string output = {};  ///< file for the picture, which must not be one of the inputs; "": none
};

/// Returns the picture; does not write it to a file. Throws InputError with the name of a member
/// for a request that does not fit the file.
Figure any_figure(const FigureRequest& request);

}  // namespace jounce
