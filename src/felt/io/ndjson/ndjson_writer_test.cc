#include "felt/io/ndjson/ndjson_writer.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <clocale>
#include <cmath>
#include <cstring>
#include <limits>

#include "felt/io/ndjson/ndjson_parser.h"
#include "felt/stroke/width_profile.h"

namespace felt::ndjson_writer_test {
namespace {

SketchRecord read_sketch(std::string_view text) {
  LineReader reader(read_text(text));
  LineBatch batch;
  NdjsonParser parser;
  SketchRecord record;
  EXPECT_TRUE(reader.fill(batch, 1).value_or(false));
  const Result<NdjsonKind> kind = parser.sketch_stroke(batch.line(0), record);
  EXPECT_TRUE(kind) << kind.error().message << "\n" << text;
  return record;
}

bool can_read_sketch(std::string_view text) {
  LineReader reader(read_text(text));
  LineBatch batch;
  NdjsonParser parser;
  SketchRecord record;
  return reader.fill(batch, 1).value_or(false) && parser.sketch_stroke(batch.line(0), record);
}

RawStroke read_raw(std::string_view text) {
  LineReader reader(read_text(text));
  LineBatch batch;
  NdjsonParser parser;
  RawStroke stroke;
  EXPECT_TRUE(reader.fill(batch, 1).value_or(false));
  const Result<NdjsonKind> kind = parser.raw_stroke(batch.line(0), stroke);
  EXPECT_TRUE(kind) << kind.error().message << "\n" << text;
  return stroke;
}

StrokeData one_segment() {
  StrokeData data;
  data.points = {{0, 0}, {1, 0.1}, {2, -0.25}, {3, 1e-7}};
  data.widths = {{0, 0.5}, {1, 1.25}};
  return data;
}

TEST(NdjsonWriter, WritesKeysInAFixedOrder) {
  std::string line;
  append_sketch_line(line, "s1", one_segment());
  EXPECT_EQ(line,
            R"({"id":"s1","closed":false,"segments":[[0,0,1,0.1,2,-0.25,3,1e-07]],"joints":[],)"
            R"("widths":[[0,0.5],[1,1.25]]})"
            "\n");
}

TEST(NdjsonWriter, NumbersThatCouldNotBeReadBackAreRefused) {
  const double above = std::nextafter(1e10, 1e11);
  for (const double number : {1e10, -1e10, above, -above, 1e300}) {
    StrokeData far_x = one_segment(), far_y = one_segment(), wide = one_segment();
    far_x.points[2].x = far_y.points[3].y = wide.widths[1].width_mm = number;
    for (const StrokeData& data : {far_x, far_y, wide}) {
      std::string line;
      append_sketch_line(line, "s1", data);
      EXPECT_EQ(check_sketch_numbers(data).has_value(), can_read_sketch(line)) << line;
      EXPECT_EQ(can_read_sketch(line), std::fabs(number) <= 1e10) << line;
    }
  }
}

TEST(NdjsonWriter, WritesTonesOnlyWhereTheyAreNotThoseOfTheWidths) {
  StrokeData data = one_segment();
  data.widths[1].tone = 0.25;
  std::string line;
  append_sketch_line(line, "s1", data);
  EXPECT_NE(line.find(R"("widths":[[0,0.5],[1,1.25]],"tones":[0.03508)"), std::string::npos)
      << line;
  EXPECT_TRUE(line.ends_with(",0.25]}\n")) << line;
  EXPECT_EQ(read_sketch(line).data, data);
}

TEST(NdjsonWriter, WritesMaterialAndColorOnlyWhenTheyDiffer) {
  StrokeData data = one_segment();
  data.medium = "wet \"ink\"\n";
  data.color = {1, 2, 3, 4};
  std::string line;
  append_sketch_line(line, "s1", data);
  EXPECT_TRUE(line.ends_with("\"material\":\"wet \\\"ink\\\"\\u000a\",\"color\":\"#01020304\"}\n"))
      << line;
  EXPECT_EQ(read_sketch(line).data, data);
}

TEST(NdjsonWriter, LeavesOutPartsThatNoSampleHas) {
  std::string line;
  append_raw_line(line, "a", std::vector<InkSample>{{{1, 2}, {}, {}}});
  append_raw_line(line, "b", std::vector<InkSample>{{{1, 2}, {}, {}}, {{3, 4}, 0.5, {}}});
  append_raw_line(line, "c", std::vector<InkSample>{{{1, 2}, {}, 1'500'000}});
  append_raw_line(line, "d", std::vector<InkSample>{{{1, 2}, {}, {}, 32.5}, {{3, 4}, 0.5, {}}});
  EXPECT_EQ(line,
            "{\"id\":\"a\",\"points\":[[1,2]]}\n"
            "{\"id\":\"b\",\"points\":[[1,2,null],[3,4,0.5]]}\n"
            "{\"id\":\"c\",\"points\":[[1,2,null,1.5]]}\n"
            "{\"id\":\"d\",\"points\":[[1,2,null,null,{\"tilt\":32.5}],[3,4,0.5,null]]}\n");
}

TEST(NdjsonWriter, IgnoresTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  std::setlocale(LC_ALL, "de_DE.UTF-8");  // decimal comma, if the system has this locale
  std::string line;
  append_sketch_line(line, "s1", one_segment());
  EXPECT_EQ(read_sketch(line).data, one_segment());
  std::setlocale(LC_ALL, before.c_str());
}

TEST(NdjsonWriter, ZeroKeepsItsSign) {
  StrokeData data = one_segment();
  data.points[1].x = -0.0;
  std::string line;
  append_sketch_line(line, "s1", data);
  EXPECT_TRUE(std::signbit(read_sketch(line).data.points[1].x)) << line;
}

/// Generates any double that a file may contain, many of them with all 17 digits.
rc::Gen<double> coordinates() {
  return rc::gen::map(rc::gen::arbitrary<std::uint64_t>(), [](std::uint64_t bits) {
    double number = 0.0;
    std::memcpy(&number, &bits, sizeof number);
    if (!std::isfinite(number)) return 0.1;
    return std::fabs(number) <= 1e9 ? number : std::fmod(number, 1e9);
  });
}

rc::Gen<Point> points() {
  return rc::gen::build<Point>(rc::gen::set(&Point::x, coordinates()),
                               rc::gen::set(&Point::y, coordinates()));
}

rc::Gen<double> shares() {
  return rc::gen::map(rc::gen::inRange(0, (1 << 20) + 1), [](int n) { return n / 1048576.0; });
}

/// Generates names with quotes, control characters and multi-byte characters.
rc::Gen<std::string> names() {
  return rc::gen::map(rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
                          "a", "\"", "\\", "\n", "\x01", "\xC3\xA9", "\xF0\x9F\x96\x8B", "/")),
                      [](const std::vector<std::string>& parts) {
                        std::string name;
                        for (const std::string& part : parts) name += part;
                        return name;
                      });
}

// R53: a written value reads back as the same value, bit for bit.
RC_GTEST_PROP(NdjsonRoundTrip, SketchIsLossless, ()) {
  const auto segments = *rc::gen::inRange<std::size_t>(1, 20);
  StrokeData data;
  data.points = *rc::gen::container<std::vector<Point>>(3 * segments + 1, points());
  data.joints = *rc::gen::container<std::vector<JointKind>>(
      segments - 1, rc::gen::element(JointKind::kSmooth, JointKind::kCorner));
  data.closed = *rc::gen::arbitrary<bool>();
  data.widths = *rc::gen::container<std::vector<WidthKnot>>(rc::gen::build<WidthKnot>(
      rc::gen::set(&WidthKnot::u, coordinates()), rc::gen::set(&WidthKnot::width_mm, coordinates()),
      rc::gen::set(&WidthKnot::tone, shares())));
  if (*rc::gen::arbitrary<bool>()) take_tone_of_width(data.widths);
  data.medium = *names();
  data.color.r = *rc::gen::arbitrary<std::uint8_t>();
  data.color.a = *rc::gen::arbitrary<std::uint8_t>();
  const std::string id = *names();
  std::string line;
  append_sketch_line(line, id, data);
  const SketchRecord read = read_sketch(line);
  RC_ASSERT(read.id == id);
  RC_ASSERT(read.data == data);
  std::string again;
  append_sketch_line(again, read.id, read.data);
  RC_ASSERT(again == line);
}

RC_GTEST_PROP(NdjsonRoundTrip, RawIsLossless, ()) {
  constexpr std::int64_t kMonthNs = 2'000'000'000'000'000;  // exact up to here (docs/formats)
  std::vector<InkSample> samples;
  for (const Point p : *rc::gen::nonEmpty(rc::gen::container<std::vector<Point>>(points()))) {
    InkSample sample{p, {}, {}};
    if (*rc::gen::arbitrary<bool>()) sample.pressure = *rc::gen::inRange(0, 1 << 20) / 1048576.0;
    if (*rc::gen::arbitrary<bool>()) sample.time_ns = *rc::gen::inRange(-kMonthNs, kMonthNs);
    if (*rc::gen::arbitrary<bool>())
      sample.tilt_deg = 90.0 * *rc::gen::inRange(0, 1 << 20) / (1 << 20);
    samples.push_back(sample);
  }
  std::string line;
  append_raw_line(line, "s", samples);
  RC_ASSERT(read_raw(line).samples == samples);
}

}  // namespace
}  // namespace felt::ndjson_writer_test
