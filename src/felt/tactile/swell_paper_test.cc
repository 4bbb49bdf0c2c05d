#include "felt/tactile/swell_paper.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "felt/document/edit_builder.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/tactile/line_widths.h"

namespace felt::swell_paper_test {
namespace {

struct Drawn {
  Drawing drawing;

  StrokeId line(Point from, Point to, double width_mm, double end_mm, Rgba color = {}) {
    StrokeData data = testing::straight_stroke(from, to, width_mm, end_mm).data();
    data.color = color;
    EditBuilder edit(drawing.document);
    const StrokeId id =
        edit.add({1}, std::make_shared<const Stroke>(Stroke::create(std::move(data)).value()));
    EXPECT_TRUE(drawing.document.apply(std::move(edit).build("Draw")));
    return id;
  }
  void fill(Point at, double width, double height, Rgba color) {
    FillLoop loop{{at}, {}};
    for (const Vec v : {Vec{width, 0}, Vec{width, height}, Vec{0, height}, Vec{0, 0}}) {
      loop.points.insert(loop.points.end(), {loop.points.back(), at + v, at + v});
    }
    EditBuilder edit(drawing.document);
    edit.add_fill({1}, std::make_shared<const Fill>(Fill{{loop}, color, 0.0}));
    EXPECT_TRUE(drawing.document.apply(std::move(edit).build("Fill")));
  }
  Drawing swell() {
    Result<Drawing> made = prepare_for_swell_paper(drawing, report);
    EXPECT_TRUE(made);
    return *std::move(made);
  }
  SwellReport report;
};

std::vector<StrokePtr> strokes_of(const Drawing& drawing) {
  std::vector<StrokePtr> all;
  for (const Layer& layer : drawing.document.layers()) {
    for (const StrokeId id : layer.strokes) all.push_back(drawing.document.find(id));
  }
  return all;
}

TEST(SwellPaper, LinesAreBlackAndHaveAtMostFiveWidths) {
  Drawn drawn;
  for (int i = 0; i < 9; ++i) {
    drawn.line({20, 20.0 + 20 * i}, {80, 20.0 + 20 * i}, 0.2 + 0.5 * i, 0.4 + 0.5 * i,
               {200, 30, 30, 128});
  }
  const Drawing swell = drawn.swell();
  std::vector<double> widths;
  for (const StrokePtr& stroke : strokes_of(swell)) {
    EXPECT_EQ(stroke->color(), (Rgba{0, 0, 0, 255}));
    EXPECT_EQ(stroke->medium(), "ink-pen");
    EXPECT_EQ(stroke->width_mm(0.0), stroke->width_mm(1.0));
    widths.push_back(stroke->width_mm(0.0));
  }
  EXPECT_GE(widths.front(), SwellRules::kLineMm);
  std::sort(widths.begin(), widths.end());
  widths.erase(std::unique(widths.begin(), widths.end()), widths.end());
  EXPECT_EQ(widths.size(), 5U);
  for (std::size_t i = 1; i < widths.size(); ++i) {
    EXPECT_GE(widths[i] - widths[i - 1], TactileLimits::kStyleMm - 1e-9);
  }
  EXPECT_EQ(drawn.report.lines, 9U);
  EXPECT_EQ(drawn.report.recolored, 9U);
  EXPECT_EQ(drawn.report.widened, 2U);
  EXPECT_EQ(drawn.report.made_even, 7U);
}

TEST(SwellPaper, PositionsAreKeptExactly) {
  Drawn drawn;
  const StrokeId id = drawn.line({20, 20}, {120, 20}, 0.3, 0.5);
  const Drawing swell = drawn.swell();
  EXPECT_EQ(swell.document.find(id)->data().points, drawn.drawing.document.find(id)->data().points);
  EXPECT_EQ(swell.page.width_mm, drawn.drawing.page.width_mm);
}

TEST(SwellPaper, ADotKeepsItsSize) {
  Drawn drawn;
  const StrokeId large = drawn.line({20, 20}, {20.5, 20}, 4, 4);
  const StrokeId small = drawn.line({60, 20}, {60.3, 20}, 0.6, 0.6);
  const Drawing swell = drawn.swell();
  EXPECT_EQ(swell.document.find(large)->width_mm(0.0), 4.0);
  EXPECT_EQ(swell.document.find(small)->width_mm(0.0), SwellRules::kDotMm);
}

TEST(SwellPaper, AreasBecomeTexturesWithWhiteSpaceAndAnOutline) {
  Drawn drawn;
  drawn.fill({20, 20}, 60, 40, {200, 0, 0, 255});
  drawn.fill({100, 20}, 60, 40, {0, 0, 200, 255});
  drawn.fill({20, 100}, 60, 8, {0, 0, 200, 255});
  const Drawing swell = drawn.swell();
  EXPECT_EQ(swell.document.fill_count(), 0U);
  EXPECT_EQ(drawn.report.textures, 2U);
  EXPECT_EQ(drawn.report.outlines, 1U);
  int rows = 0, columns = 0, edges = 0;
  for (const StrokePtr& stroke : strokes_of(swell)) {
    const std::span<const Point> points(stroke->data().points);
    if (points.size() > 4) {
      ++edges;
      continue;
    }
    const Vec along = points.back() - points.front();
    (std::abs(along.x) > std::abs(along.y) ? rows : columns) += 1;
    for (const Point p : {points.front(), points.back()}) {
      const bool is_left = p.x < 90;
      const Rect inner{is_left ? 24.19 : 104.19, 24.19, is_left ? 75.81 : 155.81, 55.81};
      EXPECT_TRUE(inner.contains(p)) << p.x << ", " << p.y;
    }
  }
  EXPECT_EQ(edges, 3);
  EXPECT_GT(rows, 10) << "the first colour";
  EXPECT_GT(columns, 15) << "the second";
}

TEST(SwellPaper, AnAreaInsideLinesNeedsNoOutlineAndKeepsAwayFromLines) {
  Drawn drawn;
  drawn.fill({20, 20}, 60, 40, {200, 0, 0, 255});
  const Point corners[] = {{20, 20}, {80, 20}, {80, 60}, {20, 60}, {20, 20}};
  for (int i = 0; i < 4; ++i) drawn.line(corners[i], corners[i + 1], 1, 1);
  drawn.line({10, 40}, {90, 40}, 1, 1);  // across the area
  const Drawing swell = drawn.swell();
  int textured = 0;
  for (const StrokePtr& stroke : strokes_of(swell)) {
    ASSERT_EQ(stroke->segment_count(), 1) << "no line along the edge";
    const Point a = stroke->position(0.0), b = stroke->position(1.0);
    const bool is_inside = a.x > 21 && b.x < 79;
    if (!is_inside) continue;
    ++textured;
    EXPECT_GE(std::abs(a.y - 40.0), 3.2 + 0.5 + 0.5 - 0.01);
  }
  EXPECT_GT(textured, 6);
}

TEST(SwellPaper, SaysWhatWasChanged) {
  Drawn drawn;
  drawn.line({20, 20}, {80, 20}, 0.3, 0.3);
  drawn.line({20, 24}, {80, 24}, 1, 1);
  drawn.swell();
  EXPECT_EQ(drawn.report.faults, 1U);
  const std::vector<std::string> said = drawn.report.sentences();
  ASSERT_EQ(said.size(), 4U);
  EXPECT_EQ(said[0], "widened 1 line");
  EXPECT_EQ(said[1], "changed the width of 1 other line");
  EXPECT_EQ(said[2], "lines are 1.0, 1.5 mm wide");
  EXPECT_NE(said[3].find("1 fault is left"), std::string::npos);
  Drawn empty;
  empty.swell();
  EXPECT_TRUE(empty.report.sentences().empty());
}

TEST(SwellPaper, RefusesLinesOfKilometres) {
  Drawn drawn;
  drawn.line({0, 0}, {2e5, 0}, 1, 1);
  SwellReport report;
  EXPECT_FALSE(prepare_for_swell_paper(drawn.drawing, report));
  Drawn large;
  large.fill({-4e5, -4e5}, 8e5, 8e5, {1, 1, 1, 255});
  const auto refused = prepare_for_swell_paper(large.drawing, report);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kUnsupported);
}

TEST(LineWidths, GroupsAreThoseOfTheCheck) {
  EXPECT_TRUE(line_styles_of({}).empty());
  const std::vector<LineStyle> styles = line_styles_of({2.0, 0.5, 0.7, 2.2});
  ASSERT_EQ(styles.size(), 2U);
  EXPECT_EQ(styles[0].width_mm, 1.0);
  EXPECT_NEAR(styles[1].width_mm, 2.1, 1e-12);
}

}  // namespace
}  // namespace felt::swell_paper_test
