#include "felt/solid/outlines.h"

#include <gtest/gtest.h>

#include <cmath>

#include "felt/fill/curve_area.h"
#include "felt/solid/testing/solid_drawings.h"

namespace felt::outlines_test {
namespace {

using testing::SolidDrawing;

FoundOutlines found(const SolidDrawing& drawing, HoleChoice holes = HoleChoice::kKeep) {
  Result<FoundOutlines> result = find_outlines(drawing.document, 2.0, holes);
  EXPECT_TRUE(result) << result.error().message;
  return result ? *std::move(result) : FoundOutlines();
}

TEST(SolidOutlines, OverlappingShapesJoinAndLinesAcrossDoNotDivide) {
  SolidDrawing drawing;
  drawing.polygon({{0, 0}, {40, 0}, {40, 20}, {0, 20}});
  drawing.polygon({{30, -10}, {60, -10}, {60, 10}, {30, 10}});
  drawing.polyline({{5, -5}, {5, 25}});
  const FoundOutlines result = found(drawing);
  ASSERT_EQ(result.outlines.size(), 1U);
  ASSERT_EQ(result.outlines[0].loops.size(), 1U);
  EXPECT_NEAR(std::fabs(loop_area(result.outlines[0].loops[0])), 800.0 + 600.0 - 100.0, 1e-6);
  EXPECT_EQ(result.outlines[0].stroke, StrokeId{1});
}

TEST(SolidOutlines, ALineInsideIsAHoleAndALineInTheHoleABody) {
  SolidDrawing drawing;
  drawing.circle({50, 50}, 40.0);
  drawing.circle({50, 50}, 20.0);
  drawing.circle({50, 50}, 8.0);
  drawing.circle({150, 50}, 10.0);
  const FoundOutlines result = found(drawing);
  ASSERT_EQ(result.outlines.size(), 3U);
  std::size_t holes = 0;
  for (const SolidOutline& outline : result.outlines) holes += outline.loops.size() - 1;
  EXPECT_EQ(holes, 1U);
  const FoundOutlines filled = found(drawing, HoleChoice::kFill);
  ASSERT_EQ(filled.outlines.size(), 2U);
  for (const SolidOutline& outline : filled.outlines) EXPECT_EQ(outline.loops.size(), 1U);
}

TEST(SolidOutlines, SeveralStrokesAndSmallGapsMakeOneOutline) {
  SolidDrawing drawing;
  drawing.polyline({{0, 0}, {40, 0}, {40, 30}});
  drawing.polyline({{38.9, 31}, {0, 30}, {0, 1.5}});
  const FoundOutlines result = found(drawing);
  ASSERT_EQ(result.outlines.size(), 1U);
  EXPECT_NEAR(std::fabs(loop_area(result.outlines[0].loops[0])), 1200.0, 60.0);
}

TEST(SolidOutlines, TheCurlWhereAHandClosesALineIsLeftOut) {
  SolidDrawing drawing;  // crosses itself at the start and makes a curl outside
  drawing.polyline({{0, 0}, {40, 0}, {40, 30}, {0, 30}, {0, -2}, {-1.5, -2}, {-1.5, 1}, {3, -1}});
  const FoundOutlines result = found(drawing);
  ASSERT_EQ(result.outlines.size(), 1U);
  EXPECT_NEAR(std::fabs(loop_area(result.outlines[0].loops[0])), 1200.0, 5.0);
}

TEST(SolidOutlines, SmallLoopsAreLeftOutWithANote) {
  SolidDrawing drawing;
  drawing.circle({50, 50}, 40.0);
  drawing.circle({120, 50}, 0.3);
  const FoundOutlines result = found(drawing);
  EXPECT_EQ(result.outlines.size(), 1U);
  ASSERT_EQ(result.notes.size(), 1U);
  EXPECT_EQ(result.notes[0],
            "left out 1 small closed line, of stroke s2 at (120.30, 50.00) mm, 0.60 x 0.60 mm");
}

TEST(SolidOutlines, HiddenLayersDoNotCount) {
  SolidDrawing drawing;
  drawing.circle({50, 50}, 40.0);
  Edit hide;
  const Layer& layer = drawing.document.layers().front();
  LayerState hidden = layer.state();
  hidden.visible = false;
  hide.layers.push_back({layer.id, layer.state(), hidden, 0, 0});
  ASSERT_TRUE(drawing.document.apply(hide));
  EXPECT_FALSE(find_outlines(drawing.document, 2.0, HoleChoice::kKeep));
}

// Hatching inside a body: its lines cross, and enclose small areas that meet in points.
TEST(SolidOutlines, LinesInsideAFilledOutlineMayCross) {
  testing::SolidDrawing drawing;
  drawing.polygon({{0, 0}, {100, 0}, {100, 100}, {0, 100}});
  drawing.polyline({{20, 20}, {60, 60}, {60, 20}, {20, 60}, {20, 20}});
  const auto kept = find_outlines(drawing.document, 2.0, HoleChoice::kKeep, FaultChoice::kRefuse);
  EXPECT_FALSE(kept);
  const auto filled = find_outlines(drawing.document, 2.0, HoleChoice::kFill, FaultChoice::kRefuse);
  ASSERT_TRUE(filled) << filled.error().message;
  EXPECT_EQ(filled->outlines.size(), 1U);
  EXPECT_TRUE(filled->notes.empty());
}

}  // namespace
}  // namespace felt::outlines_test
