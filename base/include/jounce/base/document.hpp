// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "jounce/base/hash.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {

/// A document that was read, with the place of every key. It turns an InputError of a generator,
/// which has only the key, into one that names file, line and column.
struct Document {
  struct Place {
    int line = 0;
    int column = 0;
  };

  std::string name;  ///< name given by the user
  std::string text;
  Sha256 hash{};  ///< hash of the text
  std::map<std::string, Place> places;
  std::map<std::string, std::string> units = {};  ///< unit of every plain number read
  std::map<std::string, std::string> given = {};  ///< unit of every number whose text names one

  /// The unit in which the text gives the number under `key`; `otherwise` for a plain number, and for a missing one.
  [[nodiscard]] std::string given_unit(const std::string& key, const std::string& otherwise) const;

  /// The error with the place of its key, or of the nearest enclosing key that is known.
  [[nodiscard]] InputError located(const InputError& error) const;
  /// An error about a file that this document names under `key`: with the place of the key if the
  /// file cannot be read at all, otherwise unchanged.
  [[nodiscard]] InputError naming(const std::string& key, const std::string& file,
                                  const InputError& error) const;
};

}  // namespace jounce
