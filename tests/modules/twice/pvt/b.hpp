// SPDX-License-Identifier: Apache-2.0
namespace jounce::detail {
template <int degree>
struct Piece {};
namespace {
struct Own {};
}  // namespace
}  // namespace jounce::detail
