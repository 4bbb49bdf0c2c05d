#include "felt/autosave/autosave_database.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <random>

#include "felt/autosave/recovery.h"
#include "felt/document/edit_builder.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::autosave_database_test {
namespace {

std::string folder_for_test() {
  std::string name = ::testing::TempDir() + "felt-store-XXXXXX";
  return ::mkdtemp(name.data());
}

TEST(AutosaveDatabase, Begins) {
  const std::string root = folder_for_test();
  Result<AutosaveDatabase> store = AutosaveDatabase::create(root, "a");
  ASSERT_TRUE(store) << store.error().message;
  Drawing drawing;
  ASSERT_TRUE(store->write_base(drawing));
  EditBuilder edit(drawing.document);
  edit.add(drawing.document.layers().front().id,
           std::make_shared<const Stroke>(testing::random_stroke(1)));
  ASSERT_TRUE(store->add_edit(std::move(edit).build("Draw")));
  ASSERT_TRUE(store->put_info({"x", "/y", true, {}}));
  ASSERT_TRUE(store->add_live(LiveKind::kEvents, "abc"));
  const Result<void> done = store->commit();
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(std::filesystem::exists(root + "/a/store.db-wal"));
  ASSERT_TRUE(std::move(*store).remove());
  EXPECT_FALSE(std::filesystem::exists(root + "/a"));
}

/// Overwrites 512 bytes of a file with noise.
void damage(const std::string& path, std::mt19937& random) {
  const auto size = static_cast<long>(std::filesystem::file_size(path));
  std::FILE* file = std::fopen(path.c_str(), "r+b");
  ASSERT_TRUE(file);
  std::fseek(file, static_cast<long>(random() % static_cast<unsigned long>(size)), SEEK_SET);
  for (int i = 0; i < 512; ++i) std::fputc(static_cast<int>(random() & 0xff), file);
  std::fclose(file);
}

/// Recovery from a damaged database returns the intact data, no data that never existed, and
/// reports the damage.
TEST(AutosaveDatabase, DamageCostsWhatWasDamaged) {
  constexpr int kBase = 9000, kEdits = 60, kRounds = 40;
  const std::string root = folder_for_test();
  Drawing drawing;
  {
    EditBuilder all(drawing.document);
    for (std::uint64_t i = 0; i < kBase; ++i) {
      all.add(drawing.document.layers().front().id,
              std::make_shared<const Stroke>(testing::random_stroke(i % 500)));
    }
    ASSERT_TRUE(drawing.document.apply(std::move(all).build("Import")));
    Result<AutosaveDatabase> store = AutosaveDatabase::create(root, "a");
    ASSERT_TRUE(store && store->write_base(drawing) && store->commit());
    for (std::uint64_t i = 0; i < kEdits; ++i) {
      EditBuilder edit(drawing.document);
      edit.add(drawing.document.layers().front().id,
               std::make_shared<const Stroke>(testing::random_stroke(i)));
      const Edit done = std::move(edit).build("Draw");
      ASSERT_TRUE(drawing.document.apply(done) && store->add_edit(done) && store->commit());
    }
  }
  ASSERT_TRUE(recover_autosave(root + "/a").value().drawing.document == drawing.document);
  int good = 0;
  for (unsigned seed = 1; seed <= kRounds; ++seed) {
    std::mt19937 random(seed);
    const std::string copy = root + "/copy";
    std::filesystem::remove_all(copy);
    std::filesystem::copy(root + "/a", copy);
    damage(copy + (seed % 4 == 0 ? "/store.db-wal" : "/store.db"), random);
    const Result<Recovered> recovered = recover_autosave(copy);
    if (!recovered) {
      std::printf("seed %u: %s\n", seed, recovered.error().message.c_str());
      continue;
    }
    const Document& document = recovered->drawing.document;
    if (document.stroke_count() > (kBase + kEdits) * 4 / 5) ++good;
    for (const Layer& layer : document.layers()) {
      for (const StrokeId id : layer.strokes) {
        const StrokePtr original = drawing.document.find(id);
        ASSERT_TRUE(original && *original == *document.find(id)) << "seed " << seed;
      }
    }
    // A truncated WAL looks like a WAL that was never longer.
    if (seed % 4 != 0 && document.stroke_count() < kBase) {
      EXPECT_FALSE(recovered->problems.empty()) << "seed " << seed;
    }
  }
  EXPECT_GT(good, kRounds * 7 / 10);
  std::filesystem::remove_all(root);
}

}  // namespace
}  // namespace felt::autosave_database_test
