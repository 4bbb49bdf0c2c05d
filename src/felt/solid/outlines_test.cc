#include "felt/solid/outlines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

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

/// A circle as a closed stroke of this width.
StrokePtr wide_circle(double radius_mm, double width_mm) {
  std::vector<Point> at;
  for (int i = 0; i < 40; ++i) {
    const double a = 2.0 * std::numbers::pi * i / 40;
    at.push_back({100.0 + radius_mm * std::cos(a), 100.0 + radius_mm * std::sin(a)});
  }
  StrokeData data = testing::stroke_of(testing::smooth_ring(at), true)->data();
  for (WidthKnot& knot : data.widths) knot.width_mm = width_mm;
  return std::make_shared<const Stroke>(Stroke::create(std::move(data)).value());
}

TEST(SolidOutlines, AnOutlineThatIsDrawnAgainBesideItselfIsOneOutline) {
  for (const int passes : {2, 3}) {
    SolidDrawing drawing;
    for (int i = 0; i < passes; ++i) drawing.add(wide_circle(30.0 - 0.3 * i, 1.0));
    drawing.add(wide_circle(10.0, 1.0));  // a true hole
    const FoundOutlines result = found(drawing);
    ASSERT_EQ(result.outlines.size(), 1U);
    EXPECT_EQ(result.outlines[0].loops.size(), 2U);
    ASSERT_EQ(result.notes.size(), static_cast<std::size_t>(passes - 1));
    EXPECT_EQ(result.notes[0],
              "stroke s2 retraces the outline of stroke s1 at a distance of 0.30 mm; it was not "
              "treated as a hole");
  }
  SolidDrawing ring;  // paper is seen between the lines
  ring.add(wide_circle(30.0, 0.3));
  ring.add(wide_circle(29.0, 0.3));
  EXPECT_EQ(found(ring).outlines.at(0).loops.size(), 2U);
}

TEST(SolidOutlines, NoiseIsRefusedWithTheReason) {
  Random random(1);
  // No segment is shorter than a stroke may have.
  std::vector<Point> noise, smooth;
  for (int i = 0; i < 60'000; ++i) {
    const double a = 2.0 * std::numbers::pi * i / 60'000;
    const double r = 80.0 + (i % 2 == 0 ? 1.0 : -1.0) * random.between(0.5, 1.0);
    noise.push_back({100.0 + r * std::cos(a), 100.0 + r * std::sin(a)});
    if (i % 12 != 0) continue;
    smooth.push_back({100.0 + 80.0 * std::cos(a), 100.0 + 80.0 * std::sin(a)});
  }
  // As strokes of 5,000 points: a stroke has a limit.
  const auto drawing_of = [](const std::vector<Point>& ring) {
    SolidDrawing drawing;
    for (std::size_t i = 0; i < ring.size(); i += 5000) {
      std::vector<Point> part(ring.begin() + static_cast<std::ptrdiff_t>(i),
                              ring.begin() + static_cast<std::ptrdiff_t>(i + 5000));
      part.push_back(ring[(i + 5000) % ring.size()]);
      drawing.polyline(part);
    }
    return drawing;
  };
  const SolidDrawing rough = drawing_of(noise);
  const Result<FoundOutlines> result = find_outlines(rough.document, 2.0, HoleChoice::kKeep);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kLimitExceeded);
  EXPECT_EQ(result.error().message.find("the lines are too dense at ("), 0U)
      << result.error().message;
  EXPECT_EQ(found(drawing_of(smooth)).outlines.size(), 1U);
}

}  // namespace
}  // namespace felt::outlines_test
