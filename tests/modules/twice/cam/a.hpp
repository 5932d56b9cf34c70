// SPDX-License-Identifier: Apache-2.0
namespace jounce::detail {
struct Piece {
  int of_a_cam = 0;
};
}  // namespace jounce::detail
