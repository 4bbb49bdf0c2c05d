#include "felt/io/inkml/inkml_import.h"

#include <gmock/gmock.h>

#include <cmath>

#include "felt/io/testing/import_checks.h"
#include "felt/io/testing/test_drawings.h"
#include "felt/stroke/fit/ink_fitter.h"

namespace felt::inkml_import_test {
namespace {

using testing::only_stroke;
using testing::texts;

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string ink(const std::string& inside) {
  return "<ink xmlns=\"http://www.w3.org/2003/InkML\">\n" + inside + "</ink>\n";
}

Imported read(const std::string& text) {
  Result<Imported> drawing = import_inkml(text);
  EXPECT_TRUE(drawing) << (drawing ? "" : drawing.error().message);
  return drawing.value();
}

void expect_from_to(const Stroke& s, Point from, Point to) {
  EXPECT_NEAR(distance(s.position(0.0), from), 0.0, 1e-6);
  EXPECT_NEAR(distance(s.position(s.segment_count()), to), 0.0, 1e-6);
}

const std::string kMm =
    "<traceFormat><channel name=\"X\" type=\"decimal\" units=\"mm\"/>"
    "<channel name=\"Y\" type=\"decimal\" units=\"mm\"/></traceFormat>";

TEST(InkmlImport, WithoutUnitsAPixelIsA96thOfAnInch) {
  const Imported d = read(ink("<trace>\n0 0, 96 0, 192 0\n</trace>\n"));
  expect_from_to(only_stroke(d), {0, 0}, {50.8, 0});
  EXPECT_THAT(texts(d.report),
              ElementsAre("line 2: trace does not define its unit; 1/96 inch was assumed"));
}

TEST(InkmlImport, TheSubsetOfOffice) {
  const Imported d = read(R"(<?xml version="1.0" encoding="UTF-8" standalone="yes"?>
<inkml:ink xmlns:emma="http://www.w3.org/2003/04/emma" xmlns:msink="http://schemas.microsoft.com/ink/2010/main" xmlns:inkml="http://www.w3.org/2003/InkML">
<inkml:definitions><inkml:context xml:id="ctx0"><inkml:inkSource xml:id="inkSrc0"><inkml:traceFormat>
<inkml:channel name="X" type="integer" min="-2.14748E9" max="2.14748E9" units="cm"/>
<inkml:channel name="Y" type="integer" min="-2.14748E9" max="2.14748E9" units="cm"/>
<inkml:channel name="F" type="integer" max="32767" units="dev"/></inkml:traceFormat>
<inkml:channelProperties>
<inkml:channelProperty channel="X" name="resolution" value="1000" units="1/cm"/>
<inkml:channelProperty channel="Y" name="resolution" value="1000" units="1/cm"/>
<inkml:channelProperty channel="F" name="resolution" value="0" units="1/dev"/>
</inkml:channelProperties></inkml:inkSource><inkml:timestamp xml:id="ts0" timeString="2011-02-22T00:21:40.232"/></inkml:context>
<inkml:brush xml:id="br0"><inkml:brushProperty name="width" value="0.1" units="cm"/>
<inkml:brushProperty name="height" value="0.1" units="cm"/><inkml:brushProperty name="color" value="#ED1C24"/>
<inkml:brushProperty name="transparency" value="55"/><inkml:brushProperty name="tip" value="ellipse"/>
<inkml:brushProperty name="rasterOp" value="copyPen"/><inkml:brushProperty name="ignorePressure" value="0"/>
<inkml:brushProperty name="antiAliased" value="1"/><inkml:brushProperty name="fitToCurve" value="1"/></inkml:brush>
</inkml:definitions>
<inkml:traceGroup><inkml:annotationXML><emma:emma version="1.0"><emma:interpretation id="x"><msink:context type="inkDrawing"/></emma:interpretation></emma:emma></inkml:annotationXML>
<inkml:trace contextRef="#ctx0" brushRef="#br0">1000 2000 16384,1000'0'0,1000"0"0,0-0*,0 0 *</inkml:trace>
</inkml:traceGroup></inkml:ink>)");
  EXPECT_THAT(texts(d.report), IsEmpty());
  const Stroke s = only_stroke(d);
  // 1000 units are 1 cm. Prefixes in the trace apply to the numbers after them.
  EXPECT_EQ(s.color(), (Rgba{0xed, 0x1c, 0x24, 200}));
  EXPECT_NEAR(s.position(0.0).x, 10.0, 1e-6);
  EXPECT_NEAR(s.position(0.0).y, 20.0, 1e-6);
  EXPECT_NEAR(s.width_mm(0.0), 0.25 + 1.5 * 16384.0 / 32767.0, 0.01);
}

TEST(InkmlImport, ScalesByResolutionNotByRange) {
  const Imported d = read(
      ink("<inkSource><traceFormat><channel name=\"X\" type=\"integer\" min=\"0\" max=\"9600\" "
          "units=\"in\"/><channel name=\"Y\" type=\"integer\" min=\"0\" max=\"7200\" units=\"in\"/>"
          "</traceFormat><channelProperties><channelProperty channel=\"X\" name=\"resolution\" "
          "value=\"500\" units=\"1/in\"/><channelProperty channel=\"Y\" name=\"resolution\" "
          "value=\"2540\" units=\"1/in\"/></channelProperties></inkSource>\n"
          "<trace>500 2540, 1000 5080</trace>"));
  expect_from_to(only_stroke(d), {25.4, 25.4}, {50.8, 50.8});
  EXPECT_THAT(texts(d.report), IsEmpty());
}

TEST(InkmlImport, UnitsOfLength) {
  const std::vector<std::pair<std::string, double>> units = {
      {"m", 1000},       {"cm", 10},       {"mm", 1},        {"in", 25.4},
      {"pt", 25.4 / 72}, {"pc", 25.4 / 6}, {"himetric", .01}};
  for (const auto& [unit, mm] : units) {
    SCOPED_TRACE(unit);
    const Imported d = read(ink("<traceFormat><channel name=\"Y\" units=\"" + unit +
                                "\"/><channel name=\"X\" units=\"" + unit +
                                "\"/></traceFormat><trace>0 0, 0 1000</trace>"));
    expect_from_to(only_stroke(d), {0, 0}, {1000 * mm, 0});
    EXPECT_THAT(texts(d.report), IsEmpty());
  }
}

TEST(InkmlImport, GivenWidthsAreTheWidths) {
  const Imported d = read(
      ink("<traceFormat><channel name=\"X\" units=\"cm\"/><channel name=\"Y\" units=\"cm\"/>"
          "<channel name=\"W\" units=\"mm\"/></traceFormat><trace>0 0 1, 5 0 2, 10 0 0.5</trace>"));
  const Stroke s = only_stroke(d);
  ASSERT_EQ(s.segment_count(), 2);
  EXPECT_DOUBLE_EQ(s.width_mm(0.0), 1.0);
  EXPECT_DOUBLE_EQ(s.width_mm(1.0), 2.0);
  EXPECT_DOUBLE_EQ(s.width_mm(2.0), 0.5);
}

TEST(InkmlImport, BrushesGiveColourAndWidth) {
  const Imported d = read(ink(
      kMm +
      "<definitions><brush xml:id=\"a\"><brushProperty name=\"color\" value=\"red\"/>"
      "<brushProperty name=\"width\" value=\"53\" units=\"himetric\"/></brush>"
      "<brush xml:id=\"b\" brushRef=\"#a\"><brushProperty name=\"transparency\" "
      "value=\"128\"/></brush>"
      "<brush xml:id=\"c\"><brushProperty name=\"color\" value=\"#FFFF00\"/><brushProperty "
      "name=\"tip\" "
      "value=\"rectangle\"/><brushProperty name=\"rasterOp\" value=\"maskPen\"/><brushProperty "
      "name=\"width\" "
      "value=\"1\" units=\"mm\"/><brushProperty name=\"height\" value=\"4\" "
      "units=\"mm\"/></brush></definitions>\n"
      "<trace brushRef=\"#a\">0 0, 9 0</trace><trace brushRef=\"#b\">0 0, 9 0</trace>"
      "<traceGroup brushRef=\"#c\"><trace>0 0,9 0</trace><trace brushRef=\"#none\">0 0,9 "
      "0</trace></traceGroup>"
      "<brush><brushProperty name=\"color\" value=\"#0000ff\"/></brush><trace>0 0,9 0</trace>"));
  const std::vector<Stroke> s = testing::strokes_in(d.drawing.document, 0);
  ASSERT_EQ(s.size(), 5u);
  EXPECT_EQ(s[0].color(), (Rgba{255, 0, 0, 255}));
  EXPECT_NEAR(s[0].width_mm(0.5), 0.53, 1e-9);
  EXPECT_EQ(s[1].color(), (Rgba{255, 0, 0, 127}));
  EXPECT_NEAR(s[1].width_mm(0.5), 0.53, 1e-9);
  EXPECT_EQ(s[2].color(), (Rgba{255, 255, 0, 127}));
  EXPECT_NEAR(s[2].width_mm(0.5), 4.0, 1e-9);
  EXPECT_EQ(s[3].color(), (Rgba{255, 255, 0, 127})) << "what the group says";
  EXPECT_EQ(s[4].color(), (Rgba{0, 0, 255, 255})) << "a brush between traces holds from there";
  EXPECT_THAT(texts(d.report),
              ::testing::UnorderedElementsAre(
                  "line 2: brushProperty of form 'rectangle' was replaced by a round one",
                  "line 2: brush 'c' is a broad nib; its longer side was used as the width",
                  "line 3: trace has a brushRef to something that does not exist"));
}

TEST(InkmlImport, ContextsAreInheritedAndOverridden) {
  const Imported d = read(
      ink("<definitions><traceFormat xml:id=\"f\"><channel name=\"X\" units=\"cm\"/><channel "
          "name=\"Y\" "
          "units=\"cm\"/></traceFormat><context xml:id=\"one\" traceFormatRef=\"#f\"><brush>"
          "<brushProperty name=\"color\" value=\"#00ff00\"/></brush></context>"
          "<context xml:id=\"two\" contextRef=\"#one\">" +
          kMm +
          "</context></definitions>"
          "<trace contextRef=\"#one\">0 0,5 0</trace><trace contextRef=\"#two\">0 0,5 0</trace>"
          "<context contextRef=\"#one\"/><trace>0 0,5 0</trace>"));
  const std::vector<Stroke> s = testing::strokes_in(d.drawing.document, 0);
  ASSERT_EQ(s.size(), 3u);
  expect_from_to(s[0], {0, 0}, {50, 0});
  expect_from_to(s[1], {0, 0}, {5, 0});
  expect_from_to(s[2], {0, 0}, {50, 0});
  for (const Stroke& each : s) EXPECT_EQ(each.color(), (Rgba{0, 255, 0, 255}));
  EXPECT_THAT(texts(d.report), IsEmpty());
}

TEST(InkmlImport, TransformsToTheCanvas) {
  const std::string canvas = "<canvas xml:id=\"cv\">" + kMm + "</canvas>";
  const std::string forward =
      "<mapping type=\"affine\"><affine>0.5 0 10, 0 -0.5 20</affine></mapping>";
  const auto with = [&](const std::string& mappings) {
    return read(ink(
        "<definitions>" + canvas + "<canvasTransform xml:id=\"t\">" + mappings +
        "</canvasTransform><context xml:id=\"c\" canvasRef=\"#cv\" "
        "canvasTransformRef=\"#t\"/></definitions><trace contextRef=\"#c\">0 0,100 20</trace>"));
  };
  expect_from_to(only_stroke(with(forward)), {10, 20}, {60, 10});
  expect_from_to(
      only_stroke(with("<mapping type=\"lookup\"/>"
                       "<mapping type=\"affine\"><affine>2 0 -20, 0 -2 40</affine></mapping>")),
      {10, 20}, {60, 10});
  expect_from_to(only_stroke(with("<mapping type=\"identity\"/>")), {0, 0}, {100, 20});
  EXPECT_THAT(texts(with("<mapping type=\"mathml\"/>").report),
              Contains(HasSubstr("canvasTransform 't' has no supported mapping")));
  EXPECT_THAT(texts(with("<mapping type=\"affine\"><affine>1 0, 0 1</affine></mapping>").report),
              Contains(HasSubstr("does not have a matrix of two rows of three numbers")));
}

TEST(InkmlImport, PressureAndTimesMakeThePencilsWidths) {
  const std::string format =
      "<traceFormat><channel name=\"X\" units=\"mm\"/><channel name=\"Y\" units=\"mm\"/><channel "
      "name=\"T\" "
      "units=\"s\"/><channel name=\"F\" type=\"integer\" max=\"1000\"/></traceFormat>";
  std::string points;
  std::vector<InkSample> samples;
  for (int i = 0; i < 100; ++i) {
    points +=
        std::to_string(i) + " 0 " + std::to_string(0.01 * i) + " " + std::to_string(10 * i) + ",";
    samples.push_back({{1.0 * i, 0.0}, 0.01 * i, std::int64_t{10'000'000} * i});
  }
  InkFitter pencil{InkFitOptions{}};
  for (const InkSample& s : samples) pencil.push(s);
  pencil.end();
  pencil.refine();
  const Imported d = read(ink(format + "<trace>" + points + "</trace>"));
  const Stroke expected = pencil.stroke().value();
  EXPECT_EQ(only_stroke(d).data().points, expected.data().points);
  for (double u = 0.0; u < 1.0; u += 0.1) {
    EXPECT_NEAR(only_stroke(d).width_mm(u), expected.width_mm(u), 1e-6);
  }
}

// With a medium that is twice as wide on its side (tilt_width), a pen tilted by 65 degrees or more
// draws twice as wide, in whatever form the file has the tilt.
TEST(InkmlImport, TiltAndElevationAreThePensTilt) {
  const auto width = [](const std::string& channels, const std::string& values,
                        const std::string& more = {}) {
    ImportOptions options;
    options.fit.width_map.tilt_width = 2.0;
    std::string points;
    for (int i = 0; i < 40; ++i) points += std::to_string(i) + " 0 " + values + ",";
    const std::string format =
        "<inkSource><traceFormat><channel name=\"X\" units=\"mm\"/><channel name=\"Y\" "
        "units=\"mm\"/>" +
        channels + "</traceFormat>" + more + "</inkSource>";
    const auto drawing = import_inkml(
        ink("<context>" + format + "</context><trace>" + points + "</trace>"), options);
    return only_stroke(drawing.value()).width_mm(0.5);
  };
  const std::string tilts = "<channel name=\"OTx\"/><channel name=\"OTy\" units=\"deg\"/>";
  const double upright_mm = width(tilts, "0 0");
  EXPECT_NEAR(width(tilts, "70 0"), 2.0 * upright_mm, 1e-9);
  EXPECT_NEAR(width(tilts, "0 -70"), 2.0 * upright_mm, 1e-9);
  const double half_mm = width(tilts, "45 -45");
  EXPECT_GT(half_mm, 1.1 * upright_mm);
  EXPECT_LT(half_mm, 1.9 * upright_mm);
  EXPECT_NEAR(width("<channel name=\"OE\" units=\"deg\"/>", "20"), 2.0 * upright_mm, 1e-9);
  EXPECT_NEAR(width("<channel name=\"OE\" units=\"rad\"/>", "0.3"), 2.0 * upright_mm, 1e-9);
  EXPECT_NEAR(width("<channel name=\"OE\" units=\"deg\"/>", "90"), upright_mm, 1e-9);
  const std::string tenths =
      "<channelProperties><channelProperty channel=\"OTx\" name=\"resolution\" value=\"10\" "
      "units=\"1/deg\"/></channelProperties>";
  EXPECT_NEAR(width(tilts, "700 0", tenths), 2.0 * upright_mm, 1e-9);
  EXPECT_NEAR(width(tilts, "150 0", tenths), upright_mm, 1e-9);
  for (const char* none : {"? 70", "70 ?", "170 0"}) {
    EXPECT_NEAR(width(tilts, none), upright_mm, 1e-9) << none;
  }
  EXPECT_NEAR(width("<channel name=\"OTx\"/>", "70"), upright_mm, 1e-9) << "half of it is unknown";
  EXPECT_NEAR(width("<channel name=\"OE\"/>", "170"), upright_mm, 1e-9);
}

TEST(InkmlImport, ContinuedTracesAreOneStroke) {
  const Imported d = read(
      ink(kMm + "<trace xml:id=\"a\" continuation=\"begin\">0 0,30 0</trace><trace>0 9,9 9</trace>"
                "<trace xml:id=\"b\" continuation=\"middle\" priorRef=\"#a\">30 0,60 0</trace>"
                "<trace xml:id=\"c\" continuation=\"end\" priorRef=\"#b\">60 0,90 0</trace>"
                "<trace xml:id=\"d\" continuation=\"end\" priorRef=\"#d\">0 5,9 5</trace>"));
  const std::vector<Stroke> s = testing::strokes_in(d.drawing.document, 0);
  ASSERT_EQ(s.size(), 3u);
  expect_from_to(s[0], {0, 0}, {90, 0});
}

TEST(InkmlImport, PenUpEraserAndTipAreNoInk) {
  const Imported d =
      read(ink("<traceFormat><channel name=\"X\" units=\"mm\"/><channel name=\"Y\" units=\"mm\"/>"
               "<intermittentChannels><channel name=\"S\" type=\"boolean\"/><channel name=\"E\" "
               "type=\"boolean\"/>"
               "</intermittentChannels></traceFormat>\n"
               "<trace type=\"penUp\">0 0,9 0</trace>\n<trace>0 0,5 0TF,9 0FF</trace>\n<trace>0 "
               "0TT,5 0</trace>"));
  expect_from_to(only_stroke(d), {0, 0}, {5, 0});
  EXPECT_THAT(texts(d.report),
              ElementsAre("line 3: trace was made with the pen off the paper and was skipped",
                          "line 5: trace was made with the eraser end and was skipped"));
}

TEST(InkmlImport, ViewsAddNothingUnlessTheTraceWaitsInDefinitions) {
  const Imported d = read(ink(
      kMm +
      "<definitions><trace xml:id=\"hidden\">0 0,9 0</trace><trace xml:id=\"shown\">0 1,9 "
      "1</trace></definitions>"
      "<trace xml:id=\"t\">0 2,9 2</trace><traceGroup><annotation type=\"truth\">x</annotation>"
      "<traceView traceDataRef=\"#t\"/><traceView><traceView traceDataRef=\"#shown\"/></traceView>"
      "<traceView traceDataRef=\"#shown\"/></traceGroup>"));
  ASSERT_EQ(d.drawing.document.layers()[0].strokes.size(), 2u);
  EXPECT_THAT(texts(d.report), IsEmpty());
}

TEST(InkmlImport, ThePlainFormOfDataSets) {
  const Imported d = read(ink(
      "<annotation type=\"truth\">$x^2$</annotation><traceFormat><channel name=\"X\" "
      "type=\"decimal\"/>"
      "<channel name=\"Y\" type=\"decimal\"/><channel name=\"T\" type=\"decimal\"/></traceFormat>\n"
      "<trace id=\"0\">96 96 0.0,192 96 14.5,192 192 31</trace><trace id=\"1\">0 0 40</trace>"
      "<traceGroup xml:id=\"2\"><annotation type=\"truth\">Segmentation</annotation><traceGroup "
      "xml:id=\"3\"><traceView traceDataRef=\"0\"/></traceGroup></traceGroup>"));
  const std::vector<Stroke> s = testing::strokes_in(d.drawing.document, 0);
  ASSERT_EQ(s.size(), 2u);
  EXPECT_NEAR(distance(s[0].position(0), {25.4, 25.4}), 0.0, 0.15);
  EXPECT_EQ(d.report.notices().size(), 1u);
}

TEST(InkmlImport, WhatIsNotKnownIsNamed) {
  const Imported d = read(ink(kMm + "<wobble xml:id=\"w\"/>\n<x:y xmlns:x=\"z\"/>\n"
                                    "<trace contextRef=\"http://far/#x\">0 0,1 x,5 0</trace>\n"
                                    "<trace/>\n<trace>? ?</trace>"));
  EXPECT_THAT(
      texts(d.report),
      ElementsAre("line 2: wobble 'w' is unknown and was skipped",
                  "line 3: x:y belongs to another program and was skipped",
                  "line 4: trace refers to 'http://far/#x' in another document, which is not read",
                  "line 4: trace has 'x,5 0' instead of a value, in point 2; only the points "
                  "before it were read",
                  "line 5: trace has no points and was skipped (and 1 more like it)"));
}

TEST(InkmlImport, ChannelsAtTheirLimit) {
  const auto notes = [](std::size_t count) {
    std::string format =
        "<traceFormat><channel name=\"X\" units=\"mm\"/><channel name=\"Y\" units=\"mm\"/>";
    for (std::size_t i = 2; i < count; ++i) format += "<channel name=\"B\"/>";
    return texts(read(ink(format + "</traceFormat><trace>1 2</trace>")).report);
  };
  EXPECT_THAT(notes(63), IsEmpty());
  EXPECT_THAT(notes(64), IsEmpty());
  EXPECT_THAT(notes(65), Contains(HasSubstr("has more than 64 channels")));
}

TEST(InkmlImport, DeepGroupsAndManyTracesAreNoTrouble) {
  std::string deep, ends;
  for (int i = 0; i < 254; ++i) {
    deep += "<traceGroup>";
    ends += "</traceGroup>";
  }
  EXPECT_EQ(read(ink(kMm + deep + "<trace>0 0,1 1</trace>" + ends))
                .drawing.document.layers()[0]
                .strokes.size(),
            1u);
  std::string chain = kMm;
  for (int i = 0; i < 20000; ++i) {
    chain += "<trace xml:id=\"t" + std::to_string(i) + "\" priorRef=\"#t" +
             std::to_string((i + 19999) % 20000) + "\">" + std::to_string(i % 100) + " 0</trace>";
  }
  EXPECT_EQ(read(ink(chain)).drawing.document.layers()[0].strokes.size(), 1u);
}

TEST(InkmlImport, OtherFilesAreErrors) {
  EXPECT_THAT(import_inkml("<svg/>").error().message,
              HasSubstr("not InkML: the first element is 'svg'"));
  EXPECT_THAT(import_inkml("").error().message, HasSubstr("is not XML"));
}

TEST(InkmlImport, NamesDocumentsAfterTheFirst) {
  const std::string one = ink(kMm + "<trace>1 1, 9 9</trace>\n");
  EXPECT_TRUE(read(one).report.empty());
  EXPECT_TRUE(read(one + "<!-- end -->\n").report.empty());
  for (const int others : {1, 2}) {
    const Imported several = read(others == 1 ? one + one : one + one + one);
    EXPECT_EQ(several.drawing.document.stroke_count(), 1U);
    EXPECT_THAT(texts(several.report),
                Contains(HasSubstr("documents after it (" + std::to_string(others) + ")")));
  }
}

TEST(InkmlImport, NamesInvalidPressuresAndTimes) {
  const auto with_points = [](const std::string& points, const std::string& unit = "ms") {
    return texts(
        read(ink("<traceFormat><channel name=\"X\" type=\"decimal\" units=\"mm\"/><channel "
                 "name=\"Y\" type=\"decimal\" units=\"mm\"/><channel name=\"F\" "
                 "type=\"integer\" max=\"255\"/><channel name=\"T\" units=\"" +
                 unit + "\"/></traceFormat>\n<trace id=\"a\">" + points + "</trace>\n"))
            .report);
  };
  EXPECT_THAT(with_points("1 1 100 0, 2 1 120 8, 3 1 130 16, 4 1 90 24"), IsEmpty());
  EXPECT_THAT(with_points("1 1 100 0, 2 1 900 8, 3 1 1000 16, 4 1 90 24"),
              ElementsAre(HasSubstr("line 3: stroke 'a' (2 of 4 pressures, for example 3.9")));
  EXPECT_THAT(with_points("1 1 100 5, 2 1 120 5, 3 1 130 5, 4 1 90 5"),
              ElementsAre(HasSubstr("line 3: stroke 'a' has times that are not milliseconds")));
  EXPECT_THAT(with_points("1 1 100 1e12, 2 1 120 1e12, 3 1 130 1e12, 4 1 90 1e12", "s"),
              ElementsAre(HasSubstr("has times beyond 9e12 ms")));
}

TEST(InkmlImport, NamesTheLargestPressureThatItAssumes) {
  const auto with_channel = [](const std::string& channel) {
    return read(
        ink("<traceFormat><channel name=\"X\" type=\"decimal\" units=\"mm\"/><channel "
            "name=\"Y\" type=\"decimal\" units=\"mm\"/><channel name=\"F\" " +
            channel + "/></traceFormat><trace>1 1 100, 9 9 900</trace>\n"));
  };
  EXPECT_THAT(texts(with_channel("type=\"integer\"").report),
              Contains(HasSubstr("does not define its largest pressure")));
  EXPECT_TRUE(with_channel("type=\"integer\" max=\"1023\"").report.empty());
}

}  // namespace
}  // namespace felt::inkml_import_test
