// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "jounce/base/hash.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {

/// An input document, with the place of every key. A generator throws an InputError that contains
/// only the key; located() adds the file, line and column.
struct Document {
  /// Line and column of a key, from 1; 0: unknown.
  struct Place {
    int line = 0;
    int column = 0;
  };

  std::string name = {};                     ///< name of the file, as the user gave it
  std::string text = {};                     ///< the whole text
  Sha256 hash{};                             ///< SHA-256 of the text
  std::map<std::string, Place> places = {};  ///< place of each key, by its full name ("move.to")
  /// Unit of each number that was read and whose text has no unit, by key.
  std::map<std::string, std::string> units = {};
  std::map<std::string, std::string> given = {};  ///< unit of each number whose text has a unit
  /// Unit of each number that a reader has looked for, by key, even if the text does not have it.
  std::map<std::string, std::string> known = {};
  /// Unit of each quantity that rules name by words in front of its number: "master", "slope",
  /// "the slave travels".
  std::map<std::string, std::string> nouns = {};

  /// A number that the text gives under another key, in another unit.
  struct Given {
    std::string key = {};  ///< key in the text
    double factor = 1;     ///< factor to the number in the text
  };
  /// Numbers under another key, by the key that an error uses: a derivative with respect to the
  /// master that the text gives with respect to time.
  std::map<std::string, Given> converted = {};

  /// The files that this document names, and the files that those files name, if they were read. A
  /// path may end in # and the name of a sheet or a layer.
  std::vector<std::string> files = {};
  /// Returns the name of this document, and its files.
  [[nodiscard]] std::vector<std::string> all_files() const;

  /// Returns the unit that the text gives for the number under `key`. For a number without a unit,
  /// and for a missing number, returns `otherwise`.
  [[nodiscard]] std::string given_unit(const std::string& key, const std::string& otherwise) const;

  /// Returns the error with file, line and column of its key. If the key has no place, the error
  /// has the place of the nearest enclosing key. A number that must be greater than 0, and is 0
  /// because the text omits it, is reported as missing, with its unit. The numbers of the error get
  /// the units that the text uses: `must be at least 0.5 s; line_speed must be at most 29.6 m/min`.
  [[nodiscard]] InputError located(const InputError& error) const;
  /// Returns an error about the file `file`, which this document names under `key`. If the file
  /// cannot be read at all, the error gets the place of the key in this document; otherwise it is
  /// returned unchanged.
  [[nodiscard]] InputError naming(const std::string& key, const std::string& file,
                                  const InputError& error) const;
};

/// Returns a text with a unit after each number that follows one of these words; see
/// Document::nouns.
std::string with_units(const std::string& text, const std::map<std::string, std::string>& nouns);

}  // namespace jounce
