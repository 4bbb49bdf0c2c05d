// Strokes keep the names of their file in every format that has names.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "felt/formats/drawing_reader.h"
#include "felt/formats/drawing_writer.h"
#include "felt/io/drawing_builder.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::stroke_names_test {
namespace {

std::vector<std::string> names_of(const Drawing& drawing) {
  std::vector<std::string> names;
  for (const Layer& layer : drawing.document.layers()) {
    for (const StrokeId id : layer.strokes) names.push_back(name_in_file(drawing, id));
  }
  return names;
}

RC_GTEST_PROP(StrokeNames, AreKeptByEveryFormatThatHasNames, ()) {
  const auto name = rc::gen::element<std::string>("cat-1", "s7", "s07", "7", "s7", "<&\">", "\t\n",
                                                  "s99999999999999999999", "\xc3\xbc", " a ");
  const auto names = *rc::gen::nonEmpty(rc::gen::container<std::vector<std::string>>(name));
  DrawingBuilder builder;
  std::size_t layer = builder.add_layer({"a"});
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0 && *rc::gen::inRange(0, 4) == 0) layer = builder.add_layer({"b"});
    builder.add(layer, testing::random_stroke(i), names[i]);
  }
  builder.drawing().has_page = true;
  const Drawing drawing = std::move(builder).build();
  RC_ASSERT(names_of(drawing) == names);
  for (const FileFormat format :
       {FileFormat::kFelt, FileFormat::kNdjson, FileFormat::kSvg, FileFormat::kInkml}) {
    const Result<std::string> bytes = drawing_bytes(drawing, format);
    RC_ASSERT(bytes.has_value());
    const Result<Imported> back = parse_drawing(*bytes, {});
    RC_ASSERT(back.has_value());
    RC_ASSERT(names_of(back->drawing) == names);
    // The ids of strokes in .ndjson are their names.
    RC_ASSERT(format == FileFormat::kNdjson || back->drawing == drawing);
    RC_ASSERT(drawing_bytes(back->drawing, format).value() == *bytes);
  }
}

TEST(StrokeNames, AFillKeepsItsStrokesInAnSvg) {
  DrawingBuilder builder;
  const std::size_t layer = builder.add_layer({"a"});
  for (const char* name : {"cat-1", "s9", "cat-2"}) {
    builder.add(layer, testing::random_stroke(1), name);
  }
  Fill fill;
  fill.loops = {{{{0, 0}, {9, 0}, {9, 9}, {0, 0}}, {{StrokeId{11}, 0.0, 1.0}}}};
  builder.add_fill(layer, std::make_shared<const Fill>(fill));
  builder.drawing().has_page = true;
  Drawing drawing = std::move(builder).build();
  ASSERT_EQ(drawing.document.layers()[0].strokes[2].value, 11u);
  const std::string bytes = drawing_bytes(drawing, FileFormat::kSvg).value();
  EXPECT_TRUE(parse_drawing(bytes, {}).value().drawing == drawing);
}

}  // namespace
}  // namespace felt::stroke_names_test
