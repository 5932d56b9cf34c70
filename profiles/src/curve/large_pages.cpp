// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/detail/large_pages.hpp"

#include <cerrno>
#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace jounce::profiles_detail {

void prefer_large_pages([[maybe_unused]] void* block, [[maybe_unused]] std::size_t bytes) noexcept {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::size_t large = std::size_t{1} << 21U;
  const std::size_t before = -reinterpret_cast<std::uintptr_t>(block) % large;
  if (bytes < before + large) return;
  const int error = errno;
  madvise(static_cast<char*>(block) + before, (bytes - before) / large * large, MADV_HUGEPAGE);
  errno = error;  // a kernel without large pages is not an error of the caller
#endif
}

}  // namespace jounce::profiles_detail
