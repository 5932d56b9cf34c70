// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace jounce {

/// Writes a structured array in the NPY file format of NumPy
/// (https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html), row by row:
///
///     NpyFile file({{"case", NpyType::whole}, {"torque", NpyType::real}}, rows);
///     file.add(std::uint64_t{1}); file.add(2.5); ...
///     write_file("run.npy", file.bytes());
///
/// Type of a field: `whole` is an integer of 64 bits (signed in the file, '<i8'), `real` a double.
enum class NpyType { whole /**< 64 bits */, real /**< double */ };

/// A field of the rows.
struct NpyField {
  std::string name = {};         ///< name of the field
  NpyType type = NpyType::real;  ///< type of its values
};

/// The contents of an NPY file. Add the values row by row, in each row in the order of the fields.
class NpyFile {
 public:
  /// `rows`: number of rows that will be added.
  NpyFile(const std::vector<NpyField>& fields, std::size_t rows);

  /// Adds the next value, for a field of the type whole.
  void add(std::uint64_t value);
  /// Adds the next value, for a field of the type real.
  void add(double value);

  /// The content of the file.
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

}  // namespace jounce
