// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/detail/table_store.hpp"

#include <gtest/gtest.h>

#include "stream/harness.hpp"

namespace jounce::table_store_test {
namespace {

/// A linear table of n knots: 16 n bytes.
StoredTable stored(std::size_t knots, std::uint8_t mark) {
  StoredTable result;
  result.hash[0] = mark;
  result.table = std::make_shared<const Table>(test::sine_table(knots, Interpolation::linear));
  return result;
}

void put(TableStore& store, StoredTable table) {
  ASSERT_TRUE(store.reserve(16 * table.table->size()));
  store.put(std::move(table));
}

TEST(TableStore, FindsByHash) {
  TableStore store(1000);
  put(store, stored(10, 1));
  EXPECT_TRUE(store.find(stored(2, 1).hash).has_value());
  EXPECT_FALSE(store.find(stored(2, 2).hash).has_value());
  EXPECT_EQ(store.bytes(), 160U);
}

TEST(TableStore, MakesRoomByTheOldest) {
  TableStore store(480);
  for (std::uint8_t mark = 1; mark <= 3; ++mark) put(store, stored(10, mark));
  put(store, stored(10, 4));
  EXPECT_FALSE(store.find(stored(2, 1).hash).has_value());
  EXPECT_TRUE(store.find(stored(2, 2).hash).has_value());
  EXPECT_EQ(store.bytes(), 480U);
}

TEST(TableStore, KeepsWhatSomebodyHolds) {
  TableStore store(320);
  const StoredTable played = stored(10, 1);
  put(store, played);
  put(store, stored(10, 2));
  put(store, stored(10, 3));
  EXPECT_TRUE(store.find(played.hash).has_value());
  EXPECT_FALSE(store.find(stored(2, 2).hash).has_value());
  EXPECT_FALSE(store.reserve(161)) << "the held one and a third do not fit";
  EXPECT_TRUE(store.reserve(160));
}

TEST(TableStore, RejectsWhatCannotFitWithoutLosingAnything) {
  TableStore store(320);
  put(store, stored(10, 1));
  EXPECT_FALSE(store.reserve(321));
  EXPECT_EQ(store.tables(), 1U);
  ASSERT_TRUE(store.reserve(160));
  store.release(160);
  EXPECT_EQ(store.bytes(), 160U);
}

}  // namespace
}  // namespace jounce::table_store_test
