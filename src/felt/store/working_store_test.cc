#include "felt/store/working_store.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "felt/document/edit_builder.h"
#include "felt/stroke/random_stroke.h"

namespace felt {
namespace {

std::string folder_for_test() {
  std::string name = ::testing::TempDir() + "felt-store-XXXXXX";
  return ::mkdtemp(name.data());
}

TEST(WorkingStore, Begins) {
  const std::string root = folder_for_test();
  Result<WorkingStore> store = WorkingStore::create(root, "a");
  ASSERT_TRUE(store) << store.error().message;
  StoredDrawing drawing;
  ASSERT_TRUE(store->write_base(drawing));
  EditBuilder edit(drawing.document);
  edit.add(drawing.document.layers().front().id,
           std::make_shared<const Stroke>(testing::random_stroke(1)));
  ASSERT_TRUE(store->add_edit(std::move(edit).build("Draw")));
  ASSERT_TRUE(store->put_about({"x", "/y", true, {}}));
  ASSERT_TRUE(store->add_live(LiveKind::kEvents, "abc"));
  const Result<void> done = store->commit();
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(std::filesystem::exists(root + "/a/store.db-wal"));
  ASSERT_TRUE(std::move(*store).remove());
  EXPECT_FALSE(std::filesystem::exists(root + "/a"));
}

}  // namespace
}  // namespace felt
