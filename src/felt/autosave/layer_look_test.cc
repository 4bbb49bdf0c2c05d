#include "felt/autosave/layer_look.h"

#include <gtest/gtest.h>

#include "felt/autosave/autosave_rows.h"
#include "felt/autosave/edit_blob.h"
#include "felt/document/testing/small_picture.h"

namespace felt::layer_look_test {
namespace {

Document with_picture() {
  Document document;
  const Layer& ink = document.layers()[0];
  LayerState state = ink.state();
  state.opacity = 0.4;
  state.picture = testing::red_blue_picture(3.0, 4.0);
  Edit edit;
  edit.layers.push_back({ink.id, ink.state(), state, 0, 0});
  EXPECT_TRUE(document.apply(edit));
  return document;
}

TEST(AutosaveLook, AnEditThatMovesAPictureDoesNotRepeatItsBytes) {
  Document document = with_picture();
  const LayerState before = document.layers()[0].state();
  LayerState after = before;
  after.picture = placed(*before.picture, {1, 0, 0, 1, 50, 60});
  Edit move;
  move.layers.push_back({{1}, before, after, 0, 0});
  std::string bytes;
  ASSERT_TRUE(append_edit_blob(bytes, move));
  EXPECT_EQ(bytes.find("PNG"), std::string::npos);
  const Edit read = read_edit_blob(bytes, document).value();
  EXPECT_EQ(read, move);
  EXPECT_EQ(read.layers[0].after->picture->data, before.picture->data) << "shared";
  // Without the layer, the picture cannot be restored, but the other parts of the edit can.
  Document other;
  const Edit lost = read_edit_blob(bytes, other).value();
  EXPECT_FALSE(lost.layers[0].after->picture);
  EXPECT_EQ(lost.layers[0].after->opacity, 0.4);
}

TEST(AutosaveLook, ABaseHoldsTheLooksOfItsLayers) {
  Drawing drawing;
  drawing.document = with_picture();
  const Drawing back = read_base_head(base_head_bytes(drawing).value()).value();
  EXPECT_TRUE(back.document == drawing.document);
}

}  // namespace
}  // namespace felt::layer_look_test
