#include "felt/io/drawing_parts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "felt/io/drawing_builder.h"
#include "felt/io/inkml/inkml_writer.h"
#include "felt/io/picture/pdf_writer.h"
#include "felt/io/svg/svg_import.h"
#include "felt/io/svg/svg_writer.h"
#include "felt/io/unpack.h"
#include "felt/io/xopp/xopp_writer.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::drawing_parts_test {
namespace {

Drawing drawing_of(std::size_t strokes) {
  DrawingBuilder builder;
  for (int i = 0; i < 3; ++i) builder.add_layer({});
  for (std::size_t i = 0; i < strokes; ++i) {
    builder.add(i % 2, felt::testing::random_stroke(i % 40), "s" + std::to_string(i + 1));
  }
  return std::move(builder).build();
}

using Made = Result<std::unique_ptr<DrawingParts>>;

std::vector<Made> all_formats(const Drawing& drawing) {
  std::vector<Made> all;
  all.push_back(svg_parts(drawing, {}));
  all.push_back(svg_parts(drawing, {}).map([](std::unique_ptr<DrawingParts> parts) {
    return gzip_parts(std::move(parts));
  }));
  all.push_back(inkml_parts(drawing));
  all.push_back(xopp_parts(drawing));
  all.push_back(pdf_parts(drawing, {}));
  return all;
}

std::vector<std::size_t> largest_parts(std::size_t strokes) {
  std::vector<std::size_t> largest;
  const Drawing drawing = drawing_of(strokes);
  for (const Made& made : all_formats(drawing)) {
    DrawingPart part;
    std::size_t bytes = 0;
    for (std::size_t i = 0; i < (*made)->count(); ++i) {
      EXPECT_TRUE((*made)->make(i, part));
      bytes = std::max(bytes, part.bytes.size());
    }
    bytes = std::max(bytes, (*made)->tail().size());
    largest.push_back(bytes);
  }
  return largest;
}

/// The memory of a writer at any time does not grow with the number of strokes.
TEST(DrawingParts, R53_TheLargestPartDoesNotGrowWithTheDrawing) {
  const std::vector<std::size_t> small = largest_parts(4 * kPartStrokes);
  const std::vector<std::size_t> large = largest_parts(16 * kPartStrokes);
  for (std::size_t i = 0; i < small.size(); ++i) {
    EXPECT_LE(large[i], small[i] + small[i] / 10) << "format " << i;
  }
}

/// Threads finish in any order, so a part must not depend on the parts made before it.
TEST(DrawingParts, PartsDoNotDependOnEachOther) {
  const Drawing drawing = drawing_of(700);
  for (const Made& made : all_formats(drawing)) {
    DrawingParts& parts = **made;
    ASSERT_TRUE(parts.any_order());
    ASSERT_GT(parts.count(), 4U);
    std::vector<DrawingPart> backwards(parts.count());
    for (std::size_t i = parts.count(); i-- > 0;) ASSERT_TRUE(parts.make(i, backwards[i]));
    DrawingPart part;
    for (std::size_t i = 0; i < parts.count(); ++i) {
      ASSERT_TRUE(parts.make(i, part));
      EXPECT_EQ(part.bytes, backwards[i].bytes);
      EXPECT_EQ(part.checksum, backwards[i].checksum);
    }
  }
}

TEST(DrawingParts, ManyPartsReadBackEqual) {
  const Drawing drawing = drawing_of(700);
  const std::string text = svg_text(drawing, {}).value();
  const std::unique_ptr<DrawingParts> packed = gzip_parts(svg_parts(drawing, {}).value());
  EXPECT_EQ(gunzip(bytes_of(*packed).value()).value(), text);
  const Result<Imported> back = import_svg(text);
  ASSERT_TRUE(back);
  EXPECT_TRUE(back->report.empty());
  EXPECT_EQ(back->drawing, drawing);
}

TEST(DrawingParts, RangesHaveEachStrokeOnce) {
  const Drawing drawing = drawing_of(1000);
  std::size_t number = 0;
  for (const StrokeRange& range : stroke_ranges(drawing.document, LayerChoice::kAll)) {
    EXPECT_EQ(range.before, number);
    EXPECT_LE(range.last - range.first, kPartStrokes);
    number += range.last - range.first;
  }
  EXPECT_EQ(number, 1000U);
}

}  // namespace
}  // namespace felt::drawing_parts_test
