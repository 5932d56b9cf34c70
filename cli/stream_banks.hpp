#pragma once

#include <cstdint>
#include <string>

#include "link.hpp"

namespace jounce::cli {

/// Two tables as the banks of a static queue: the first is played once, then the second
/// `loops` times.
struct BankOptions {
  std::string first, second;  ///< specs or tables
  std::string axis;           ///< of a spec of several axes; may be empty
  std::string to;             ///< name of the executor
  std::int32_t loops = 1;     ///< of the second
  LinkOptions link;
  bool json = false;
};

/// Until the second one has ended: the exit status. Ctrl-C stops the axis.
int stream_banks(const BankOptions& options);

}  // namespace jounce::cli
