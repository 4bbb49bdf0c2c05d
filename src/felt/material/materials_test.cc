#include "felt/material/materials.h"
#include "felt/geometry/tilt.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>

namespace felt::materials_test {
namespace {

TEST(Materials, EachHasAnIdOfItsOwnAndALabel) {
  std::set<std::string> ids;
  for (const SurfaceMaterial& surface : surface_materials()) {
    EXPECT_TRUE(ids.insert(surface.id).second) << surface.id;
    EXPECT_FALSE(surface.label.empty()) << surface.id;
    EXPECT_EQ(find_surface(surface.id), &surface);
  }
  ids.clear();
  for (const Medium& medium : media()) {
    EXPECT_TRUE(ids.insert(medium.id).second) << medium.id;
    EXPECT_FALSE(medium.label.empty()) << medium.id;
    EXPECT_EQ(find_medium(medium.id), &medium);
  }
  EXPECT_EQ(surface_materials().front().id, "paper");
  EXPECT_EQ(media().front().id, "pencil");
  EXPECT_EQ(find_surface("marble"), nullptr);
  EXPECT_EQ(find_medium(""), nullptr);
}

TEST(Materials, PuttingOneReplacesTheOneOfThatIdInItsPlace) {
  Materials all = Materials::built_in();
  const std::size_t count = all.media().size();
  Medium mine = *find_medium("chalk");
  mine.friction = 0.7;
  all.put(mine);
  EXPECT_EQ(all.media().size(), count);
  EXPECT_EQ(all.find_medium("chalk")->friction, 0.7);
  mine.id = "my-chalk";
  all.put(mine);
  EXPECT_EQ(all.media().size(), count + 1);
  EXPECT_EQ(all.media().back().id, "my-chalk");
  EXPECT_EQ(find_medium("my-chalk"), nullptr);  // the built-in ones do not change
}

TEST(Materials, APairsOwnFrictionGoesBeforeTheProduct) {
  Medium chalk = *find_medium("chalk");
  chalk.pairs.clear();
  const SurfaceMaterial& board = *find_surface("blackboard");
  EXPECT_DOUBLE_EQ(friction_of(chalk, board),
                   chalk.friction * board.friction / find_surface("paper")->friction);
  chalk.pairs = {{"glass", 0.1}, {"blackboard", 0.55}};
  EXPECT_DOUBLE_EQ(friction_of(chalk, board), 0.55);
}

TEST(Materials, TheRuleForPairsKeepsToWhatATextMaySay) {
  Medium glue = *find_medium("eraser");
  SurfaceMaterial rubber = *find_surface("rough-paper");
  glue.pairs.clear();
  glue.friction = rubber.friction = kMaxFriction;
  EXPECT_DOUBLE_EQ(friction_of(glue, rubber), kMaxFriction);
  glue.friction = 0.0;
  EXPECT_EQ(friction_of(glue, rubber), 0.0);
}

TEST(Materials, EveryMediumIsVisibleOnEverySurface) {
  const auto is_visible = [](std::uint32_t ink, std::uint32_t surface) {
    int squares = 0;
    for (const unsigned shift : {0U, 8U, 16U}) {
      const int off =
          static_cast<int>(ink >> shift & 0xFFU) - static_cast<int>(surface >> shift & 0xFFU);
      squares += off * off;
    }
    return squares > 60 * 60;
  };
  const std::uint32_t chalk = find_medium("chalk")->color_rgb;
  EXPECT_EQ(ink_color_on(chalk, find_surface("blackboard")->color_rgb), chalk);
  EXPECT_FALSE(is_visible(chalk, 0xFFFFFF));
  for (const Medium& medium : media()) {
    for (const SurfaceMaterial& surface : surface_materials()) {
      EXPECT_TRUE(is_visible(ink_color_on(medium.color_rgb, surface.color_rgb), surface.color_rgb))
          << medium.id << " on " << surface.id;
    }
  }
}

TEST(Materials, OnlyWhatTiltsFartherThanAHandAtRestCounts) {
  EXPECT_EQ(tilt_share(0.0), 0.0);
  EXPECT_EQ(tilt_share(kFreeTiltDeg), 0.0);
  EXPECT_DOUBLE_EQ(tilt_share(0.5 * (kFreeTiltDeg + kFullTiltDeg)), 0.5);
  EXPECT_EQ(tilt_share(90.0), 1.0);
  EXPECT_EQ(tilt_share(std::numeric_limits<double>::quiet_NaN()), 0.0);
}

TEST(Materials, AFirmPushFlattensTheReliefByTheWearAndNoFarther) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(relief_left(0.0, 1.0), 1.0);
  EXPECT_EQ(relief_left(0.6, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(relief_left(0.6, 0.5), 0.7);
  EXPECT_DOUBLE_EQ(relief_left(0.6, 1.0), 0.4);
  for (const double wear : {-1.0, 0.0, 0.3, 1.0, 7.0, nan, inf, -inf}) {
    double last = 1.0;
    for (const double firmness : {-inf, -1.0, 0.0, 0.2, 0.9, 1.0, 3.0, inf}) {
      const double left = relief_left(wear, firmness);
      EXPECT_GE(left, 0.0);
      EXPECT_LE(left, last) << wear << " " << firmness;
      last = left;
    }
    EXPECT_EQ(relief_left(wear, nan), 1.0);
  }
}

}  // namespace
}  // namespace felt::materials_test
