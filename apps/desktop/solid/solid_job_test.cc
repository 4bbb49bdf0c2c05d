#include "desktop/solid/solid_job.h"

#include <gtest/gtest.h>

#include "desktop/solid/testing/drawn_lines.h"

namespace felt::desktop::solid_job_test {
namespace {

using testing::draw_square;

class SolidJobTest : public ::testing::Test {
 protected:
  [[nodiscard]] SolidAnswer made(std::optional<double> gap_mm = std::nullopt,
                                 HoleChoice holes = HoleChoice::kFill) const {
    SolidRequest request;
    request.gap_mm = gap_mm;
    request.holes = holes;
    return make_solid(studio_.session().document(), request, is_cancelled_);
  }
  Studio studio_{testing::without_threads()};
  std::atomic<bool> is_cancelled_{false};
};

TEST_F(SolidJobTest, ACancelledJobHasNoBody) {
  draw_square(studio_, {10, 10}, 40.0);
  is_cancelled_ = true;
  EXPECT_FALSE(made().solid);
  is_cancelled_ = false;
  EXPECT_TRUE(made().solid);
}

TEST_F(SolidJobTest, ClosedLinesNeedTheSmallestGapOnly) {
  draw_square(studio_, {10, 10}, 40.0);
  draw_square(studio_, {60, 10}, 30.0, 1.5);
  const SolidAnswer answer = made();
  ASSERT_TRUE(answer.solid);
  EXPECT_EQ(answer.solid->bodies.size(), 2U);
  EXPECT_EQ(answer.gap_mm, 2.0);
  EXPECT_TRUE(answer.notes.empty());
  EXPECT_FALSE(answer.wider_gap_mm);
}

TEST_F(SolidJobTest, TheGapGrowsUntilMostOfTheDrawingIsClosed) {
  draw_square(studio_, {10, 10}, 15.0);
  draw_square(studio_, {40, 10}, 60.0, 7.0);
  const SolidAnswer answer = made();
  ASSERT_TRUE(answer.solid);
  EXPECT_EQ(answer.gap_mm, 8.0);
  EXPECT_EQ(answer.solid->bodies.size(), 2U);
  const SolidAnswer narrow = made(2.0);
  ASSERT_TRUE(narrow.solid) << "the small square is closed";
  EXPECT_EQ(narrow.gap_mm, 2.0);
  EXPECT_EQ(narrow.solid->bodies.size(), 1U);
  EXPECT_EQ(narrow.wider_gap_mm, 8.0) << "and the larger one is offered";
  EXPECT_FALSE(made(8.0).wider_gap_mm);
}

TEST_F(SolidJobTest, WithoutABodyItSaysWhyAndOffersAGap) {
  EXPECT_EQ(made().notes, std::vector<std::string>{"contains no visible strokes"});
  EXPECT_FALSE(made().wider_gap_mm);
  draw_square(studio_, {10, 10}, 60.0, 12.0);
  const SolidAnswer answer = made();
  EXPECT_FALSE(answer.solid);
  EXPECT_TRUE(answer.is_open);
  ASSERT_EQ(answer.notes.size(), 1U);
  EXPECT_NE(answer.notes[0].find("there is a gap of 12.00 mm"), std::string::npos)
      << answer.notes[0];
  ASSERT_EQ(answer.wider_gap_mm, 16.0);
  EXPECT_TRUE(made(answer.wider_gap_mm).solid) << "the offer closes the line";
}

TEST_F(SolidJobTest, HolesStayIfTheyAreWanted) {
  draw_square(studio_, {10, 10}, 60.0);
  draw_square(studio_, {30, 30}, 20.0);
  EXPECT_EQ(made().solid->bodies.at(0).holes, 0);
  EXPECT_EQ(made({}, HoleChoice::kKeep).solid->bodies.at(0).holes, 1);
}

TEST_F(SolidJobTest, LinesInsideArePaintedOnTheBody) {
  draw_square(studio_, {10, 10}, 60.0);
  EXPECT_FALSE(made().paint);
  testing::draw_lines(studio_, {{30, 30}, {50, 30}});
  const SolidAnswer answer = made();
  ASSERT_TRUE(answer.paint);
  const Vec px =
      answer.paint->to_px({40.0 - answer.solid->origin.x, answer.solid->origin.y - 30.0, 0.0});
  EXPECT_EQ(answer.paint->ink.at(static_cast<int>(px.x), static_cast<int>(px.y)).a, 255);
}

TEST_F(SolidJobTest, AnEightLosesItsSmallerPartAndTheOthersStay) {
  draw_square(studio_, {100, 10}, 40.0);
  testing::draw_lines(studio_, {{0, 0}, {40, 40}, {40, 0}, {10, 30}, {0, 0}});
  const SolidAnswer answer = made();
  ASSERT_TRUE(answer.solid);
  EXPECT_EQ(answer.solid->bodies.size(), 2U);
  ASSERT_EQ(answer.notes.size(), 1U);
  EXPECT_NE(answer.notes[0].find("left out the smaller part"), std::string::npos);
}

}  // namespace
}  // namespace felt::desktop::solid_job_test
