#include "felt/store/guide_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "felt/base/constants.h"
#include "felt/document/testing/random_guides.h"
#include "felt/store/felt_file.h"
#include "felt/store/felt_salvage.h"
#include "felt/store/felt_tables.h"

namespace felt::guide_table_test {
namespace {

Drawing with_guides(int count, std::uint64_t seed = 5) {
  Drawing drawing;
  testing::RandomStroke random(seed);
  Edit edit;
  for (int i = 0; i < count; ++i) {
    edit.guides.push_back({drawing.document.new_guide_id(2 * static_cast<std::uint64_t>(i)),
                           nullptr,
                           std::make_shared<const DrawingGuide>(testing::random_guide(random))});
    edit.symmetries.push_back(
        {drawing.document.new_symmetry_id(2 * static_cast<std::uint64_t>(i) + 1), nullptr,
         std::make_shared<const SymmetryGroup>(testing::random_symmetry(random))});
  }
  edit.toggles_guides = count % 2 == 1;
  EXPECT_TRUE(drawing.document.apply(edit));
  return drawing;
}

TEST(GuideBlob, EveryGuideAndGroupReadsBackAndWhatIsCutOffIsNone) {
  testing::RandomStroke random(3);
  for (int i = 0; i < 300; ++i) {
    const DrawingGuide guide = testing::random_guide(random);
    const SymmetryGroup group = testing::random_symmetry(random);
    std::string bytes, strokes;
    ASSERT_TRUE(append_guide_blob(bytes, guide));
    ASSERT_TRUE(append_symmetry_blob(strokes, group));
    const Result<DrawingGuidePtr> back = read_guide_blob(bytes);
    const Result<SymmetryPtr> group_back = read_symmetry_blob(strokes);
    ASSERT_TRUE(back) << back.error().message;
    ASSERT_TRUE(group_back) << group_back.error().message;
    ASSERT_EQ(**back, guide);
    ASSERT_EQ(**group_back, group);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      ASSERT_FALSE(read_guide_blob(std::string_view(bytes).substr(0, size))) << size;
    }
    for (std::size_t size = 0; size < strokes.size(); ++size) {
      ASSERT_FALSE(read_symmetry_blob(std::string_view(strokes).substr(0, size))) << size;
    }
    EXPECT_FALSE(read_guide_blob(bytes + '\0'));
  }
}

TEST(GuideBlob, InvalidValuesAreNotWrittenAndNotRead) {
  testing::RandomStroke random(9);
  for (int i = 0; i < 2000; ++i) {
    std::string bytes;
    ASSERT_TRUE(append_guide_blob(bytes, testing::random_guide(random)));
    bytes[static_cast<std::size_t>(random.pick(0, static_cast<int>(bytes.size()) - 1))] =
        static_cast<char>(random.pick(0, 255));
    const Result<DrawingGuidePtr> read = read_guide_blob(bytes);
    EXPECT_TRUE(!read || check_drawing_guide(**read));
  }
  DrawingGuide guide;
  guide.size_mm = kNan;
  std::string bytes;
  EXPECT_FALSE(append_guide_blob(bytes, guide));
  EXPECT_FALSE(append_symmetry_blob(bytes, SymmetryGroup{}));
  EXPECT_EQ(bytes, "");
}

TEST(GuideTable, ADrawingWithoutGuidesHasNoSuchTables) {
  const std::string none = *felt_bytes(with_guides(0)), some = *felt_bytes(with_guides(3));
  for (const char* table : {"CREATE TABLE guide", "CREATE TABLE symmetry"}) {
    EXPECT_EQ(none.find(table), std::string::npos) << table;
    EXPECT_NE(some.find(table), std::string::npos) << table;
  }
}

TEST(GuideTable, AFileKeepsGuidesLinksAndWhetherTheyAreShown) {
  for (const int count : {1, 2, 19}) {
    const Drawing drawing = with_guides(count);
    const std::string bytes = *felt_bytes(drawing);
    const Result<Drawing> back = parse_felt(bytes);
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(*back, drawing);
    EXPECT_EQ(back->document.shows_guides(), count % 2 == 0);
    EXPECT_EQ(*felt_bytes(*back), bytes);
  }
}

/// Returns a file with more guides than a drawing can have.
std::string with_too_many_guides(std::size_t count) {
  Result<Database> database = Database::create();
  EXPECT_TRUE(database);
  const std::string setup = "PRAGMA application_id=" + std::to_string(kFeltApplicationId) +
                            "; PRAGMA user_version=" + std::to_string(kFeltVersion);
  EXPECT_TRUE(database->run(setup.c_str()));
  Drawing drawing = with_guides(1);
  drawing.document.reserve_ids({2000}, {});
  EXPECT_TRUE(write_tables(*database, drawing, nullptr));
  const Result<Statement> row = database->prepare("INSERT INTO guide VALUES(?,1,?,?)");
  EXPECT_TRUE(row);
  for (std::size_t i = 1; i < count; ++i) {
    std::string bytes;
    EXPECT_TRUE(append_guide_blob(bytes, DrawingGuide{}));
    const auto id = static_cast<std::int64_t>(1000 + i);
    row->bind(1, id);
    row->bind_blob(2, bytes);
    row->bind(3, guide_checksum(id, 1, bytes));
    EXPECT_TRUE(row->step());
    row->reset();
  }
  return *database->bytes();
}

TEST(GuideTable, OfTooManyGuidesTheFirstOnesAreReadAndANoticeSaysSo) {
  std::vector<std::string> notices;
  std::string bytes = with_too_many_guides(300);
  const Result<Drawing> read = parse_felt(bytes, &notices);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->document.guides().size(), kMaxDrawingGuides);
  EXPECT_EQ(notices,
            std::vector<std::string>{"Skipped 44 of 300 guides: a drawing has at most 256."});
  bytes[100 + 8] ^= 0x55;  // in the schema
  const Result<Salvaged> salvaged = salvage_felt_bytes(bytes);
  ASSERT_TRUE(salvaged) << salvaged.error().message;
  EXPECT_EQ(salvaged->drawing.document.guides().size(), kMaxDrawingGuides);
  EXPECT_EQ(std::count(salvaged->problems.begin(), salvaged->problems.end(), notices.front()), 1);
  notices.clear();
  ASSERT_TRUE(parse_felt(with_too_many_guides(256), &notices));
  EXPECT_TRUE(notices.empty());
}

TEST(GuideTable, SalvageFindsGuidesAndLinks) {
  const Drawing drawing = with_guides(8);
  std::string bytes = *felt_bytes(drawing);
  bytes[100 + 8] ^= 0x55;  // in the schema
  ASSERT_FALSE(parse_felt(bytes));
  const Result<Salvaged> salvaged = salvage_felt_bytes(bytes);
  ASSERT_TRUE(salvaged) << salvaged.error().message;
  EXPECT_EQ(salvaged->drawing.document.guides().size(), 8U);
  EXPECT_EQ(salvaged->drawing.document.symmetries().size(), 8U);
}

}  // namespace
}  // namespace felt::guide_table_test
