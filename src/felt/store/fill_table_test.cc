#include "felt/store/fill_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "felt/document/edit_builder.h"
#include "felt/document/testing/random_fills.h"
#include "felt/session/session.h"
#include "felt/store/byte_writer.h"
#include "felt/store/felt_file.h"
#include "felt/store/felt_salvage.h"
#include "felt/store/fill_blob.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::fill_table_test {
namespace {

using ::testing::HasSubstr;

Drawing with_fills(int count) {
  Drawing drawing;
  testing::RandomStroke random(11);
  EditBuilder builder(drawing.document);
  for (int i = 0; i < count; ++i) {
    builder.add_fill({1}, std::make_shared<const Fill>(testing::random_fill(random)));
  }
  EXPECT_TRUE(drawing.document.apply(std::move(builder).build("Fill")));
  return drawing;
}

TEST(FillBlob, EveryFillReadsBackAndWhatIsCutOffIsNoFill) {
  testing::RandomStroke random(3);
  for (int i = 0; i < 300; ++i) {
    const Fill fill = testing::random_fill(random);
    std::string bytes;
    ASSERT_TRUE(append_fill_blob(bytes, fill));
    const Result<FillPtr> back = read_fill_blob(bytes);
    ASSERT_TRUE(back) << back.error().message;
    ASSERT_EQ(**back, fill);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      ASSERT_FALSE(read_fill_blob(std::string_view(bytes).substr(0, size))) << size;
    }
    EXPECT_FALSE(read_fill_blob(bytes + '\0'));
  }
  std::string bytes;
  EXPECT_FALSE(append_fill_blob(bytes, Fill{})) << "it is not valid";
  EXPECT_EQ(bytes, "");
}

TEST(FillTable, ADrawingWithoutFillsHasNoSuchTable) {
  const std::string none = *felt_bytes(with_fills(0)), some = *felt_bytes(with_fills(3));
  EXPECT_EQ(none.find("CREATE TABLE fill"), std::string::npos);
  EXPECT_NE(some.find("CREATE TABLE fill"), std::string::npos);
}

TEST(FillTable, AFileKeepsFillsAndTheirIds) {
  const Drawing drawing = with_fills(20);
  const Result<Drawing> back = parse_felt(*felt_bytes(drawing));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(*back, drawing);
  EXPECT_EQ(back->document.new_id().value, 21u);
}

TEST(FillTable, ADamagedFillIsFoundAndTheOthersAreSalvaged) {
  const Drawing drawing = with_fills(20);
  std::string shape;
  ASSERT_TRUE(append_fill_blob(shape, *drawing.document.find_fill({5})));
  std::string bytes = *felt_bytes(drawing);
  const std::size_t at = bytes.find(shape);
  ASSERT_NE(at, std::string::npos);
  bytes[at + 1] ^= 1;  // the colour
  const Result<Drawing> back = parse_felt(bytes);
  ASSERT_FALSE(back);
  EXPECT_THAT(back.error().message, HasSubstr("fill 5 is damaged"));
  const Result<Salvaged> salvaged = salvage_felt_bytes(bytes);
  ASSERT_TRUE(salvaged) << salvaged.error().message;
  EXPECT_EQ(salvaged->drawing.document.fill_count(), 19u);
  EXPECT_EQ(*salvaged->drawing.document.find_fill({6}), *drawing.document.find_fill({6}));
  EXPECT_THAT(salvaged->problems, ::testing::Contains(HasSubstr("1 fill of the layer")));
}

/// Draws with a simulated pen: touches at `from`, goes to `to` and lifts.
Document after_drag(const Document& start, const char* tool, Point from, Point to) {
  SessionOptions options;
  options.document = start;
  Session session(make_tools(), std::move(options));
  EXPECT_TRUE(session.apply({0, SelectTool{tool}}));
  std::int64_t now_ns = 0;
  const auto pen = [&](Point p, double z) {
    EXPECT_TRUE(session.apply({now_ns += 1'000'000, PenEvent{{p.x, p.y, z}, {}, 0}}));
  };
  pen(from, 5.0);
  for (int i = 0; i <= 100; ++i) pen(lerp(from, to, i / 100.0), -1.0);
  for (int i = 0; i < 100; ++i) pen(to, 5.0);
  return session.document();
}

TEST(FillTable, AfterLoadingAFillStillFollowsItsLines) {
  const auto line = [](Point a, Point b) {
    return std::make_shared<const Stroke>(testing::straight_stroke(a, b, 1, 1));
  };
  const std::vector<StrokePtr> lines{line({-1, 0}, {41, 0}), line({40, -1}, {40, 41}),
                                     line({41, 40}, {-1, 40}), line({0, 41}, {0, -1})};
  Drawing drawing;
  drawing.document = after_drag(document_of(lines), "fill", {20, 20}, {20.1, 20});
  ASSERT_EQ(drawing.document.fill_count(), 1u);
  const Result<Drawing> back = parse_felt(*felt_bytes(drawing));
  ASSERT_TRUE(back) << back.error().message;
  const Document pulled = after_drag(back->document, "pull", {40, 20}, {50, 20});
  EXPECT_EQ(pulled, after_drag(drawing.document, "pull", {40, 20}, {50, 20}));
  const FillId fill = pulled.layers().front().fills.front();
  EXPECT_GT(fill_bounds(*pulled.find_fill(fill)).x1, 45.0);
}

}  // namespace
}  // namespace felt::fill_table_test
