// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "edit/src/editable.hpp"

/// The handles and tables of each kind of spec. A function does nothing for a spec of another kind.
namespace jounce::edit_detail {

void add_cam(Editable& editable);         ///< knots, points of segments, cam switches
void add_knots(Editable& editable);       ///< kind "pvt"
void add_time_table(Editable& editable);  ///< kind "pt"
void add_follow(Editable& editable);      ///< kind "follow"
void add_moves(Editable& editable);       ///< kinds "move", "queue" and "axes"
void add_path(Editable& editable);        ///< kind "path"

}  // namespace jounce::edit_detail
