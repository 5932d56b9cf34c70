#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "jounce/io/spec.hpp"

namespace jounce {

/// A spec whose numbers can be changed by the name of their place, in its text: comments, order and
/// layout stay, so that what was chosen can be written back and shows as a small diff.
///
///     SpecNumbers cam(read_document("cam.toml"));
///     cam.value("segment[2].end.master");                                  // 120
///     Spec other = cam.spec({{"segment[2].end.master", "125 deg"}});
///
/// Keys are those of the file, entries of arrays of tables counted from 1, as in error messages:
/// "move.velocity", "segment[3].end.slave", "drive.mass[1].inertia". A value is a number in the unit
/// that the spec has there, or a quantity with a unit. A number that the file leaves out, and a value
/// that is no number, cannot be changed: InputError with key and rule.
class SpecNumbers {
 public:
  explicit SpecNumbers(Document document);

  struct Change {
    std::string key;
    double value = 0;  ///< counted in what the file counts it in there ("12.5 mm/s": mm/s)
  };

  [[nodiscard]] double value(const std::string& key) const;
  /// As written behind the number; "" where the file gives none (the spec's own unit).
  [[nodiscard]] std::string unit(const std::string& key) const;
  [[nodiscard]] std::string text(std::span<const Change> changes) const;
  [[nodiscard]] Spec spec(std::span<const Change> changes) const;  ///< parsed from text()

 private:
  Document document_;
};

}  // namespace jounce
