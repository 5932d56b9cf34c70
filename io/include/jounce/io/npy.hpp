// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace jounce {

/// A structured array in NumPy's file format, row by row:
///
///     NpyFile file({{"case", NpyType::whole}, {"torque", NpyType::real}}, rows);
///     file.add(std::uint64_t{1}); file.add(2.5); ...
///     write_file("run.npy", file.bytes());
///
/// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
enum class NpyType { whole /**< 64 bits */, real /**< double */ };

struct NpyField {
  std::string name;
  NpyType type = NpyType::real;
};

class NpyFile {
 public:
  NpyFile(const std::vector<NpyField>& fields, std::size_t rows);

  void add(std::uint64_t value);
  void add(double value);

  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

}  // namespace jounce
