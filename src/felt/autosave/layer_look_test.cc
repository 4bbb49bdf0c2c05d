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

TEST(AutosaveLook, APictureOfManyLayersIsWrittenOnce) {
  Document document = with_picture();
  Edit edit;
  for (std::uint64_t i = 2; i <= 4; ++i) {
    LayerState state{"Copy"};
    state.picture = testing::red_blue_picture(static_cast<double>(i), 4.0);
    edit.layers.push_back({{i}, std::nullopt, state, 0, i - 1});
  }
  const auto pictures_in = [](const std::string& bytes) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = bytes.find("\x89PNG", at)) != std::string::npos; ++at) ++count;
    return count;
  };
  std::string bytes;
  ASSERT_TRUE(append_edit_blob(bytes, edit));
  EXPECT_EQ(pictures_in(bytes), 1U);
  EXPECT_EQ(read_edit_blob(bytes, document).value(), edit);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(read_edit_blob(bytes.substr(0, size), document)) << size;
  }
  ASSERT_TRUE(document.apply(edit));
  Drawing drawing;
  drawing.document = document;
  bytes = base_head_bytes(drawing).value();
  EXPECT_EQ(pictures_in(bytes), 1U);
  EXPECT_TRUE(read_base_head(bytes).value().document == document);
}

/// Returns a document of a multiplying layer, which is in a group, and a normal one.
Document with_group() {
  Document document;
  const Layer& ink = document.layers()[0];
  LayerState state = ink.state();
  state.blend = BlendMode::kMultiply;
  state.group = std::make_shared<const LayerGroup>(
      LayerGroup{{3}, "Cat", false, true, 0.25, BlendMode::kMultiply});
  Edit edit;
  edit.layers.push_back({ink.id, ink.state(), state, 0, 0});
  edit.layers.push_back({{2}, std::nullopt, LayerState{"Top"}, 0, 1});
  EXPECT_TRUE(document.apply(edit));
  return document;
}

TEST(AutosaveLook, ABlendModeTakesNoBytesSoThatOlderProgramsReadTheEdit) {
  EXPECT_EQ(blend_of_flags(flags_of_blend(BlendMode::kMultiply)), BlendMode::kMultiply);
  EXPECT_EQ(blend_of_flags(0xff), BlendMode::kNormal) << "a mode of a newer program";
  const Document document;
  const LayerState before = document.layers()[0].state();
  LayerState after = before;
  after.blend = BlendMode::kMultiply;
  Edit edit;
  edit.layers.push_back({{1}, before, after, 0, 0});
  std::string bytes, plain;
  ASSERT_TRUE(append_edit_blob(bytes, edit));
  EXPECT_EQ(read_edit_blob(bytes, document).value(), edit);
  edit.layers[0].after->blend = BlendMode::kNormal;
  ASSERT_TRUE(append_edit_blob(plain, edit));
  ASSERT_EQ(bytes.size(), plain.size());
  int changed = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (bytes[i] == plain[i]) continue;
    ++changed;
    EXPECT_EQ((bytes[i] ^ plain[i]) & 0x0f, 0) << "the flags that older programs read";
  }
  EXPECT_EQ(changed, 1);
}

TEST(AutosaveLook, EditsAndBasesHoldGroups) {
  const Document document = with_group();
  Edit edit;  // changes the group of the lower layer
  const LayerState before = document.layers()[0].state();
  LayerState after = before;
  LayerGroup group = *before.group;
  group.opacity = 0.75;
  after.group = std::make_shared<const LayerGroup>(group);
  edit.layers.push_back({{1}, before, after, 0, 0});
  edit.layers.push_back({{2}, document.layers()[1].state(), std::nullopt, 1, 0});
  std::string bytes;
  ASSERT_TRUE(append_edit_blob(bytes, edit));
  EXPECT_EQ(read_edit_blob(bytes, document).value(), edit);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(read_edit_blob(bytes.substr(0, size), document)) << size;
  }
  Drawing drawing;
  drawing.document = document;
  const std::string head = base_head_bytes(drawing).value();
  EXPECT_TRUE(read_base_head(head).value().document == document);
  // A base without groups is one of an older program, which has no bytes after the page.
  std::string group_bytes;
  ByteWriter out(group_bytes);
  for (const Layer& layer : document.layers()) append_layer_group(out, layer.group);
  const Drawing old = read_base_head(head.substr(0, head.size() - group_bytes.size())).value();
  EXPECT_FALSE(old.document.layers()[0].group);
  EXPECT_EQ(old.document.layers()[0].blend, BlendMode::kMultiply);
}

TEST(AutosaveLook, ABaseThatListsALayerTwiceIsRefused) {
  Document document = with_group();
  Drawing drawing;
  drawing.document = document;
  std::string head = base_head_bytes(drawing).value();
  // The list begins after three ids and its count: id, name, flags of each layer.
  const std::size_t second = head.find("Top") - 12;
  ASSERT_EQ(head[second], 2);
  ASSERT_TRUE(read_base_head(head));
  head[second] = 1;
  const Result<Drawing> read = read_base_head(head);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message, "layer 1 is listed twice");
  head[second] = 2;
  head[second + 7] = '\x7f';
  EXPECT_EQ(read_base_head(head).error().message, "a layer has an invalid id");
}

TEST(AutosaveLook, AGroupWithAnImpossibleIdIsLeftOut) {
  const LayerGroupPtr group = with_group().layers()[0].group;
  std::string bytes;
  ByteWriter out(bytes);
  append_layer_group(out, group);
  ByteReader whole(bytes);
  EXPECT_EQ(*read_layer_group(whole), *group);
  bytes[7] = '\x7f';
  ByteReader impossible(bytes);
  EXPECT_FALSE(read_layer_group(impossible));
  EXPECT_EQ(impossible.left(), 0U) << "what follows can be read";
}

TEST(AutosaveLook, ALongNameIsCutBetweenTwoCodePoints) {
  Document document = with_group();
  LayerGroup group = *document.layers()[0].group;
  group.name = std::string(kMaxLayerNameBytes - 1, 'n') + "\u00fc";
  std::string bytes;
  ByteWriter out(bytes);
  append_layer_group(out, std::make_shared<const LayerGroup>(group));
  ByteReader in(bytes);
  EXPECT_EQ(read_layer_group(in)->name, std::string(kMaxLayerNameBytes - 1, 'n'));
}

}  // namespace
}  // namespace felt::layer_look_test
