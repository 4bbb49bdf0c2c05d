#include "felt/io/svg/svg_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <pugixml.hpp>
#include <sstream>

#include "felt/base/atomic_file.h"
#include "felt/document/testing/random_fills.h"
#include "felt/io/drawing_builder.h"
#include "felt/io/picture/png.h"
#include "felt/io/svg/svg_compact.h"
#include "felt/io/svg/svg_elements.h"
#include "felt/io/svg/svg_import.h"
#include "felt/io/svg/svg_path_parser.h"
#include "felt/io/testing/import_checks.h"
#include "felt/io/testing/test_drawings.h"
#include "felt/io/xml/xml_text.h"
#include "felt/render/page_painter.h"
#include "felt/render/styled_outline.h"
#include "felt/stroke/testing/ink_oracle.h"
#include "felt/stroke/testing/random_stroke.h"
#include "tests/support/scratch_path.h"

namespace felt::svg_writer_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::vector<Stroke> strokes_in_rows(std::uint64_t first, int count) {
  std::vector<Stroke> strokes;
  for (int i = 0; i < count; ++i) {
    const std::uint64_t seed = first + static_cast<std::uint64_t>(i);
    StrokeData data = testing::RandomStroke(seed).make();
    const int row = i / 4;
    for (Point& p : data.points) p += Vec{30.0 * (i % 4), 30.0 * row};
    strokes.push_back(Stroke::create(std::move(data)).value());
  }
  return strokes;
}

std::string stream_text(const std::vector<Stroke>& strokes, const SvgOptions& options = {}) {
  return svg_ink_text(testing::drawing_of(strokes), options).value();
}

/// An independent reader: parses the text by hand, as docs/formats/svg.md specifies.
class ExactText {
 public:
  explicit ExactText(std::string text) : text_(std::move(text)) {}

  [[nodiscard]] std::size_t size() const { return (text_.size() - 1) / digits(); }
  [[nodiscard]] double at(std::size_t i, double guess) const {
    std::uint64_t folded = 0;
    for (std::size_t k = digits(); k-- > 0;) {
      folded = folded * 64 + value(text_[1 + i * digits() + k]);
    }
    const std::uint64_t up = folded % 2 == 0 ? folded / 2 : 0;
    const std::uint64_t down = folded % 2 == 1 ? folded / 2 + 1 : 0;
    // Counts steps from a double to its neighbours; +0 and -0 are neighbours too.
    const auto bits = std::bit_cast<std::int64_t>(guess);
    const auto rank = bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits - 1 : bits;
    const auto moved = static_cast<std::int64_t>(static_cast<std::uint64_t>(rank) + up - down);
    return std::bit_cast<double>(moved < 0 ? std::numeric_limits<std::int64_t>::min() - moved - 1
                                           : moved);
  }

 private:
  [[nodiscard]] std::size_t digits() const { return value(text_.at(0)); }
  static std::size_t value(char c) {
    return std::string_view("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/")
        .find(c);
  }
  std::string text_;
};

/// Returns the control points in steps of 0.001 mm, from relative commands in mm.
std::vector<Point> steps_of(std::string text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (std::string_view("MCcz").find(text[i]) != std::string_view::npos) text[i] = ' ';
    if (text[i] == '-') text.insert(i++, " ");
  }
  std::istringstream in(text);
  std::vector<Point> points;
  Point from;
  for (Point p; in >> p.x >> p.y;) {
    points.push_back(points.empty() ? p : Point{from.x + p.x, from.y + p.y});
    if (points.size() % 3 == 1) from = points.back();
  }
  for (Point& q : points) q = {std::round(1000.0 * q.x) + 0.0, std::round(1000.0 * q.y) + 0.0};
  return points;
}

/// Returns the stroke that our attributes on a path describe.
StrokeData model_of(const pugi::xml_node& path) {
  StrokeData d;
  const std::string line = path.attribute("inkscape:original-d").value();
  const ExactText exact(path.attribute("felt:points").value());
  d.closed = line.back() == 'z';
  std::size_t k = 0;
  for (const Point& p : steps_of(line)) {
    if (2 * k == exact.size()) break;
    d.points.push_back({exact.at(2 * k, p.x / 1000.0), exact.at(2 * k + 1, p.y / 1000.0)});
    ++k;
  }
  if (d.closed) d.points.push_back(d.points.front());
  const ExactText widths(path.attribute("felt:widths").value());
  const std::size_t inner = widths.size() / 2 - 1;
  for (std::size_t i = 0; i < inner + 2; ++i) {
    const double end = static_cast<double>(d.points.size() / 3);
    const double u = i == 0 ? 0.0 : i <= inner ? widths.at(i - 1, 1.0) : end;
    d.widths.push_back({u, widths.at(inner + i, 1.0)});
  }
  if (const pugi::xml_attribute text = path.attribute("felt:tones")) {
    const ExactText tones(text.value());
    for (std::size_t i = 0; i < tones.size(); ++i) d.widths.at(i).tone = tones.at(i, 1.0);
  }
  for (const char c : std::string(path.attribute("felt:joints").value())) {
    d.joints.push_back(c == 's' ? JointKind::kSmooth : JointKind::kCorner);
  }
  d.medium = path.attribute("felt:material").as_string("pencil");
  const auto rgb = std::strtoul(path.attribute("fill").value() + 1, nullptr, 16);
  const double opacity = path.attribute("fill-opacity").as_double(1.0);
  d.color = {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8),
             static_cast<std::uint8_t>(rgb),
             static_cast<std::uint8_t>(std::lround(opacity * 255.0))};
  return d;
}

pugi::xml_document parsed(const std::string& text) {
  pugi::xml_document document;
  const auto result = document.load_buffer(text.data(), text.size());
  EXPECT_TRUE(result) << result.description();
  return document;
}

constexpr std::size_t kMaxBytesAStroke = 3200;

TEST(SvgWriter, CarriesTheModelExactly) {
  const std::vector<Stroke> strokes = strokes_in_rows(100, 60);
  const auto document = parsed(stream_text(strokes));
  std::size_t i = 0;
  for (const pugi::xml_node path : document.child("svg").child("g").children("path")) {
    EXPECT_EQ(path.attribute("felt:id").as_string(path.attribute("id").value()),
              "s" + std::to_string(i + 1));
    EXPECT_EQ(model_of(path), strokes[i].data()) << i;
    ++i;
  }
  EXPECT_EQ(i, strokes.size());
}

/// Returns a drawing with fills and strokes in two layers.
Drawing drawing_with_fills(std::uint64_t seed) {
  testing::RandomStroke random(seed);
  DrawingBuilder builder;
  builder.drawing().has_page = true;
  for (int l = 0; l < 2; ++l) {
    const std::size_t layer = builder.add_layer({"Layer " + std::to_string(l + 1)});
    builder.add(layer, testing::random_stroke(seed + std::uint64_t(l)));
    for (int k = 0; k < 4; ++k) {
      builder.add_fill(layer, std::make_shared<const Fill>(testing::random_fill(random)),
                       k == 0 ? "f" + std::to_string(50 + l) : "");
    }
  }
  return std::move(builder).build();
}

TEST(SvgWriter, FillsComeBackExactlyWithTheirReferences) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Drawing drawing = drawing_with_fills(seed);
    const Result<Imported> back = import_svg(svg_text(drawing, {}).value());
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_TRUE(back->report.empty()) << testing::notice_lines(*back);
    EXPECT_EQ(back->drawing.document.fill_count(), 8U);
    EXPECT_TRUE(back->drawing.document.find_fill({51}));
    ASSERT_TRUE(back->drawing.document == drawing.document) << "seed " << seed;
  }
}

TEST(SvgWriter, CompactFilesHaveTheAreasButNoReferences) {
  const Drawing drawing = drawing_with_fills(3);
  const std::string text = svg_compact_text(drawing, {}).value();
  EXPECT_EQ(text.find("felt:"), std::string::npos);
  const Result<Imported> back = import_svg(text);
  ASSERT_TRUE(back) << back.error().message;
  std::size_t visible = 0;
  for (const Layer& layer : back->drawing.document.layers()) visible += layer.fills.size();
  EXPECT_GE(visible, 8U);
}

/// Returns the `d` of a path as polygons in mm, with curves divided finely. The writer uses
/// relative lines and curves.
Outline outline_in(const std::string& d) {
  constexpr int kSteps = 64;
  Outline outline;
  Point here;
  std::istringstream in(d);
  char command = 0;
  const auto next_point = [&] {
    Point p;
    EXPECT_TRUE(in >> p.x >> p.y) << d;
    return p;
  };
  while (in >> std::ws && !in.eof()) {
    if (std::isalpha(in.peek()) != 0) in >> command;
    if (command == 'z') {
      outline.ends.push_back(outline.points.size());
      continue;
    }
    if (command == 'c') {
      Cubic c{{here, {}, {}, {}}};
      for (std::size_t k = 1; k < 4; ++k) c.p[k] = here + (next_point() - Point{});
      for (int i = 1; i <= kSteps; ++i) {
        outline.points.push_back(evaluate(c, static_cast<double>(i) / kSteps));
      }
      here = c.p[3];
    } else if (command == 'M' || command == 'l') {
      const Point p = next_point();
      here = command == 'M' ? p : here + (p - Point{});
      outline.points.push_back(here);
    } else {
      ADD_FAILURE() << "unknown command " << command << " in " << d;
      break;
    }
  }
  return outline;
}

/// Checks the path as other programs see it: rounded to steps, with lines for flat curves.
TEST(SvgWriter, R53_TheWrittenPathIsWithinAHundredthOfAMillimetre) {
  const std::vector<Stroke> strokes = strokes_in_rows(300, 60);
  const auto document = parsed(stream_text(strokes));
  std::size_t i = 0;
  for (const pugi::xml_node path : document.child("svg").child("g").children("path")) {
    SCOPED_TRACE(i);
    testing::expect_outline_is_the_ink(outline_in(path.attribute("d").value()), strokes[i], 0.01, i,
                                       400);
    ++i;
  }
  EXPECT_EQ(i, strokes.size());
}

/// A stroke took 6.6 kB before steps and exact numbers were introduced.
TEST(SvgWriter, R53_AStrokeTakesFewBytes) {
  const std::vector<Stroke> strokes = strokes_in_rows(100, 60);
  EXPECT_LE(stream_text(strokes).size() / strokes.size(), kMaxBytesAStroke);
}

TEST(SvgWriter, PowerStrokeKnotsAreHalfWidths) {
  const auto document = parsed(stream_text({testing::straight_stroke({0, 0}, {10, 0}, 0.3, 1.7)}));
  const pugi::xml_node svg = document.child("svg");
  const pugi::xml_node group = svg.child("g");
  // Inkscape computes the effect to 0.01 user units: smaller units than mm make it fail.
  EXPECT_FALSE(group.attribute("transform"));
  const pugi::xml_node effect = group.child("defs").child("inkscape:path-effect");
  EXPECT_STREQ(effect.attribute("offset_points").value(), "0,.15 | 1,.85");
  EXPECT_STREQ(effect.attribute("effect").value(), "powerstroke");
  EXPECT_STREQ(effect.attribute("interpolator_type").value(), "Linear");
  EXPECT_EQ(std::string("#") + effect.attribute("id").value(),
            group.child("path").attribute("inkscape:path-effect").value());
  EXPECT_FALSE(group.child("path").attribute("stroke"));
}

Stroke with_medium(const Stroke& stroke, const std::string& medium) {
  StrokeData data = stroke.data();
  data.medium = medium;
  return Stroke::create(std::move(data)).value();
}

/// A style is a path for all programs and comes back as the same stroke. Inkscape has an effect for
/// shapes; the other styles keep the PowerStroke.
TEST(SvgWriter, StylesArePathsAndStrokesComeBack) {
  for (const char* medium : {"dashed-pen", "double-line", "arrow-pen", "rope", "leaf", "hatched"}) {
    const bool has_shape = std::string(medium) == "rope" || std::string(medium) == "leaf";
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      SCOPED_TRACE(medium + std::to_string(seed));
      const Stroke stroke = with_medium(testing::random_stroke(seed), medium);
      const std::string text = stream_text({stroke});
      const auto document = parsed(text);
      const pugi::xml_node group = document.child("svg").child("g");
      EXPECT_EQ(model_of(group.child("path")), stroke.data());
      EXPECT_STREQ(group.child("defs").child("inkscape:path-effect").attribute("effect").value(),
                   has_shape ? "skeletal" : "powerstroke");
      std::string path;
      append_path_data(path, styled_path(stroke, StrokeStyles().find(medium), 0.005));
      EXPECT_EQ(group.child("path").attribute("d").value(), path);
      const Result<Imported> back = import_svg(text, {});
      ASSERT_TRUE(back) << back.error().message;
      const auto& layers = back->drawing.document.layers();
      EXPECT_EQ(*back->drawing.document.find(layers[0].strokes[0]), stroke);
    }
  }
}

/// Inkscape rounds the number of copies down (LPEPatternAlongPath::doEffect_pwd2). It must make as
/// many copies as Feltline draws, and at least one: with none, the line would be invisible.
TEST(SvgWriter, R57_InkscapeRepeatsAShapeAsOftenAsFeltline) {
  const auto copies_of = [](const Stroke& stroke) {
    const auto document = parsed(stream_text({stroke}));
    const pugi::xml_node effect =
        document.child("svg").child("g").child("defs").child("inkscape:path-effect");
    const double spacing = effect.attribute("spacing").as_double();
    const double start = effect.attribute("tang_offset").as_double();
    const SvgPathData pattern = parse_svg_path(effect.attribute("pattern").value(), 1000);
    Rect box;
    for (const SvgContour& contour : pattern.contours) {
      for (const Point p : contour.points) box.extend(p);
    }
    const double length = distance(stroke.data().points.front(), stroke.data().points.back());
    return std::floor((length - start + spacing) / (box.width() + spacing));
  };
  for (const double length : {1.2, 2.0, 5.0, 17.0, 33.3, 90.0}) {
    const Stroke line =
        with_medium(testing::straight_stroke({0, 0}, {length, 0}, 2.0, 2.0), "rope");
    StrokeStyler styler;
    const StrokeStyle& rope = *StrokeStyles().find("rope");
    const std::size_t contours = styler.ink(line, rope, 0.01).outline.contour_count();
    EXPECT_EQ(copies_of(line), static_cast<double>(contours / rope.shape.contours.size()))
        << length;
  }
}

/// Inkscape changes the line of an effect. The stroke keeps its medium and widths.
TEST(SvgWriter, ALineWithAShapeCanBeEditedInInkscape) {
  std::string text =
      stream_text({with_medium(testing::straight_stroke({0, 0}, {30, 0}, 1.0, 3.0), "rope")});
  const std::string_view before = "inkscape:original-d=\"M0 0c10 0 20 0 30 0\"";
  const std::size_t at = text.find(before);
  ASSERT_NE(at, std::string::npos) << text;
  text.replace(at, before.size(), "inkscape:original-d=\"M0 0C10 5 20 5 30 0C40 -5 50 -5 60 0\"");
  const Result<Imported> back = import_svg(text, {});
  ASSERT_TRUE(back) << back.error().message;
  const Document& document = back->drawing.document;
  const StrokePtr stroke = document.find(document.layers()[0].strokes[0]);
  EXPECT_EQ(stroke->medium(), "rope");
  EXPECT_EQ(stroke->segment_count(), 2);
  EXPECT_NEAR(stroke->width_mm(0.0), 1.0, 1e-9);
  EXPECT_NEAR(stroke->width_mm(1.0), 2.0, 1e-9);
  EXPECT_NEAR(stroke->width_mm(2.0), 3.0, 1e-9);
}

TEST(SvgWriter, StatesTheAreaInMillimetres) {
  const auto document = parsed(stream_text({testing::straight_stroke({10, 20}, {40, 20}, 1.0, 1.0)},
                                           {.area = {}, .margin_mm = 2.0}));
  const pugi::xml_node svg = document.child("svg");
  EXPECT_STREQ(svg.attribute("width").value(), "35mm");
  EXPECT_STREQ(svg.attribute("viewBox").value(), "7.5 17.5 35 5");
  const SvgOptions a4{.area = Rect{0, 0, 210, 297}};
  EXPECT_STREQ(parsed(stream_text({}, a4)).child("svg").attribute("viewBox").value(),
               "0 0 210 297");
}

TEST(SvgWriter, EveryAlphaComesBack) {
  StrokeData data = testing::straight_stroke({0, 0}, {9, 0}, 1, 1).data();
  for (int a = 0; a < 256; ++a) {
    data.color.a = static_cast<std::uint8_t>(a);
    const auto document = parsed(stream_text({*Stroke::create(data)}));
    EXPECT_EQ(model_of(document.child("svg").child("g").child("path")).color, data.color);
  }
}

TEST(SvgWriter, RefusesWhatXmlCannotHold) {
  const Stroke s = testing::straight_stroke({0, 0}, {9, 0}, 1, 1);
  for (const std::string& id :
       {std::string("a\x01"), std::string("nul\0", 4), std::string("\xff"), std::string("\xc0\x80"),
        std::string("\xed\xa0\x80"), std::string("\xef\xbf\xbe"), std::string("cut \xe2\x82")}) {
    std::string text = "before";
    const Result<void> done = append_svg_stroke(text, {id}, s, 2, 0.005);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().code, ErrorCode::kInvalidData);
    EXPECT_EQ(text, "before");
  }
  const std::string id = "Skizze <\xe2\x9c\x8f> \"&\"\t\n \xf0\x9f\x8e\xa8";
  std::string text;
  append_svg_head(text, {0, 0, 9, 9}, {255, 255, 255, 0});
  EXPECT_EQ(text.size(), kSvgHeadBytes);
  ASSERT_TRUE(append_svg_stroke(text, {id}, s, 2, 0.005));
  append_svg_tail(text);
  EXPECT_EQ(parsed(text).child("svg").child("path").attribute("felt:id").value(), id);
}

TEST(SvgWriter, AStreamOfADrawingsStrokesIsTheSameText) {
  Drawing drawing = testing::drawing_of(strokes_in_rows(7, 12));
  drawing.has_page = false;
  drawing.names = std::make_shared<const StrokeNames>(StrokeNames{{StrokeId{12}, "cat-1"}});
  const SvgOptions options{.area = Rect{-1, -2, 90, 80}};
  std::string text = svg_head({.has_page = false}, options, {}).value();
  EXPECT_EQ(text.size(), kSvgHeadBytes);
  ASSERT_TRUE(append_svg_layer_begin(text, Document().layers()[0], 1));
  for (const StrokeId id : drawing.document.layers()[0].strokes) {
    ASSERT_TRUE(append_svg_stroke(text, {xml_stroke_name(drawing, id)}, *drawing.document.find(id),
                                  id.value, options.tolerance_mm));
  }
  append_svg_group_end(text);
  append_svg_tail(text);
  EXPECT_EQ(text, svg_text(drawing, options).value());
}

TEST(SvgWriter, TheHeadHasTheSameSizeForEveryArea) {
  for (const double mm : {0.001, 12.345, 1e9 - 0.001}) {
    for (const Rgba paper : {Rgba{255, 255, 255, 0}, Rgba{1, 2, 3, 4}}) {
      const SvgOptions options{.area = Rect{-mm, -mm, mm, mm}, .paper = paper};
      EXPECT_EQ(svg_head({.has_page = false}, options, {}).value().size(), kSvgHeadBytes);
    }
  }
  Drawing largest;
  largest.page = {4999.9999, 4999.9999, {1, 2, 3, 4}, {}};
  EXPECT_EQ(svg_head(largest, {}, {}).value().size(), kSvgHeadBytes);
}

TEST(SvgWriter, ANameThatXmlForbidsGivesWayToTheNumber) {
  Drawing drawing = testing::drawing_of(strokes_in_rows(2, 12));
  drawing.names =
      std::make_shared<const StrokeNames>(StrokeNames{{StrokeId{1}, "a\x01"}, {StrokeId{2}, "b"}});
  const std::string text = svg_text(drawing, {}).value();
  EXPECT_EQ(text.find("felt:id"), text.find("felt:id=\"b\""));
}

TEST(SvgWriter, AStreamOfStrokesIsTheSameText) {
  const Drawing drawing = testing::drawing_of(strokes_in_rows(7, 12));
  std::string text;
  append_svg_head(text, picture_area(ink_bounds(drawing.document), {}, 5.0), {255, 255, 255, 0});
  append_svg_group_begin(text);
  for (const StrokeId id : drawing.document.layers()[0].strokes) {
    ASSERT_TRUE(append_svg_stroke(text, {stroke_name(id)}, *drawing.document.find(id), id.value,
                                  SvgOptions{}.tolerance_mm));
  }
  append_svg_group_end(text);
  append_svg_tail(text);
  EXPECT_EQ(text, svg_ink_text(drawing, {}).value());
}

/// Returns the largest and the mean difference of two pictures' channels.
std::pair<int, double> difference(const Image& a, const Image& b) {
  int worst = 0;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.bytes().size(); ++i) {
    const int d = std::abs(a.bytes()[i] - b.bytes()[i]);
    worst = std::max(worst, d);
    sum += d;
  }
  return {worst, sum / static_cast<double>(a.bytes().size())};
}

TEST(SvgWriter, AnotherProgramShowsTheSamePicture) {
  if (std::system("command -v rsvg-convert >/dev/null 2>&1") != 0) {
    GTEST_SKIP() << "rsvg-convert is not installed (package librsvg2-bin)";
  }
  const std::vector<Stroke> strokes = strokes_in_rows(40, 16);
  const SvgOptions options{.area = Rect{-10, -10, 130, 130}};
  const std::string svg = scratch_path("svg-view.svg");
  const std::string png = svg + ".png";
  const Drawing drawing = testing::drawing_of(strokes);
  ASSERT_TRUE(write_file(svg, stream_text(strokes, options)));
  ASSERT_EQ(std::system(("rsvg-convert -w 1400 -h 1400 -b white " + svg + " -o " + png).c_str()),
            0);
  std::ifstream in(png, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  const Image theirs = decode_png(bytes.str()).value().image;
  const Image ours =
      render_page(visible_strokes(drawing.document), {.dpi = 254.0, .area = options.area}).value();
  ASSERT_EQ(theirs.width(), ours.width());
  ASSERT_EQ(theirs.height(), ours.height());
  const auto [worst, mean] = difference(theirs, ours);
  EXPECT_LE(mean, 0.15);
  EXPECT_LE(worst, 96);
  RecordProperty("worst", worst);
  RecordProperty("mean_1e6", static_cast<int>(1e6 * mean));
  fs::remove(svg);
  fs::remove(png);
}

}  // namespace
}  // namespace felt::svg_writer_test
