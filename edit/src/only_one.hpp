// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce::edit_detail {

/// Permits one editor for each file on this computer, until the object or its process ends.
class OnlyOne {
 public:
  /// Throws InputError if another editor has the file open.
  explicit OnlyOne(const std::string& path);
  ~OnlyOne();
  OnlyOne(const OnlyOne&) = delete;
  OnlyOne& operator=(const OnlyOne&) = delete;

 private:
  int socket_;
};

}  // namespace jounce::edit_detail
