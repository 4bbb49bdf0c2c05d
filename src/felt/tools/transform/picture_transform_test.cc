// The transform tool on the picture of a layer.
#include <gtest/gtest.h>

#include "felt/document/testing/small_picture.h"
#include "felt/tools/testing/tool_fixture.h"
#include "felt/tools/transform/transform_tool.h"

namespace felt::picture_transform_test {
namespace {

using testing::Fixture;
using testing::Pen;
using testing::straight_stroke;
using testing::way;

/// The current layer has a picture with the box (10, 10) to (30, 20); its frame is 3 mm larger.
struct PictureFixture {
  PictureFixture() {
    const Layer& layer = fixture.document.layers()[0];
    LayerState state = layer.state();
    state.picture = testing::red_blue_picture(10.0, 10.0);
    Edit edit;
    edit.layers.push_back({layer.id, layer.state(), state, 0, 0});
    EXPECT_TRUE(fixture.document.apply(edit));
  }
  void drag(Point from, Point to) { pen.line(way(from, to)); }
  [[nodiscard]] const Affine& place() const { return fixture.document.layers()[0].picture->place; }

  Fixture fixture;
  TransformTool tool;
  Pen pen{tool, fixture};
};

TEST(PictureTransform, MovesFromInsideAsOneEdit) {
  PictureFixture f;
  f.drag({15, 15}, {25, 12});
  EXPECT_EQ(f.pen.commits, 1);
  EXPECT_EQ(f.place(), (Affine{10, 0, 0, 10, 20, 7}));
}

TEST(PictureTransform, ShowsThePictureWhereItGoes) {
  PictureFixture f;
  f.pen.up({15, 15});
  f.pen.down({15, 15});
  f.pen.down({18, 15});
  const ToolResult result = f.pen.at({20, 15, -1.0});
  ASSERT_TRUE(result.preview);
  ASSERT_EQ(result.preview->layers.size(), 1U);
  EXPECT_EQ(result.preview->layers[0].after->picture->place, (Affine{10, 0, 0, 10, 15, 10}));
  EXPECT_EQ(f.place(), (Affine{10, 0, 0, 10, 10, 10})) << "not committed yet";
}

TEST(PictureTransform, ScalesAtACornerAboutTheOppositeOne) {
  PictureFixture f;
  f.drag({33, 23}, {56, 36});  // twice as far from (10, 10)
  EXPECT_EQ(f.pen.commits, 1);
  EXPECT_NEAR(f.place().a, 20.0, 1e-9);
  EXPECT_NEAR(f.place().d, 20.0, 1e-9);
  EXPECT_NEAR(f.place().e, 10.0, 1e-9);
  EXPECT_NEAR(f.place().f, 10.0, 1e-9);
}

TEST(PictureTransform, ScalesAboutItsCentreIfAsked) {
  PictureFixture f;
  ASSERT_TRUE(f.tool.set_option("about_centre", true));
  f.drag({33, 23}, {46, 31});  // twice as far from the centre (20, 15)
  EXPECT_EQ(f.pen.commits, 1);
  EXPECT_NEAR(f.place().a, 20.0, 1e-9);
  EXPECT_NEAR(f.place().d, 20.0, 1e-9);
  EXPECT_NEAR(f.place().e, 0.0, 1e-9);
  EXPECT_NEAR(f.place().f, 5.0, 1e-9);
}

TEST(PictureTransform, TurnsAboutItsCentre) {
  PictureFixture f;
  ASSERT_TRUE(f.tool.set_option("mode", std::string("rotate")));
  f.drag({30, 15}, {20, 25});
  EXPECT_EQ(f.pen.commits, 1);
  EXPECT_NEAR(f.place().a, 0.0, 1e-9);
  EXPECT_NEAR(f.place().b, 10.0, 1e-9);
}

TEST(PictureTransform, AStrokeHasPriority) {
  PictureFixture f;
  const StrokeId line = f.fixture.add(straight_stroke({12, 15}, {28, 15}, 1.0, 1.0));
  f.drag({20, 15}, {20, 18});
  EXPECT_EQ(f.place(), (Affine{10, 0, 0, 10, 10, 10}));
  EXPECT_NEAR(f.fixture.document.find(line)->position(0.0).y, 18.0, 1e-9);
}

TEST(PictureTransform, OutsideItsFrameNothingMoves) {
  PictureFixture f;
  f.drag({80, 80}, {90, 80});
  EXPECT_EQ(f.pen.commits, 0);
}

}  // namespace
}  // namespace felt::picture_transform_test
