#include "felt/formats/plain_edit.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "felt/formats/drawing_writer.h"
#include "felt/formats/line_drawing.h"
#include "felt/io/drawing_builder.h"
#include "felt/io/inkml/inkml_import.h"
#include "felt/io/inkml/inkml_writer.h"
#include "felt/stroke/edit/corner_trips.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::plain_edit_test {
namespace {

/// Returns a line of 8 mm along the x axis whose first end is flat: two trips go into its corners.
Stroke with_flat_end() {
  StrokeData data;
  data.points.push_back({4, 0});
  const auto go = [&data](Point end, double begin_mm, double end_mm) {
    const Cubic c = straight(data.points.back(), end);
    data.points.insert(data.points.end(), c.p.begin() + 1, c.p.end());
    const double u = static_cast<double>(data.points.size() / 3) - 1.0;
    data.widths.push_back({u > 0.0 ? u + 1e-4 : 0.0, begin_mm});
    data.widths.push_back({u + 1.0, end_mm});
    if (u > 0.0) data.joints.push_back(JointKind::kCorner);
  };
  for (const double y : {3.975, -3.975}) {
    go({0.025, y}, 8.0, 0.05);
    go({4, 0}, 0.06, 0.06);
  }
  go({40, 0}, 8.0, 8.0);
  return Stroke::create(std::move(data)).value();
}

/// Returns a drawing with a translucent layer and a flat end.
Drawing rich_drawing() {
  DrawingBuilder builder;
  LayerState state{"Ink"};
  state.opacity = 0.5;
  const std::size_t layer = builder.add_layer(std::move(state));
  builder.add(layer, testing::random_stroke(1), "cat-1");
  builder.add(layer, with_flat_end(), "cat-2");
  return std::move(builder).build();
}

Drawing plain_copy(Drawing drawing, FileFormat format) {
  EXPECT_TRUE(drawing.document.apply(plain_edit(drawing.document, format)));
  return drawing;
}

TEST(PlainEdit, IsEmptyIfTheFormatHoldsTheStrokes) {
  const Drawing drawing = rich_drawing();
  for (const FileFormat format :
       {FileFormat::kFelt, FileFormat::kSvg, FileFormat::kInkml, FileFormat::kPdf}) {
    EXPECT_TRUE(plain_edit(drawing.document, format).empty());
  }
  for (const FileFormat format : {FileFormat::kNdjson, FileFormat::kXopp}) {
    EXPECT_FALSE(plain_edit(drawing.document, format).empty());
    const Drawing plain = plain_copy(drawing, format);
    EXPECT_TRUE(plain_edit(plain.document, format).empty()) << "a second edit changes nothing";
  }
}

/// A program that has these writers only, like the page, writes the same bytes after the edit.
TEST(PlainEdit, GivesTheBytesOfTheDrawingWriter) {
  const Drawing drawing = rich_drawing();
  const Drawing lines = plain_copy(drawing, FileFormat::kNdjson);
  const std::string bytes = bytes_of(*line_parts(lines)).value();
  EXPECT_EQ(bytes, drawing_bytes(drawing, FileFormat::kNdjson).value());
  EXPECT_NE(bytes, bytes_of(*line_parts(drawing)).value());
}

/// An .inkml file keeps flat ends for this program, and has a trace without trips for all others.
TEST(PlainEdit, InkmlKeepsFlatEndsAndShowsOthersALine) {
  const Drawing drawing = rich_drawing();
  std::string text = drawing_bytes(drawing, FileFormat::kInkml).value();
  EXPECT_EQ(import_inkml(text).value().drawing, drawing);
  for (std::size_t at = 0; (at = text.find("felt:points", at)) != std::string::npos;) {
    text.replace(at, 4, "else");
  }
  const Drawing seen = import_inkml(text).value().drawing;
  const Stroke line = *seen.document.find(seen.document.layers()[0].strokes[1]);
  EXPECT_FALSE(has_corner_trips(line));
  EXPECT_EQ(line.segment_count(), 1);
  EXPECT_NEAR(line.position(0.0).x, 0.0, 0.05);
}

TEST(PlainEdit, OpacityGoesToTheStrokesOnlyIfTheFormatHasNoTranslucentLayers) {
  const Drawing drawing = rich_drawing();
  const auto alpha = [](const Drawing& d) {
    return int{d.document.find(d.document.layers()[0].strokes[0])->color().a};
  };
  for (const FileFormat format : {FileFormat::kNdjson, FileFormat::kXopp}) {
    const Drawing plain = plain_copy(drawing, format);
    EXPECT_NEAR(alpha(plain), 0.5 * alpha(drawing), 0.51);
    EXPECT_EQ(plain.document.layers()[0].opacity, 1.0);
    EXPECT_EQ(used_names(plain), used_names(drawing));
  }
}

}  // namespace
}  // namespace felt::plain_edit_test
