#include "felt/document/body_edit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "felt/base/constants.h"
#include "felt/document/history.h"
#include "felt/document/testing/random_guides.h"

namespace felt::body_edit_test {
namespace {

using ::testing::HasSubstr;

std::string error_of(const BodyEdit& edit) {
  const Result<void> fine = check_body_edit(edit);
  return fine ? "" : fine.error().message;
}

BodyEdit valid_cut() {
  return {.kind = BodyEditKind::kCut, .path_mm = {{1, -2, 0}, {3, -4, 0}}};
}

TEST(BodyEdit, EveryNumberHasItsLimits) {
  testing::RandomStroke random(1);
  for (int i = 0; i < 200; ++i) EXPECT_EQ(error_of(testing::random_body_edit(random)), "");
  for (const double wrong : {-1e7, 1e300, kNan}) {
    for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      BodyEdit edit = valid_cut();
      edit.path_mm[1].*axis = wrong;
      EXPECT_THAT(error_of(edit), HasSubstr("path: "));
      edit = valid_cut();
      edit.view.*axis = wrong;
      EXPECT_THAT(error_of(edit), HasSubstr("view: "));
    }
    BodyEdit edit = valid_cut();
    edit.width_mm = wrong;
    EXPECT_THAT(error_of(edit), HasSubstr("width_mm: "));
    edit = valid_cut();
    edit.amount = wrong;
    EXPECT_THAT(error_of(edit), HasSubstr("amount: "));
  }
}

TEST(BodyEdit, EachKindHasThePathsThatItNeeds) {
  BodyEdit edit = valid_cut();
  edit.path_mm.resize(1);
  EXPECT_THAT(error_of(edit), HasSubstr("path: "));
  edit.kind = BodyEditKind::kPaint;
  EXPECT_EQ(error_of(edit), "") << "a dot";
  edit.path_mm.clear();
  EXPECT_THAT(error_of(edit), HasSubstr("path: "));
  edit = valid_cut();
  edit.kind = BodyEditKind::kExtrude;
  EXPECT_THAT(error_of(edit), HasSubstr("profile: "));
  edit.profile_mm = {{0, 0, 0}, {0, 0, 9}};
  EXPECT_EQ(error_of(edit), "");
  edit.kind = BodyEditKind::kSmooth;
  EXPECT_THAT(error_of(edit), HasSubstr("profile: "));
  edit = valid_cut();
  edit.path_mm.resize(BodyEdit::kMaxPoints + 1);
  EXPECT_THAT(error_of(edit), HasSubstr("20000"));
  edit.kind = static_cast<BodyEditKind>(4);
  EXPECT_THAT(error_of(edit), HasSubstr("kind: "));
}

TEST(BodyEdit, AKindHasItsName) {
  for (const std::string_view name : kBodyEditKindNames) {
    EXPECT_EQ(body_edit_kind_name(*body_edit_kind_of(name)), name);
  }
  EXPECT_FALSE(body_edit_kind_of("bend"));
}

TEST(BodyEdit, ADocumentKeepsThemInTheOrderOfTheirIdsAndUndoRestoresThem) {
  Document document;
  History history;
  for (int i = 0; i < 3; ++i) {
    Edit edit{"Edit the body", {}};
    BodyEdit body_edit = valid_cut();
    body_edit.width_mm = i;
    edit.body_edits.push_back(
        {document.new_body_edit_id(), nullptr, std::make_shared<const BodyEdit>(body_edit)});
    ASSERT_TRUE(document.apply(edit));
    EXPECT_FALSE(history.extend(edit));
    history.record(edit);
  }
  EXPECT_GT(history.memory_bytes(), 3 * sizeof(BodyEdit));
  double width_mm = 0.0;
  for (const auto& [id, edit] : document.body_edits()) EXPECT_EQ(edit->width_mm, width_mm++);
  const Document whole = document;
  const BodyEditId first = document.body_edits().begin()->first;
  Edit removal{"Remove", {}};
  removal.body_edits.push_back({first, document.find_body_edit(first), nullptr});
  ASSERT_TRUE(document.apply(removal));
  EXPECT_FALSE(document.find_body_edit(first));
  EXPECT_FALSE(document == whole);
  EXPECT_FALSE(document.apply(removal)) << "it does not exist anymore";
  ASSERT_TRUE(document.apply(removal.inverse()));
  EXPECT_TRUE(document == whole);
  while (history.can_undo()) ASSERT_TRUE(history.undo(document));
  EXPECT_TRUE(document == Document());
  EXPECT_GT(document.new_body_edit_id(), first) << "ids are not reused";
}

TEST(BodyEdit, ADocumentHasALimit) {
  Document document;
  Edit edit{"Open", {}};
  for (std::uint64_t i = 0; i < kMaxBodyEdits; ++i) {
    edit.body_edits.push_back({{i + 1}, nullptr, std::make_shared<const BodyEdit>(valid_cut())});
  }
  ASSERT_TRUE(document.apply(edit));
  Edit more{"Edit the body", {}};
  more.body_edits.push_back(
      {document.new_body_edit_id(), nullptr, std::make_shared<const BodyEdit>(valid_cut())});
  const Result<void> done = document.apply(more);
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().message, HasSubstr("at most 1000"));
}

}  // namespace
}  // namespace felt::body_edit_test
