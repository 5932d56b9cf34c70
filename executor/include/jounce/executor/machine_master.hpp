// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "jounce/axis/master.hpp"

namespace jounce {

/// A master of a machine, in the options of an executor. Follow::index is an index into the list of
/// masters.
struct MachineMaster {
  std::string name = {};  ///< name of the master, and of the channel of an ExternalMaster
  std::string unit = {};  ///< unit of the position
  std::shared_ptr<Master> source = {};  ///< computes the position
};

}  // namespace jounce
