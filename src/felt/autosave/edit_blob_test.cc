#include "felt/autosave/edit_blob.h"

#include <gtest/gtest.h>

#include <random>

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
