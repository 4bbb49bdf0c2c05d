#include "felt/io/svg_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "felt/io/svg_writer.h"
#include "felt/stroke/random_stroke.h"

namespace felt {
namespace {

using ::testing::HasSubstr;

Sketch random_sketch(std::uint64_t seed, int count) {
  Sketch sketch;
  for (int i = 0; i < count; ++i) {
    StrokeData data =
        felt::testing::random_stroke(1000 * seed + static_cast<std::uint64_t>(i)).data();
    if (i % 3 == 1) data.material = "Kohle \"weich\" <&>\n";
    sketch.push_back({"s" + std::to_string(i), Stroke::create(std::move(data)).value()});
  }
  return sketch;
}

TEST(SvgReader, WhatWeWroteReadsBackExactly) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Sketch sketch = random_sketch(seed, static_cast<int>(seed % 7));
    SvgOptions options;
    if (seed % 2 == 0) options.sheet = Rect{0.0, 0.0, 297.0, 210.0};
    if (seed % 3 == 0) options.paper = {250, 240, 1, static_cast<std::uint8_t>(1 + seed)};
    const std::string text = svg_text(sketch, options).value();
    const Result<SvgDrawing> back = parse_svg(text);
    ASSERT_TRUE(back) << "seed " << seed << ": " << back.error().message;
    EXPECT_EQ(back->sketch, sketch) << "seed " << seed;
    EXPECT_EQ(back->paper.a, options.paper.a);
    EXPECT_TRUE(options.paper.a == 0 || back->paper == options.paper) << "seed " << seed;
    EXPECT_TRUE(!options.sheet || back->area == *options.sheet) << "seed " << seed;
    EXPECT_EQ(svg_text(back->sketch, options).value(), text) << "seed " << seed;
  }
}

TEST(SvgReader, EveryAlphaReadsBack) {
  for (int alpha = 0; alpha < 256; ++alpha) {
    StrokeData data = felt::testing::random_stroke(1).data();
    data.color = {1, 2, 3, static_cast<std::uint8_t>(alpha)};
    const Sketch sketch{{"a", Stroke::create(std::move(data)).value()}};
    EXPECT_EQ(parse_svg(svg_text(sketch, {}).value()).value().sketch, sketch) << alpha;
  }
}

std::string changed(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

TEST(SvgReader, SaysWhatItDoesNotRead) {
  const std::string text = svg_text(random_sketch(1, 2), {}).value();
  const auto message = [](const std::string& svg) {
    const Result<SvgDrawing> drawing = parse_svg(svg);
    return drawing ? std::string("it was read") : drawing.error().message;
  };
  EXPECT_THAT(message(""), HasSubstr("no XML"));
  EXPECT_THAT(message("<html/>"), HasSubstr("no SVG"));
  EXPECT_THAT(message("<svg xmlns='http://www.w3.org/2000/svg'/>"), HasSubstr("another program"));
  EXPECT_THAT(message(changed(text, "</svg>", "<circle id='c' r='1'/></svg>")),
              HasSubstr("the circle 'c' is not of Feltline"));
  EXPECT_THAT(message(changed(text, "<path id=", "<path transform='scale(2)' id=")),
              HasSubstr("moved by another program"));
  EXPECT_THAT(message(changed(text, "felt:version=\"1\"", "felt:version=\"2\"")),
              HasSubstr("newer Feltline"));
  EXPECT_THAT(message(changed(text, "felt:closed=\"", "felt:closed=\"x")),
              HasSubstr("the path 'stroke1': closed"));
  EXPECT_THAT(message(changed(text, "felt:widths=\"0,", "felt:widths=\"nan,")),
              HasSubstr("the path 'stroke1': widths"));
  EXPECT_THAT(message(changed(text, "original-d=\"M ", "original-d=\"M 1e99,2 ")),
              HasSubstr("original-d"));
  EXPECT_THAT(message(text.substr(0, text.size() / 2)), HasSubstr("line "));
}

TEST(SvgReader, GroupsAndForeignDataDoNotMatter) {
  const Sketch sketch = random_sketch(2, 3);
  std::string text = svg_text(sketch, {}).value();
  text = changed(text, "<path id=", "<metadata><x/></metadata><!-- note --><g><g/><path id=");
  text = changed(text, "</svg>", "</g><title>x</title></svg>");
  text = changed(text, "<defs>", "<defs><circle r='1'/>");
  EXPECT_EQ(parse_svg(text).value().sketch, sketch);
}

TEST(SvgReader, DamageIsAnErrorOrADrawing) {
  const std::string text = svg_text(random_sketch(3, 3), {}).value();
  std::mt19937 random(6);
  for (int run = 0; run < 5000; ++run) {
    std::string bad = text;
    for (auto k = 1 + random() % 3; k > 0; --k) {
      bad[random() % bad.size()] = static_cast<char>(random());
    }
    if (run % 5 == 0) bad.resize(random() % bad.size());
    if (const Result<SvgDrawing> read = parse_svg(bad)) {
      for (const SketchStroke& s : read->sketch) EXPECT_TRUE(check_invariants(s.stroke.data()));
    }
  }
  // Depth is no danger.
  std::string deep = changed(text, "<path id=", "@");
  std::string opened;
  for (int i = 0; i < 300'000; ++i) opened += "<g>";
  EXPECT_FALSE(parse_svg(changed(deep, "@", opened + "<path id=")));
}

}  // namespace
}  // namespace felt
