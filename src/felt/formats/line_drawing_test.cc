#include "felt/formats/line_drawing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "felt/io/testing/test_drawings.h"
#include "felt/stroke/testing/test_ink.h"

namespace felt::line_drawing_test {
namespace {

Drawing inked(int count) {
  std::vector<Stroke> strokes;
  for (int i = 0; i < count; ++i) {
    testing::TestInk random(static_cast<std::uint64_t>(i));
    InkFitter fitter({});
    for (const Point p : random.draw(testing::InkShape::kSmooth, random.pick(1, 300))) {
      fitter.push({.position = p, .pressure = random.uniform(0.2, 0.8), .time_ns = {}});
    }
    fitter.end();
    strokes.push_back(fitter.stroke().value());
  }
  return testing::drawing_of(strokes);
}

std::string lines_of(const Drawing& drawing) {
  return bytes_of(*line_parts(drawing)).value();
}

// Returns the text with every number that has a decimal point printed with `decimals` decimals.
std::string printed_with(const std::string& text, int decimals) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t end = std::min(text.find_first_not_of("0123456789.e+-", i), text.size());
    const std::string number = text.substr(i, end - i);
    if (number.find('.') != std::string::npos) {
      char buffer[64];
      std::snprintf(buffer, sizeof(buffer), "%.*f", decimals, std::strtod(number.c_str(), nullptr));
      out += buffer;
      i = end;
    } else {
      out += text[i++];
    }
  }
  return out;
}

double largest_move(const Stroke& a, const Stroke& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.data().points.size(); ++i) {
    largest = std::max(largest, distance(a.data().points[i], b.data().points[i]));
  }
  return largest;
}

TEST(LineDrawing, ASketchPrintedWithFewDecimalsIsReadWholeAndSaidOnce) {
  const Drawing drawing = inked(120);
  const std::vector<Stroke> strokes = testing::strokes_in(drawing.document);
  for (const int decimals : {3, 5}) {
    SCOPED_TRACE(decimals);
    const auto read = import_lines(printed_with(lines_of(drawing), decimals));
    ASSERT_TRUE(read) << read.error().message;
    const std::vector<Stroke> back = testing::strokes_in(read->drawing.document);
    ASSERT_EQ(back.size(), strokes.size());
    // Half of the last decimal is lost in each coordinate, and correcting it moves points by less
    // than 0.001 mm.
    const double lost = std::sqrt(0.5) * std::pow(10.0, -decimals);
    for (std::size_t i = 0; i < back.size(); ++i) {
      EXPECT_LE(largest_move(back[i], strokes[i]), lost + 0.002) << i;
    }
    ASSERT_EQ(read->report.notices().size(), 1u);
    EXPECT_EQ(read->report.notices()[0].what, kMendedNotice);
    EXPECT_GT(read->report.notices()[0].count, 60);
  }
  const auto exact = import_lines(lines_of(drawing));
  ASSERT_TRUE(exact);
  EXPECT_TRUE(exact->report.empty());
  EXPECT_EQ(exact->drawing, drawing);
}

TEST(LineDrawing, RawPressuresAndTimesThatAreNoneAreNamedOnceWithTheirNumber) {
  std::string lines;
  for (int k = 0; k < 20; ++k) {
    lines += R"({"id":"raw)" + std::to_string(k) + R"(","points":[[0,0,200,7],[4,1,)" +
             std::to_string(500 + k) + R"(,7],[8,0,900,7],[12,1,300,7]]})" + "\n";
    lines += R"({"points":[[0,0,0.2,0],[4,1,0.5,8],[8,0,0.9,16],[12,1,0.3,24]]})"
             "\n";
    lines += R"({"points":[[0,0,0.2,24],[4,1,0.5,16],[8,0,0.9,8],[12,1,0.3,0]]})"
             "\n";
  }
  const auto read = import_lines(lines);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->drawing.document.stroke_count(), 60u);
  ASSERT_EQ(read->report.notices().size(), 2u);
  EXPECT_EQ(notice_text(read->report.notices()[0]).substr(0, 57),
            "line 1: stroke 'raw0' (4 of 4 pressures, for example 900)");
  EXPECT_EQ(read->report.notices()[0].count, 20);
  EXPECT_EQ(read->report.notices()[1].line, 3);
  EXPECT_EQ(read->report.notices()[1].count, 20);
}

TEST(LineDrawing, WhatRoundingDoesNotExplainIsStillRefused) {
  const auto read = import_lines(R"({"id":"a","segments":[[[0,0],[1,0],[2,0],[3,0]]],)"
                                 R"("joints":["smooth"],"widths":[[0,1],[1,1]]})"
                                 "\n");
  EXPECT_FALSE(read);
}

}  // namespace
}  // namespace felt::line_drawing_test
