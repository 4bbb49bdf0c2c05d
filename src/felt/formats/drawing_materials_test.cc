#include "felt/formats/drawing_materials.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "felt/formats/drawing_grain.h"
#include "felt/formats/drawing_reader.h"
#include "felt/formats/drawing_writer.h"
#include "felt/io/testing/test_drawings.h"
#include "felt/material/material_file.h"
#include "felt/material/relief.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::drawing_materials_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

SurfaceMaterial my_paper() {
  SurfaceMaterial surface = *find_surface("rough-paper");
  surface.id = "my-paper";
  surface.label = "Büttenpapier <1> & \"2\"";
  surface.grain_um = 12.0;
  return surface;
}

Medium my_pen(const std::string& id) {
  Medium medium = *find_medium("charcoal");
  medium.id = id;
  return medium;
}

/// Returns a drawing with one stroke of that medium on that surface.
Drawing drawing_of(const std::string& medium, const std::string& surface) {
  StrokeData data = testing::straight_stroke({10, 10}, {90, 40}, 2.0, 3.0).data();
  data.medium = medium;
  Drawing drawing = testing::drawing_of({Stroke::create(data).value()});
  drawing.has_page = true;
  drawing.page.surface = surface;
  return drawing;
}

TEST(DrawingMaterials, ADrawingBringsWhatItUses) {
  Materials known = Materials::built_in();
  known.put(my_paper());
  known.put(my_pen("my-pen"));
  known.put(my_pen("other-pen"));
  const std::string paper = write_material(my_paper()), pen = write_material(my_pen("my-pen"));
  const Drawing drawing = drawing_of("my-pen", "my-paper");
  EXPECT_THAT(texts_of_used(drawing.document, "my-paper", known), ElementsAre(paper, pen));
  EXPECT_THAT(texts_of_used(drawing.document, "glass", known), ElementsAre(pen));
  EXPECT_THAT(texts_of_used({}, "", known), IsEmpty());
  const std::vector<std::string> next = {"my-pen", "pencil"};
  EXPECT_THAT(texts_of_used({}, "", known, next), ElementsAre(pen));
  EXPECT_THAT(texts_of_used(drawing.document, "my-paper", Materials::built_in()), IsEmpty());

  const std::vector<std::string> texts = {paper, "nonsense", pen};
  const Materials back = with_texts(texts);
  ASSERT_NE(back.find_surface("my-paper"), nullptr);
  EXPECT_EQ(*back.find_surface("my-paper"), my_paper());
  EXPECT_NE(back.find_medium("my-pen"), nullptr);
  EXPECT_EQ(back.find_medium("other-pen"), nullptr);
}

TEST(DrawingMaterials, TravelInEveryFormatThatHasAPage) {
  Drawing drawing = drawing_of("my-pen", "my-paper");
  drawing.materials = {write_material(my_paper()), write_material(my_pen("my-pen"))};
  for (const FileFormat format : {FileFormat::kFelt, FileFormat::kSvg, FileFormat::kInkml}) {
    const std::string bytes = drawing_bytes(drawing, format).value();
    const Imported opened = parse_drawing(bytes, "-").value();
    EXPECT_TRUE(opened.report.empty());
    EXPECT_TRUE(opened.drawing == drawing) << static_cast<int>(format);
    EXPECT_EQ(drawing_bytes(opened.drawing, format).value(), bytes);
    // The drawing's own texts are sufficient.
    EXPECT_TRUE(grain_of(opened.drawing));
  }
}

TEST(DrawingMaterials, ABadOneIsNamedAndTheDrawingOpens) {
  Drawing drawing = drawing_of("my-pen", "my-paper");
  const std::string good = write_material(my_paper());
  drawing.materials = {"kind = \"medium\"\nid = \"my-pen\"\nloudness = ", good, "hello"};
  for (const FileFormat format : {FileFormat::kFelt, FileFormat::kSvg, FileFormat::kInkml}) {
    const std::string bytes = drawing_bytes(drawing, format).value();
    const Imported opened = parse_drawing(bytes, "-").value();
    EXPECT_THAT(opened.drawing.materials, ElementsAre(good));
    EXPECT_EQ(opened.drawing.document.stroke_count(), 1u);
    ASSERT_EQ(opened.report.notices().size(), 2u);
    EXPECT_THAT(notice_text(opened.report.notices()[0]), HasSubstr("material 1:"));
    EXPECT_THAT(notice_text(opened.report.notices()[1]), HasSubstr("material 3"));
  }
}

TEST(DrawingMaterials, TheGrainIsThatOfTheSurface) {
  EXPECT_FALSE(grain_of(drawing_of("pencil", "")).value().is_smooth());  // paper
  EXPECT_TRUE(grain_of(drawing_of("pencil", "glass")).value().is_smooth());
  Drawing drawing = drawing_of("pencil", "my-paper");
  EXPECT_THAT(grain_of(drawing).error().message, HasSubstr("'my-paper' is unknown"));
  drawing.materials = {write_material(my_paper())};
  EXPECT_FALSE(grain_of(drawing).value().is_smooth());
}

TEST(DrawingMaterials, WhatIsKnownHereCountsWhereTheDrawingSaysNothing) {
  Materials here = Materials::built_in();
  here.put(my_paper());
  here.put(my_pen("my-pen"));
  Drawing drawing = drawing_of("my-pen", "my-paper");
  EXPECT_EQ(grain_of(drawing, here).value(), Grain(surface_grain(my_paper()), here));

  SurfaceMaterial smooth = my_paper();
  smooth.grain_um = 0.0;
  Medium other = my_pen("my-pen");
  other.look.opacity_heavy = 0.25;
  drawing.materials = {write_material(smooth), write_material(other)};
  const Materials known = with_texts(drawing.materials, here);
  EXPECT_EQ(*known.find_medium("my-pen"), other);
  EXPECT_TRUE(grain_of(drawing, here).value().is_smooth());
}

// A picture of a part of the page, or of a drawing without a page size, names its surface.
TEST(DrawingMaterials, TheSurfaceIsNamedWithoutAPage) {
  Drawing drawing = drawing_of("pencil", "wood");
  const auto expect_surface = [&](FileFormat format, const WriteOptions& options) {
    const std::string bytes = drawing_bytes(drawing, format, options).value();
    const Imported opened = parse_drawing(bytes, "-").value();
    EXPECT_FALSE(opened.drawing.has_page);
    EXPECT_EQ(opened.drawing.page.surface, "wood");
  };
  expect_surface(FileFormat::kSvg, {.area = Rect{0, 0, 50, 40}});
  drawing.has_page = false;
  expect_surface(FileFormat::kSvg, {});
  expect_surface(FileFormat::kInkml, {});
}

}  // namespace
}  // namespace felt::drawing_materials_test
