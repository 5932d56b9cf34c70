// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/indexer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"
#include "support/invariants.hpp"

namespace jounce::indexer_test {
namespace {

TEST(Indexer, IsThePrintedExampleOfCodesys) {
  // 2000 ms a cycle: a table by 45 deg in 400 ms, then a feed by 250 mm in 200 ms.
  const SyncCam table = indexer({.distance = 45, .cycle = 2, .motion = 0.4});
  const Ranges peaks = extrema(table.cam);
  EXPECT_NEAR(peaks[1].max.value, 210.9375, 1e-9);
  EXPECT_NEAR(peaks[2].max.value, 1623.798, 5e-4);
  EXPECT_NEAR(peaks[3].max.value, 42187.5, 1e-6);
  EXPECT_EQ(table.segments, (std::vector<std::string>{"index", "dwell"}));

  const SyncCam feed = indexer({.distance = 250, .cycle = 2, .motion = 0.2, .before = 0.4});
  EXPECT_NEAR(feed.cam.jet(0.4)[0], 0, 1e-12);
  EXPECT_EQ(feed.cam.jet(0.3)[1], 0);
  EXPECT_NEAR(feed.cam.jet(0.5)[1], 15.0 / 8 * 250 / 0.2, 1e-9);
  EXPECT_NEAR(feed.cam.jet(0.6)[0], 250, 1e-12);
  EXPECT_EQ(feed.segments, (std::vector<std::string>{"dwell", "index", "dwell"}));
}

TEST(Indexer, ContinuesForEverWithoutDrift) {
  const SyncCam back = indexer({.distance = -45, .cycle = 360, .motion = 30, .count = 8});
  EXPECT_EQ(back.cam.jet(31)[0], -45);
  EXPECT_EQ(back.cam.jet(360e9 + 31)[0], -360e9 - 45);
  EXPECT_EQ(back.cam.jet(-360e9 + 31)[0], 360e9 - 45);
}

TEST(Indexer, CountsItsPartsAndClosesToTheBit) {
  const SyncCam made =
      indexer({.distance = 60, .cycle = 360, .motion = 40, .before = 10, .count = 6});
  EXPECT_EQ(made.cam.end(), 360);
  EXPECT_EQ(made.cam.advance(), 360);
  EXPECT_EQ(made.zones.size(), 12U);
  for (int turn = 0; turn < 3; ++turn)
    for (int i = 0; i < 6; ++i) {
      EXPECT_EQ(made.cam.jet(360 * turn + 60 * i + 5)[0], 360 * turn + 60 * i);
      EXPECT_EQ(made.cam.jet(360 * turn + 60 * i + 55)[0], 360 * turn + 60 * i + 60);
    }
  EXPECT_EQ(made.cam.jet(360e9 + 5)[0], 360e9);
  test::expect_invariants(made.cam, 2);
}

TEST(Indexer, MayMoveWithoutADwell) {
  const SyncCam made = indexer({.distance = 1, .cycle = 1, .motion = 1.0 / 3, .count = 3});
  EXPECT_EQ(made.segments.size(), 3U);
  EXPECT_TRUE(made.zones.empty());
  EXPECT_EQ(made.cam.end(), 1);
  EXPECT_EQ(made.cam.advance(), 3);
}

TEST(Indexer, TakesEveryLawFromRestToRest) {
  for (const LawInfo& each : all_laws()) {
    Indexer spec{.distance = 7, .cycle = 3, .motion = 1.1, .before = 0.1, .law = each.law};
    if (each.law == Law::scca) spec.form.shares = {{0.25, 0.25, 0.5}};
    SCOPED_TRACE(each.name);
    if (each.ends == Ends::straight || each.ends == Ends::standing || reverses(each.ends) ||
        !has_own_shape(each.law)) {
      EXPECT_THROW(indexer(spec), InputError);
      continue;
    }
    const SyncCam made = indexer(spec);
    test::expect_invariants(made.cam, 1);
    EXPECT_EQ(made.cam.end(), 3);
    EXPECT_EQ(made.cam.advance(), 7);
  }
}

std::string refusal(const Indexer& spec) {
  return test::error_of([&] { (void)indexer(spec); });
}

TEST(Indexer, ReportsContradictions) {
  using ::testing::StartsWith;
  EXPECT_THAT(refusal({.distance = 1, .cycle = 10, .motion = 8, .before = 3}),
              StartsWith("motion = 8: must be at most 7"));
  EXPECT_THAT(refusal({.distance = 0, .cycle = 10, .motion = 8}), StartsWith("distance = 0"));
  EXPECT_THAT(refusal({.distance = 1, .cycle = 10, .motion = 1, .count = 0}),
              StartsWith("count = 0"));
  EXPECT_THAT(refusal({.distance = 1, .cycle = -1, .motion = 1}), StartsWith("cycle = -1"));
}

}  // namespace
}  // namespace jounce::indexer_test
