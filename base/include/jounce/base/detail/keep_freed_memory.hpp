// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <malloc.h>

namespace jounce {

/// For the start of a program: freed memory stays in the process, at most 1 GiB. Otherwise, the C library returns each
/// large block to the system, and the next plan gets it back page by page, which takes up to a third of its time. A
/// library does not call this, because it concerns the whole process.
inline void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int most_kept = 1 << 30;  // bytes
  mallopt(M_TRIM_THRESHOLD, most_kept);
  mallopt(M_MMAP_MAX, 0);
#endif
}

}  // namespace jounce
