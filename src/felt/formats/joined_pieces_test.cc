#include "felt/formats/joined_pieces.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <string>

#include "felt/document/edit_builder.h"
#include "felt/io/svg/svg_import.h"

namespace felt::joined_pieces_test {
namespace {

std::string svg_line(Point a, Point b, double width_mm, const std::string& color) {
  return "<path fill='none' stroke-linecap='round' stroke='" + color + "' stroke-width='" +
         std::to_string(width_mm) + "' d='M" + std::to_string(a.x) + " " + std::to_string(a.y) +
         "L" + std::to_string(b.x) + " " + std::to_string(b.y) + "'/>";
}

Drawing drawing_of(const std::string& shapes) {
  return import_svg(
             "<svg xmlns='http://www.w3.org/2000/svg' width='200mm' height='200mm' "
             "viewBox='0 0 200 200'>" +
             shapes + "</svg>")
      .value()
      .drawing;
}

std::vector<StrokePtr> strokes_of(const Drawing& drawing) {
  std::vector<StrokePtr> strokes;
  for (const Layer& layer : drawing.document.layers()) {
    for (const StrokeId id : layer.strokes) strokes.push_back(drawing.document.find(id));
  }
  return strokes;
}

Point wave(int i) {
  return {20.0 + i, 60.0 + 10.0 * std::sin(0.15 * i)};
}
double wave_width_mm(int i) {
  return 0.6 + 0.3 * std::sin(0.1 * i);
}

RC_GTEST_PROP(JoinPieces, APenLineInPiecesBecomesOneStroke, ()) {
  const int count = *rc::gen::inRange(2, 80);
  std::string shapes;
  for (int i = 0; i < count; ++i) {
    shapes += svg_line(wave(i), wave(i + 1), wave_width_mm(i), "#123456");
  }
  Drawing drawing = drawing_of(shapes);
  RC_ASSERT(join_pieces(drawing).value() == static_cast<std::size_t>(count));
  const std::vector<StrokePtr> strokes = strokes_of(drawing);
  RC_ASSERT(strokes.size() == 1U);
  const Stroke& stroke = *strokes.front();
  RC_ASSERT(distance(stroke.position(0.0), wave(0)) < 0.1);
  RC_ASSERT(distance(stroke.position(stroke.segment_count()), wave(count)) < 0.1);
  RC_ASSERT(std::fabs(stroke.width_mm(0.0) - wave_width_mm(0)) < 0.05);
  RC_ASSERT(stroke.color() == (Rgba{0x12, 0x34, 0x56, 255}));
  RC_ASSERT(stroke.segment_count() <= 1 + count / 3);
}

TEST(JoinPieces, TheWidthIsThatOfEachPieceInItsMiddleAndChangesLinearly) {
  const double widths[] = {0.4, 1.0, 0.6};
  std::string shapes;
  for (int i = 0; i < 3; ++i) {
    shapes += svg_line({20.0 + 10.0 * i, 20}, {30.0 + 10.0 * i, 20}, widths[i], "#000");
  }
  Drawing drawing = drawing_of(shapes);
  EXPECT_EQ(join_pieces(drawing).value(), 3U);
  const StrokePtr stroke = strokes_of(drawing).at(0);
  for (const auto& [x, width_mm] :
       {std::pair(25.0, 0.4), std::pair(27.5, 0.55), std::pair(30.0, 0.7), std::pair(35.0, 1.0),
        std::pair(40.0, 0.8), std::pair(45.0, 0.6), std::pair(50.0, 0.6)}) {
    double nearest_u = 0.0;
    for (int k = 0; k <= 3000; ++k) {
      const double u = stroke->segment_count() * k / 3000.0;
      if (std::fabs(stroke->position(u).x - x) < std::fabs(stroke->position(nearest_u).x - x)) {
        nearest_u = u;
      }
    }
    EXPECT_NEAR(stroke->width_mm(nearest_u), width_mm, 0.02) << x;
  }
}

TEST(JoinPieces, BroadLinesWithFlatEndsAreJoinedAsWell) {
  std::string shapes;
  for (int i = 0; i < 20; ++i) {
    const std::string line = svg_line(wave(5 * i), wave(5 * i + 5), 1.5 + 0.05 * i, "#000");
    shapes += line.substr(0, line.find(" stroke-linecap")) + line.substr(line.find(" stroke='"));
  }
  Drawing drawing = drawing_of(shapes);
  EXPECT_EQ(join_pieces(drawing).value(), 20U);
  EXPECT_EQ(strokes_of(drawing).size(), 1U);
}

TEST(JoinPieces, LinesWithTonesOfTheirOwnStay) {
  Drawing drawing = drawing_of(svg_line({20, 20}, {30, 20}, 0.3, "#000") +
                               svg_line({30, 20}, {40, 20}, 0.3, "#000"));
  EditBuilder edit(drawing.document);
  for (const StrokePtr& stroke : strokes_of(drawing)) {
    StrokeData data = stroke->data();
    for (WidthKnot& knot : data.widths) knot.tone = 1.0;
    edit.add({1}, std::make_shared<const Stroke>(Stroke::create(data).value()));
  }
  ASSERT_TRUE(drawing.document.apply(std::move(edit).build("Add")));
  EXPECT_EQ(join_pieces(drawing).value(), 2U) << "only those without a tone";
  EXPECT_EQ(strokes_of(drawing).size(), 3U);
}

TEST(JoinPieces, OtherLinesStay) {
  const auto line = [](Point a, Point b, const std::string& color = "#000") {
    return svg_line(a, b, 1.0, color);
  };
  for (const std::string& second :
       {line({50.1, 20}, {80, 20}), line({80, 20}, {50, 20}), line({50, 20}, {80, 20}, "#f00")}) {
    Drawing drawing = drawing_of(line({20, 20}, {50, 20}) + second);
    EXPECT_EQ(join_pieces(drawing).value(), 0U) << second;
    EXPECT_EQ(strokes_of(drawing).size(), 2U);
  }
}

TEST(JoinPieces, PiecesThatReturnToTheirStartAreClosed) {
  const Point corners[] = {{20, 20}, {60, 20}, {60, 60}, {20, 60}};
  std::string shapes;
  for (int i = 0; i < 4; ++i) shapes += svg_line(corners[i], corners[(i + 1) % 4], 0.8, "#000");
  Drawing drawing = drawing_of(shapes + svg_line({100, 100}, {120, 100}, 1.0, "#000"));
  EXPECT_EQ(join_pieces(drawing).value(), 4U);
  const std::vector<StrokePtr> strokes = strokes_of(drawing);
  ASSERT_EQ(strokes.size(), 2U);
  EXPECT_TRUE(strokes[0]->closed());
  EXPECT_EQ(strokes[0]->segment_count(), 4);
}

}  // namespace
}  // namespace felt::joined_pieces_test
