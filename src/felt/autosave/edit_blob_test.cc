#include "felt/autosave/edit_blob.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "felt/autosave/autosave_rows.h"
#include "felt/document/drawing_guide.h"
#include "felt/document/symmetry_group.h"
#include "felt/document/testing/random_document.h"

namespace felt::edit_blob_test {
namespace {

TEST(EditBlob, ARowOfEditsGivesTheSameDocument) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    felt::testing::RandomEdits edits(seed);
    Document document, copy;
    for (int i = 0; i < 60; ++i) {
      Edit edit = edits.next(document);
      ASSERT_TRUE(document.apply(edit));
      if (i % 7 == 3) {  // undo is an edit, too
        edit = edit.inverse();
        ASSERT_TRUE(document.apply(edit));
        Edit back = edit.inverse();
        ASSERT_TRUE(copy.apply(back));
      }
      std::string bytes;
      ASSERT_TRUE(append_edit_blob(bytes, edit));
      const Result<Edit> read = read_edit_blob(bytes, copy);
      ASSERT_TRUE(read) << "seed " << seed << ": " << read.error().message;
      EXPECT_EQ(read->label, edit.label);
      ASSERT_TRUE(copy.apply(*read)) << "seed " << seed;
      ASSERT_TRUE(copy == document) << "seed " << seed << ", edit " << i;
    }
  }
}

/// Returns an edit that adds a layer in a group, a guide and a symmetry group.
Edit everything_at_once(const Document& document) {
  const auto group = std::make_shared<const LayerGroup>(LayerGroup{{1}, "Trees"});
  LayerState state{"Leaves"};
  state.group = group;
  Edit edit{"Import", {}};
  edit.layers.push_back({document.new_layer_id(), std::nullopt, state, 0, 1});
  edit.guides.push_back({document.new_guide_id(), nullptr, std::make_shared<const DrawingGuide>()});
  edit.symmetries.push_back({document.new_symmetry_id(1), nullptr,
                             std::make_shared<const SymmetryGroup>(
                                 SymmetryGroup{{10, 20}, 0.5, 1, {{{7}, 0}, {{8}, 1}}})});
  edit.toggles_guides = true;
  return edit;
}

TEST(EditBlob, GroupsOfLayersAndGuidesFitIntoOneEdit) {
  Document document, copy;
  const Edit edit = everything_at_once(document);
  ASSERT_TRUE(document.apply(edit));
  std::string bytes;
  ASSERT_TRUE(append_edit_blob(bytes, edit));
  const Result<Edit> read = read_edit_blob(bytes, copy);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_TRUE(copy.apply(*read));
  EXPECT_TRUE(copy == document);
  EXPECT_TRUE(equal_groups(copy.layers().back().group, edit.layers.front().after->group));
  EXPECT_EQ(copy.guides().size(), 1u);
  EXPECT_EQ(copy.symmetries().size(), 1u);
  EXPECT_FALSE(copy.shows_guides());
}

// Programs from before guides must still read the edits that have none.
TEST(EditBlob, OnlyEditsWithGuidesHaveTheVersionOfGuides) {
  const Document document;
  Edit edit = everything_at_once(document);
  std::string with, without;
  ASSERT_TRUE(append_edit_blob(with, edit));
  edit.guides.clear();
  edit.symmetries.clear();
  edit.toggles_guides = false;
  ASSERT_TRUE(append_edit_blob(without, edit));
  EXPECT_EQ(with[0], 4);
  EXPECT_EQ(without[0], 3);
}

/// Returns an edit that adds a layer with a timing and an edit of the body.
Edit timing_and_body(const Document& document) {
  LayerState state{"Key"};
  state.timing = shared_timing({.between = 3, .pairs = {{{7}, {8}}, {{9}, {}}}});
  Edit edit{"Import", {}};
  edit.layers.push_back({document.new_layer_id(), std::nullopt, state, 0, 1});
  edit.body_edits.push_back(
      {document.new_body_edit_id(), nullptr,
       std::make_shared<const BodyEdit>(BodyEdit{.path_mm = {{1, -2, 0}, {3, -4, 0}}})});
  return edit;
}

// Programs from before timings must still read the edits that have none.
TEST(EditBlob, OnlyEditsWithTimingsOrEditsOfTheBodyHaveTheirVersion) {
  const Document document;
  Edit edit = timing_and_body(document);
  std::string both, timing, none;
  ASSERT_TRUE(append_edit_blob(both, edit));
  const Edit read = read_edit_blob(both, document).value();
  EXPECT_EQ(read.layers, edit.layers);
  ASSERT_EQ(read.body_edits.size(), 1u);
  EXPECT_EQ(*read.body_edits[0].after, *edit.body_edits[0].after);
  edit.body_edits.clear();
  ASSERT_TRUE(append_edit_blob(timing, edit));
  EXPECT_EQ(read_edit_blob(timing, document).value(), edit);
  edit.layers[0].after->timing = nullptr;
  ASSERT_TRUE(append_edit_blob(none, edit));
  EXPECT_EQ(both[0], 5);
  EXPECT_EQ(timing[0], 5);
  EXPECT_EQ(none[0], 1);
}

TEST(EditBlob, ABaseHasTimingsAndEditsOfTheBodyAfterTheGuides) {
  for (const bool with_guides : {false, true}) {
    Drawing drawing;
    if (with_guides) {
      ASSERT_TRUE(drawing.document.apply(everything_at_once(drawing.document)));
    }
    ASSERT_TRUE(drawing.document.apply(timing_and_body(drawing.document)));
    const Result<std::string> head = base_head_bytes(drawing);
    ASSERT_TRUE(head);
    const Result<Drawing> read = read_base_head(*head);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_TRUE(read->document == drawing.document);
    EXPECT_EQ(read->document.body_edits().size(), 1u);
  }
}

TEST(EditBlob, OfADamagedDatabaseEditsOfTheBodyAreKept) {
  const Edit edit = timing_and_body({});
  std::string bytes;
  ASSERT_TRUE(append_edit_blob(bytes, edit));
  Document other;
  ASSERT_TRUE(apply_what_fits(bytes, other));
  EXPECT_EQ(other.body_edits().size(), 1u);
  EXPECT_TRUE(other.layers().back().timing);
}

TEST(EditBlob, ABaseHasTheGuidesAfterTheGroups) {
  Drawing drawing;
  ASSERT_TRUE(drawing.document.apply(everything_at_once(drawing.document)));
  const Result<std::string> head = base_head_bytes(drawing);
  ASSERT_TRUE(head);
  const Result<Drawing> read = read_base_head(*head);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_TRUE(read->document == drawing.document);
  EXPECT_TRUE(read->document.layers().back().group);
  EXPECT_EQ(read->document.guides().size(), 1u);
  EXPECT_FALSE(read->document.shows_guides());
}

TEST(EditBlob, DamageIsAnErrorOrAnEdit) {
  std::mt19937 random(3);
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    felt::testing::RandomEdits edits(seed);
    Document document;
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(document.apply(edits.next(document)));
    std::string bytes;
    ASSERT_TRUE(append_edit_blob(bytes, edits.next(document)));
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      EXPECT_FALSE(read_edit_blob(std::string_view(bytes).substr(0, size), document)) << size;
    }
    for (int k = 0; k < 500; ++k) {
      std::string changed = bytes;
      changed[random() % changed.size()] = static_cast<char>(random());
      const Result<Edit> edit = read_edit_blob(changed, document);
      Document copy = document;
      EXPECT_TRUE(!edit || !copy.apply(*edit) || felt::testing::is_consistent(copy));
    }
  }
}

}  // namespace
}  // namespace felt::edit_blob_test
