#include "felt/io/ndjson/ndjson_parser.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "felt/io/ndjson/ndjson_writer.h"

namespace felt::ndjson_parser_test {
namespace {

using ::testing::HasSubstr;
using namespace std::string_literals;

/// The first line of `text` as a raw stroke, or the message of the error.
struct Parsed {
  RawStroke stroke;
  SketchRecord sketch;
  NdjsonKind kind = NdjsonKind::kStroke;
  std::string error;
};

Parsed parse(std::string_view text, bool as_sketch) {
  LineReader reader(read_text(text));
  LineBatch batch;
  Parsed parsed;
  if (!reader.fill(batch, 1).value_or(false)) {
    parsed.error = "no line";
    return parsed;
  }
  NdjsonParser parser;
  const Result<NdjsonKind> kind = as_sketch ? parser.sketch_stroke(batch.line(0), parsed.sketch)
                                            : parser.raw_stroke(batch.line(0), parsed.stroke);
  if (kind) {
    parsed.kind = *kind;
  } else {
    parsed.error = kind.error().message;
  }
  return parsed;
}

Parsed parse_raw(std::string_view text) {
  return parse(text, false);
}
Parsed parse_sketch(std::string_view text) {
  return parse(text, true);
}

std::string raw_error(std::string_view text) {
  return parse_raw(text).error;
}
std::string sketch_error(std::string_view text) {
  return parse_sketch(text).error;
}

/// Returns a raw line with one point with x = `number`.
std::string with_x(const std::string& number) {
  return "{\"points\":[[" + number + ",0]]}";
}

TEST(NdjsonRaw, ReadsPointsOfTwoToManyParts) {
  const Parsed parsed = parse_raw(
      R"({"id":"s1","points":[[1,2],[3.5,-4e1,0.25],[5,6,null,7.5],[8,9,1,2,{"tilt":[1]},"x"]]})");
  EXPECT_EQ(parsed.error, "");
  EXPECT_EQ(parsed.stroke.id, "s1");
  const std::vector<InkSample> expected = {
      {{1, 2}, {}, {}},
      {{3.5, -40}, 0.25, {}},
      {{5, 6}, {}, 7'500'000},
      {{8, 9}, 1.0, 2'000'000},
  };
  EXPECT_EQ(parsed.stroke.samples, expected);
}

TEST(NdjsonRaw, APenMayTilt) {
  const auto point = [](const std::string& more) {
    return R"({"points":[[1,2,null,null,)" + more + "]]}";
  };
  const auto tilt = [&](const std::string& more) {
    const Parsed parsed = parse_raw(point(more));
    EXPECT_EQ(parsed.error, "") << more;
    return parsed.stroke.samples.at(0).tilt_deg;
  };
  EXPECT_EQ(tilt(R"({"tilt":32.5})"), 32.5);
  EXPECT_EQ(tilt(R"({"tilt":0})"), 0.0);
  EXPECT_EQ(tilt(R"({"note":{"a":[1]},"tilt":90},"x")"), 90.0);
  EXPECT_EQ(tilt(R"({"tilt":null})"), std::nullopt);
  EXPECT_EQ(tilt(R"({"tilt":[30,0]})"), 30.0);
  EXPECT_EQ(tilt(R"({"tilt":[-45,45]})"), 54.7);
  EXPECT_EQ(tilt(R"({"tilt":[-45,45],"lean":12})"), 12.0) << "one angle goes before a pair";
  EXPECT_EQ(tilt(R"({"lean":12,"tilt":[-45,45]})"), 12.0);
  EXPECT_EQ(tilt(R"({"lean":32.5})"), 32.5) << "the key before it was renamed";
  for (const char* none : {"30", "[30,0]", "null", "{}", R"({"tilt":[30]})", R"({"tilt":[30,0,0]})",
                           R"({"tilt":["30",0]})", R"({"tilt":{"x":30}})", R"({"tilt":[91,0]})",
                           R"("x",{"tilt":30})"}) {
    EXPECT_EQ(tilt(none), std::nullopt) << none;
  }
  EXPECT_THAT(raw_error(point(R"({"tilt":-1})")),
              HasSubstr("tilt: -1 is not an angle from 0 to 90 degrees"));
  EXPECT_THAT(raw_error(point(R"({"tilt":90.5})")), HasSubstr("tilt: 90.5 is not an angle"));
  EXPECT_THAT(raw_error(point(R"({"tilt":"30"})")), HasSubstr("tilt: \"30\" is not a number"));
  EXPECT_THAT(raw_error(point(R"({"tilt":[1e99,0]})")), HasSubstr("tilt: "));
  EXPECT_NE(raw_error(point(R"({"tilt":[1,})")), "");
  EXPECT_NE(raw_error(point(R"({"tilt":1)")), "");
}

TEST(NdjsonRaw, IgnoresOtherKeysAndOrder) {
  const Parsed parsed = parse_raw(
      R"( {"source":"a","n":123456789012345678901234567890,"deep":{"a":[[],{}, -1.5e3 ],"b":null},)"
      R"( "points" : [ [ 1 , 2 ] ] ,"t":true,"f":false,"\u0069\u0064":"s\u00e9\n"} )");
  EXPECT_EQ(parsed.error, "");
  EXPECT_EQ(parsed.stroke.id, "s\xC3\xA9\n");
  EXPECT_EQ(parsed.stroke.samples.size(), 1U);
}

TEST(NdjsonRaw, IdMayBeMissingOrANumber) {
  EXPECT_EQ(parse_raw(with_x("1")).stroke.id, "");
  EXPECT_EQ(parse_raw(R"({"id":42,"points":[[0,0]]})").stroke.id, "42");
  EXPECT_THAT(raw_error(R"({"id":null,"points":[[0,0]]})"), HasSubstr("id: null is neither"));
  EXPECT_THAT(raw_error(R"({"id":["a"],"points":[[0,0]]})"), HasSubstr("id: [ is neither"));
}

TEST(NdjsonRaw, ReadsPressuresAsTheyAre) {
  const Parsed parsed = parse_raw(R"({"points":[[0,0,1.01],[0,0,-0.01],[0,0,1023]]})");
  EXPECT_EQ(parsed.stroke.samples[0].pressure, 1.01);
  EXPECT_EQ(parsed.stroke.samples[1].pressure, -0.01);
  EXPECT_EQ(parsed.stroke.samples[2].pressure, 1023.0);
}

TEST(NdjsonRaw, AcceptsTimesThatRunBackwardsAndTimesSince1970) {
  const Parsed parsed = parse_raw(R"({"points":[[0,0,null,1763683200000.5],[1,1,null,-3]]})");
  EXPECT_EQ(parsed.error, "");
  EXPECT_EQ(parsed.stroke.samples[0].time_ns, 1'763'683'200'000'500'000 / 256 * 256);
  EXPECT_EQ(parsed.stroke.samples[1].time_ns, -3'000'000);
}

TEST(NdjsonRaw, NamesTheKeyTheIndexAndTheReason) {
  EXPECT_EQ(raw_error(R"({"points":[[1,2],[3,NaN]]})"), "points[1]: y: NaN is not a number");
  EXPECT_EQ(raw_error(R"({"points":[[Infinity,2]]})"), "points[0]: x: Infinity is not a number");
  EXPECT_EQ(raw_error(R"({"points":[[-Infinity,2]]})"), "points[0]: x: -Infinity is not a number");
  EXPECT_EQ(raw_error(R"({"points":[[null,2]]})"), "points[0]: x: null is not a number");
  EXPECT_EQ(raw_error(R"({"points":[["1",2]]})"), "points[0]: x: \"1\" is not a number");
  EXPECT_EQ(raw_error(R"({"points":[[[1],2]]})"), "points[0]: x: [ is not a number");
  EXPECT_EQ(raw_error(R"({"points":[[1,2,true]]})"), "points[0]: pressure: true is not a number");
  EXPECT_EQ(raw_error(R"({"points":[[1,2,1,"now"]]})"), "points[0]: time: \"now\" is not a number");
  EXPECT_EQ(raw_error(R"({"points":[[1,2],7]})"), "points[1]: 7 is not an array");
  EXPECT_EQ(raw_error(R"({"points":[[1]]})"), "points[0]: a point needs x and y");
  EXPECT_EQ(raw_error(R"({"points":[]})"), "points: is empty");
  EXPECT_EQ(raw_error(R"({"points":{"x":1}})"), "points: { is not an array");
  EXPECT_EQ(raw_error(R"({"id":"s1"})"), "key \"points\" is missing");
  EXPECT_EQ(raw_error("{}"), "key \"points\" is missing");
  EXPECT_EQ(raw_error(R"({"points":[[0,0]],"points":[[1,1]]})"), "key \"points\" occurs twice");
}

TEST(NdjsonRaw, RefusesWhatIsNoJson) {
  for (const char* text : {
           "hello",
           "[1,2]",
           "\"points\"",
           "{",
           "}",
           "{]",
           R"({"points":[[0,0]])",
           R"({"points":[[0,0}])",
           R"({"points":[[0,0]}])",
           R"({"points":[[0 0]]})",
           R"({"points":[[0,0]],})",
           R"({"points":[[0,0],]})",
           R"({"points":[,[0,0]]})",
           R"({"points" [[0,0]]})",
           R"({points:[[0,0]]})",
           R"({"points":[[0,0]]}x)",
           R"({"points":[[0,0]]} {"points":[[0,0]]})",
           R"({"points":[[01,0]]})",
           R"({"points":[[+1,0]]})",
           R"({"points":[[.5,0]]})",
           R"({"points":[[1.,0]]})",
           R"({"points":[[0x10,0]]})",
           R"({"points":[[1e,0]]})",
           R"({"points":[[--1,0]]})",
           R"({"points":[[1,5,0]],"x":tru})",
           R"({"points":[[1,5]],"x":[1,,2]})",
           R"({"points":[[1,5]],"x":[1}})",
           R"({"points":[[1,5]],"x":{"a"}})",
           R"({"points":[[1,5]],"x":"\q"})",
           R"({"points":[[1,5]],"x":"\ud800"})",
           R"({"points":[[1,5]],"x":00})",
           R"({"points":[[1,5]],"id":"cut)",
       }) {
    EXPECT_NE(raw_error(text), "") << text;
  }
}

TEST(NdjsonRaw, EveryCutOfALineIsAnError) {
  const std::string whole =
      R"({"id":"s1","x":{"a":[1,true,null,"b"]},"points":[[1.5,2,0.5,10],[3,4,null,null]]})";
  EXPECT_EQ(raw_error(whole), "");
  for (std::size_t length = 1; length < whole.size(); ++length) {
    EXPECT_NE(raw_error(whole.substr(0, length)), "") << length;
  }
}

TEST(NdjsonRaw, RefusesBadBytes) {
  EXPECT_EQ(raw_error("{\"points\":[[0,0]]\0}"s), "byte 18 is NUL");
  EXPECT_EQ(raw_error("\0\0\0"s), "byte 1 is NUL");
  EXPECT_THAT(raw_error("{\"id\":\"\xFF\",\"points\":[[0,0]]}"), HasSubstr("UTF-8"));
  EXPECT_THAT(raw_error("{\"id\":\"\xC0\xAF\",\"points\":[[0,0]]}"), HasSubstr("UTF-8"));
  EXPECT_THAT(raw_error("{\"id\":\"a\tb\",\"points\":[[0,0]]}"), HasSubstr("control character"));
}

TEST(NdjsonRaw, ShowsNoControlCharactersOfTheInput) {
  const std::string message = raw_error("{\"points\":[[\x1B[31mred,0]]}");
  EXPECT_EQ(message.find('\x1B'), std::string::npos) << message;
  EXPECT_LT(raw_error(with_x(std::string(100'000, 'x'))).size(), 100U);
}

TEST(NdjsonRaw, CoordinateAtBelowAndAboveTheLimit) {
  EXPECT_EQ(raw_error(with_x("999999999.999")), "");
  EXPECT_EQ(raw_error(with_x("1e9")), "");
  EXPECT_EQ(raw_error(with_x("-1000000000")), "");
  EXPECT_THAT(raw_error(with_x("1000000000.0000002")), HasSubstr("larger than 1e9"));
  EXPECT_THAT(raw_error(with_x("-1.1e9")), HasSubstr("larger than 1e9"));
  EXPECT_THAT(raw_error(with_x("1e400")), HasSubstr("larger than 1e9"));
  EXPECT_EQ(parse_raw(with_x("1e-400")).stroke.samples.at(0).position.x, 0.0);
}

TEST(NdjsonSketch, NumberAtBelowAndAboveTheLimit) {
  const auto with_x = [](const std::string& x) {
    return sketch_error(R"({"segments":[[0,0,1,1,2,2,)" + x + R"(,3]],"joints":[],"widths":[]})");
  };
  EXPECT_EQ(with_x("9999999999.99"), "");
  EXPECT_EQ(with_x("-1e10"), "");
  EXPECT_EQ(with_x("10000000000.01"),
            "segments[0]: number 6: 10000000000.01 is malformed, or larger than 1e10");
}

TEST(NdjsonRaw, TimeAtAndAboveTheLimit) {
  EXPECT_EQ(raw_error(R"({"points":[[0,0,null,9e12]]})"), "");
  EXPECT_THAT(raw_error(R"({"points":[[0,0,null,9.1e12]]})"), HasSubstr("larger than 9e12"));
}

TEST(NdjsonRaw, NumberTextAtBelowAndAboveTheLimit) {
  EXPECT_EQ(raw_error(with_x("0." + std::string(61, '1'))), "");
  EXPECT_EQ(raw_error(with_x("0." + std::string(62, '1'))), "");
  EXPECT_THAT(raw_error(with_x("0." + std::string(63, '1'))), HasSubstr("65 characters"));
  EXPECT_THAT(raw_error(with_x(std::string(10'000'000, '1'))), HasSubstr("10000000 characters"));
  EXPECT_THAT(raw_error(R"({"x":)" + std::string(65, '1') + R"(,"points":[[0,0]]})"),
              HasSubstr("65 characters"));
}

TEST(NdjsonRaw, NameAtAndAboveTheLimit) {
  const auto with_id = [](std::size_t size) {
    return R"({"points":[[0,0]],"id":")" + std::string(size, 'n') + "\"}";
  };
  EXPECT_EQ(raw_error(with_id(limits::kMaxNameBytes - 1)), "");
  EXPECT_EQ(raw_error(with_id(limits::kMaxNameBytes)), "");
  EXPECT_THAT(raw_error(with_id(limits::kMaxNameBytes + 1)), HasSubstr("longer than 4096 bytes"));
}

TEST(NdjsonRaw, NestingAtBelowAndAboveTheLimit) {
  const auto nested = [](std::size_t depth, const char* open, const char* close) {
    std::string text = R"({"points":[[0,0]],"x":)";
    for (std::size_t i = 0; i < depth; ++i) text += open;
    text += "1";
    for (std::size_t i = 0; i < depth; ++i) text += close;
    return text + "}";
  };
  for (const std::size_t below : {1U, 63U, 64U}) {
    EXPECT_EQ(raw_error(nested(below, "[", "]")), "") << below;
    EXPECT_EQ(raw_error(nested(below, R"({"k":)", "}")), "") << below;
  }
  for (const std::size_t above : {65U, 1'000U, 1'000'000U}) {
    EXPECT_NE(raw_error(nested(above, "[", "]")), "") << above;
    EXPECT_NE(raw_error(nested(above, R"({"k":)", "}")), "") << above;
  }
  EXPECT_NE(raw_error(R"({"points":)" + std::string(1'000'000, '[')), "");
  EXPECT_NE(raw_error(std::string(1'000'000, '[')), "");
  EXPECT_NE(
      raw_error(R"({"points":)" + std::string(100'000, '[') + std::string(100'000, ']') + "}"), "");
}

TEST(NdjsonRaw, TheParserIsUsableAfterAnError) {
  LineReader reader(read_text("{\"points\":[[1,\n{\"x\":[[[\n{\"points\":[[1,2]]}\n"));
  LineBatch batch;
  ASSERT_TRUE(reader.fill(batch, 1000).value());
  NdjsonParser parser;
  RawStroke stroke;
  EXPECT_FALSE(parser.raw_stroke(batch.line(0), stroke));
  EXPECT_FALSE(parser.raw_stroke(batch.line(1), stroke));
  EXPECT_TRUE(parser.raw_stroke(batch.line(2), stroke));
  EXPECT_EQ(stroke.samples.size(), 1U);
}

TEST(NdjsonHeader, IsRecognisedAnywhereByItsFirstKey) {
  EXPECT_EQ(parse_raw(R"({"feltline":1,"unit":"mm","by":"me"})").kind, NdjsonKind::kHeader);
  EXPECT_EQ(parse_sketch(R"({"feltline":1})").kind, NdjsonKind::kHeader);
  EXPECT_EQ(parse_raw(R"({"points":[[0,0]],"feltline":1})").kind, NdjsonKind::kStroke);
}

TEST(NdjsonHeader, RefusesWhatWeDoNotKnow) {
  EXPECT_THAT(raw_error(R"({"feltline":2})"), HasSubstr("version 2 is not supported"));
  EXPECT_THAT(raw_error(R"({"feltline":"new"})"), HasSubstr("not a format version"));
  EXPECT_THAT(raw_error(R"({"feltline":1,"unit":"px"})"), HasSubstr("px is not mm"));
}

constexpr const char* kSketch =
    R"({"id":"s1","closed":false,"segments":[[0,0,1,1,2,1,3,0],[3,0,4,-1,5,-1,6,0]],)"
    R"("joints":["corner"],"widths":[[0,0.5],[1.25,1],[2,0.5]],"material":"ink","color":"#ff0000"})";

TEST(NdjsonSketch, ReadsAWholeRecord) {
  const Parsed parsed = parse_sketch(kSketch);
  EXPECT_EQ(parsed.error, "");
  EXPECT_EQ(parsed.sketch.id, "s1");
  const StrokeData& data = parsed.sketch.data;
  const std::vector<Point> points = {{0, 0}, {1, 1}, {2, 1}, {3, 0}, {4, -1}, {5, -1}, {6, 0}};
  EXPECT_EQ(data.points, points);
  EXPECT_EQ(data.joints, std::vector{JointKind::kCorner});
  EXPECT_EQ(data.widths, (std::vector<WidthKnot>{{0, 0.5}, {1.25, 1}, {2, 0.5}}));
  EXPECT_FALSE(data.closed);
  EXPECT_EQ(data.medium, "ink");
  EXPECT_EQ(data.color, (Rgba{255, 0, 0, 255}));
}

std::string sketch_with_tones(const std::string& tones) {
  const std::string text = kSketch;
  return text.substr(0, text.size() - 1) + ",\"tones\":" + tones + "}";
}

TEST(NdjsonSketch, TonesBelongToTheWidthsWhereverTheyStand) {
  const std::vector<WidthKnot> knots{{0, 0.5, 0.0}, {1.25, 1, 0.75}, {2, 0.5, 1.0}};
  EXPECT_EQ(parse_sketch(sketch_with_tones("[0,0.75,1]")).sketch.data.widths, knots);
  std::string before = kSketch;
  before.insert(1, R"("tones":[0,0.75,1],)");
  EXPECT_EQ(parse_sketch(before).sketch.data.widths, knots);
  // Without tones, the tones are those of the widths.
  for (const WidthKnot& knot : parse_sketch(kSketch).sketch.data.widths) {
    EXPECT_EQ(knot.tone, tone_of_width(knot.width_mm));
  }
}

TEST(NdjsonSketch, TonesThatAreNoneAreAnErrorThatNamesThePlace) {
  const auto error = [](const char* tones) { return sketch_error(sketch_with_tones(tones)); };
  EXPECT_EQ(error("[0,1]"), "tones: 2 for 3 widths");
  EXPECT_EQ(error("[0,1,0,1]"), "tones: 4 for 3 widths");
  EXPECT_EQ(error("[]"), "tones: 0 for 3 widths");
  EXPECT_EQ(error("[0,1.01,0]"), "tones[1]: 1.01 is not from 0 to 1");
  EXPECT_EQ(error("[0,0,-1e-9]"), "tones[2]: -1e-9 is not from 0 to 1");
  EXPECT_EQ(error("[null,0,0]"), "tones[0]: null is not a number");
  EXPECT_THAT(error("[0,1e999,0]"), HasSubstr("tones[1]: "));
  EXPECT_THAT(error("[0,NaN,0]"), HasSubstr("tones[1]: "));
  EXPECT_THAT(error("0.5"), HasSubstr("tones: 0.5 is not an array"));
}

TEST(NdjsonSketch, NamesTheKeyTheIndexAndTheReason) {
  const auto swapped = [](const std::string& from, const std::string& to) {
    std::string text = kSketch;
    text.replace(text.find(from), from.size(), to);
    return sketch_error(text);
  };
  EXPECT_EQ(swapped("[3,0,4", "[3,1e-9,4"),
            "segments[1]: does not start at the end of the previous one");
  EXPECT_EQ(swapped(",6,0]", ",6]"), "segments[1]: 7 numbers instead of 8");
  EXPECT_EQ(swapped(",6,0]", ",6,0,0]"), "segments[1]: more than 8 numbers");
  EXPECT_EQ(swapped(",6,0]", ",6,null]"), "segments[1]: number 7: null is not a number");
  EXPECT_EQ(swapped("\"corner\"", "\"round\""),
            "joints[0]: \"round\" is not \"smooth\" or \"corner\"");
  EXPECT_EQ(swapped("\"corner\"", "1"), "joints[0]: 1 is not \"smooth\" or \"corner\"");
  EXPECT_EQ(swapped("[1.25,1]", "[1.25]"), "widths[1]: 1 numbers instead of 2");
  EXPECT_EQ(swapped("[1.25,1]", "7"), "widths[1]: 7 is not an array");
  EXPECT_EQ(swapped("false", "0"), "closed: 0 is not true or false");
  EXPECT_EQ(swapped("#ff0000", "red"), "color: red is not #rrggbb or #rrggbbaa");
  EXPECT_EQ(swapped("\"ink\"", "7"), "material: 7 is not a string");
  EXPECT_EQ(swapped("\"widths\"", "\"width\""), "key \"widths\" is missing");
  EXPECT_EQ(swapped("\"closed\":false", "\"id\":\"s2\""), "key \"id\" occurs twice");
}

// The limit is two orders of magnitude above the measured time, so that only a change of the order
// of growth fails.
TEST(NdjsonLimits, AMillionPointsAreReadInTime) {
  std::string text = "{\"points\":[[0,0]";
  for (int i = 0; i < 1'000'000; ++i) text += ",[1.25,2.5,0.5,10]";
  text += "]}";
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(parse_raw(text).stroke.samples.size(), 1'000'001U);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

}  // namespace
}  // namespace felt::ndjson_parser_test
