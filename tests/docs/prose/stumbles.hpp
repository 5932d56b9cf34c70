// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Of no use.
inline const char* const message = "The executor says so.";
inline int count = 0;  ///< how many there are
inline int begin = 2;  ///< the first tick,
                       ///< of which the comment goes on
/// The count, 0 for "nobody".
inline int others = 0;
