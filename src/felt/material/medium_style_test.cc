#include "felt/material/medium_style.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <vector>

#include "felt/material/material_fields.h"
#include "felt/material/material_file.h"

namespace felt::medium_style_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string error_of(std::string_view shape) {
  const Result<StyleShape> read = read_style_shape(shape);
  return read ? "none" : read.error().message;
}

TEST(StyleShape, ReadsCommandsOfSvg) {
  const StyleShape shape =
      read_style_shape("M0 -.5L1,-.5 1 .5zm.2.1h.5v.2c0 .1 .1.2 .2 .3z M0 0").value();
  ASSERT_EQ(shape.contours.size(), 2u);
  EXPECT_EQ(shape.contours[0].size(), 10u) << "three lines";
  EXPECT_EQ(shape.contours[0][3], (Point{1.0, -0.5}));
  const std::vector<Point>& second = shape.contours[1];
  ASSERT_EQ(second.size(), 13u) << "a line to each side, a curve, and a line back";
  EXPECT_NEAR(second[0].x, 0.2, 1e-12) << "relative to the start of the closed contour";
  EXPECT_NEAR(second[0].y, -0.4, 1e-12);
  EXPECT_NEAR(second[3].x, 0.7, 1e-12);
  EXPECT_NEAR(second[6].y, -0.2, 1e-12);
  EXPECT_EQ(second.back(), second.front());
}

TEST(StyleShape, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(error_of(""), HasSubstr("no line or curve at character 1"));
  EXPECT_THAT(error_of("M0 0"), HasSubstr("no line or curve"));
  EXPECT_THAT(error_of("L1 0"), HasSubstr("the first command must be M at character 1"));
  EXPECT_THAT(error_of("M0 0A1 1 0 0 0 1 0"), HasSubstr("M, L, H, V, C and Z at character 5"));
  EXPECT_THAT(error_of("M0 0L1"), HasSubstr("a number is missing at character 7"));
  EXPECT_THAT(error_of("M0 0L1.1 0"), HasSubstr("x must be 0 to 1 and y -0.5 to 0.5"));
  EXPECT_THAT(error_of("M0 0L1 .6"), HasSubstr("x must be 0 to 1"));
  EXPECT_THAT(error_of("M0 0L1 nan"), HasSubstr("missing"));
  EXPECT_THAT(error_of("M0 0L1 +-.5 0 .5"), HasSubstr("missing at character 8"));
  EXPECT_THAT(error_of("M0 .2L1 .2 .5 .2ZM0 0L1 .5"), HasSubstr("encloses no area"));
  EXPECT_THAT(error_of("M0 0\nL1 0"), HasSubstr("character 5"));
  EXPECT_THAT(error_of("M0 0" + std::string(kMaxStyleShapeBytes, 'z')), HasSubstr("400 bytes"));
}

TEST(StyleShape, KeepsItsFormForAnyText) {
  constexpr std::array<std::string_view, 16> kParts{
      "L1 .5", "l.2-.1", "h.3", "V-.5", "H0",      "c.1.1.2 0.3-.1", "Z",   "z",
      "M.2.2", "m0,.1",  " .5", ".1",   "C0 .5 1", " .5 1 0",        "+.2", "e"};
  std::size_t read = 0;
  for (std::uint64_t seed = 0; seed < 20'000; ++seed) {
    std::mt19937_64 random(seed);
    std::string text = "M0 0";
    for (std::size_t n = random() % 12; n > 0; --n) text += kParts[random() % kParts.size()];
    const Result<StyleShape> shape = read_style_shape(text);
    if (!shape) continue;
    ++read;
    for (const std::vector<Point>& contour : shape->contours) {
      ASSERT_GE(contour.size(), 4u) << text;
      ASSERT_EQ(contour.size() % 3, 1u) << text;
      ASSERT_EQ(contour.front(), contour.back()) << text;
      for (const Point p : contour) {
        ASSERT_TRUE(p.x >= -1e-6 && p.x <= 1.0 + 1e-6 && std::abs(p.y) <= 0.5 + 1e-6) << text;
      }
    }
  }
  EXPECT_GT(read, 100u);  // of those that enclose an area
}

TEST(MediumStyle, IsWrittenOnlyIfThereIsOne) {
  Medium pen = *find_medium("ink-pen");
  EXPECT_THAT(write_material(pen), Not(HasSubstr("[style]"))) << "older versions can read it";
  pen.style.kind = StyleKind::kStretch;
  pen.style.shape = "M0 0L1 0 1 .5Z";
  const std::string text = write_material(pen);
  EXPECT_THAT(text, HasSubstr("[style]"));
  EXPECT_EQ(std::get<Medium>(read_material(text).value()), pen);
  pen.style.shape = "M0 0" + std::string(kMaxStyleShapeBytes - 11, ' ') + "H1V.5Z";
  EXPECT_EQ(material_error(pen), "") << "the longest shape fits into a line";
}

TEST(MediumStyle, NamesABadShapeWithItsLine) {
  const Result<AnyMaterial> read =
      read_material("kind = \"medium\"\nid = \"m\"\nstyle.shape = \"M0 0Q1 1 0 0\"\n");
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, HasSubstr("material:3: style.shape: expected one of"));
}

TEST(MediumStyle, BuiltInMediaWithAStyleFeelLikeTheInkPen) {
  const Medium& pen = *find_medium("ink-pen");
  const std::span<const Medium> all = Materials::built_in().media();
  ASSERT_GT(all.size(), media().size());
  for (const Medium& medium : media()) EXPECT_EQ(medium.style, MediumStyle{});
  for (const Medium& medium : all.subspan(media().size())) {
    EXPECT_NE(medium.style, MediumStyle{}) << medium.id;
    EXPECT_TRUE(read_style_shape(medium.style.shape)) << medium.id;
    for (const MediumField& field : medium_fields()) {
      if (!field.id.starts_with("feel.") && !field.id.starts_with("sound.")) continue;
      EXPECT_EQ(field.get(medium), field.get(pen)) << medium.id << ' ' << field.id;
    }
    EXPECT_EQ(medium.pairs, pen.pairs) << medium.id;
  }
}

}  // namespace
}  // namespace felt::medium_style_test
