#include "felt/store/key_timing_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "felt/document/testing/random_guides.h"
#include "felt/store/body_edit_table.h"
#include "felt/store/felt_file.h"
#include "felt/store/felt_salvage.h"
#include "felt/store/felt_tables.h"

namespace felt::key_timing_table_test {
namespace {

using ::testing::HasSubstr;

/// Returns a drawing of several layers with timings, and edits of its body.
Drawing with_timings(int count, std::uint64_t seed = 5) {
  Drawing drawing;
  testing::RandomStroke random(seed);
  Edit edit;
  for (int i = 0; i < count; ++i) {
    LayerState state{"Key"};
    if (i % 3 < 2) state.timing = shared_timing(testing::random_timing(random));
    edit.layers.push_back({drawing.document.new_layer_id(static_cast<std::uint64_t>(i)),
                           std::nullopt, std::move(state), 0, static_cast<std::size_t>(i + 1)});
    edit.body_edits.push_back(
        {drawing.document.new_body_edit_id(static_cast<std::uint64_t>(i)), nullptr,
         std::make_shared<const BodyEdit>(testing::random_body_edit(random))});
  }
  EXPECT_TRUE(drawing.document.apply(edit));
  return drawing;
}

TEST(KeyTimingBlob, EveryValueReadsBackAndWhatIsCutOffIsNone) {
  testing::RandomStroke random(3);
  for (int i = 0; i < 300; ++i) {
    const KeyTiming timing = testing::random_timing(random);
    const BodyEdit edit = testing::random_body_edit(random);
    const std::string_view kind = body_edit_kind_name(edit.kind);
    std::string bytes, shape;
    ASSERT_TRUE(append_key_timing_blob(bytes, timing));
    ASSERT_TRUE(append_body_edit_blob(shape, edit));
    ASSERT_LE(shape.size(), kMaxBodyEditBytes);
    const Result<KeyTimingPtr> back = read_key_timing_blob(bytes);
    const Result<BodyEditPtr> edit_back = read_body_edit_blob(kind, shape);
    ASSERT_TRUE(back) << back.error().message;
    ASSERT_TRUE(edit_back) << edit_back.error().message;
    ASSERT_EQ(**back, timing);
    ASSERT_EQ(**edit_back, edit);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      ASSERT_FALSE(read_key_timing_blob(std::string_view(bytes).substr(0, size))) << size;
    }
    for (std::size_t size = 0; size < shape.size(); ++size) {
      ASSERT_FALSE(read_body_edit_blob(kind, std::string_view(shape).substr(0, size))) << size;
    }
    EXPECT_FALSE(read_key_timing_blob(bytes + '\0'));
    EXPECT_FALSE(read_body_edit_blob(kind, shape + '\0'));
    EXPECT_FALSE(read_body_edit_blob("bend", shape));
  }
}

TEST(KeyTimingBlob, TheLargestValuesFit) {
  KeyTiming timing;
  for (std::uint64_t i = 0; i < KeyTiming::kMaxPairs; ++i) {
    timing.pairs.push_back({{(1ULL << 53) - i}, {(1ULL << 53) - i}});
  }
  std::string bytes;
  ASSERT_TRUE(append_key_timing_blob(bytes, timing));
  EXPECT_LE(bytes.size(), kMaxKeyTimingBytes);
  BodyEdit edit{.kind = BodyEditKind::kExtrude};
  edit.path_mm.resize(BodyEdit::kMaxPoints);
  edit.profile_mm.resize(BodyEdit::kMaxPoints);
  bytes.clear();
  ASSERT_TRUE(append_body_edit_blob(bytes, edit));
  EXPECT_LE(bytes.size(), kMaxBodyEditBytes);
}

TEST(KeyTimingBlob, InvalidValuesAreNotWrittenAndNotRead) {
  testing::RandomStroke random(9);
  const auto damage = [&random](std::string& bytes) {
    bytes[static_cast<std::size_t>(random.pick(0, static_cast<int>(bytes.size()) - 1))] =
        static_cast<char>(random.pick(0, 255));
  };
  for (int i = 0; i < 2000; ++i) {
    std::string bytes, shape;
    ASSERT_TRUE(append_key_timing_blob(bytes, testing::random_timing(random)));
    const BodyEdit edit = testing::random_body_edit(random);
    ASSERT_TRUE(append_body_edit_blob(shape, edit));
    damage(bytes);
    damage(shape);
    const Result<KeyTimingPtr> timing = read_key_timing_blob(bytes);
    EXPECT_TRUE(!timing || check_key_timing(**timing));
    const auto read = read_body_edit_blob(body_edit_kind_name(edit.kind), shape);
    EXPECT_TRUE(!read || check_body_edit(**read));
  }
  std::string bytes;
  EXPECT_FALSE(append_key_timing_blob(bytes, KeyTiming{.hold = 0}));
  EXPECT_FALSE(append_body_edit_blob(bytes, BodyEdit{}));
  EXPECT_EQ(bytes, "");
}

TEST(KeyTimingTable, ADrawingWithoutTimingsHasNoSuchTables) {
  const std::string none = *felt_bytes(with_timings(0)), some = *felt_bytes(with_timings(3));
  for (const char* table : {"CREATE TABLE key_timing", "CREATE TABLE body_edit"}) {
    EXPECT_EQ(none.find(table), std::string::npos) << table;
    EXPECT_NE(some.find(table), std::string::npos) << table;
  }
}

TEST(KeyTimingTable, AFileKeepsTimingsAndEditsOfTheBody) {
  for (const int count : {1, 2, 19}) {
    const Drawing drawing = with_timings(count);
    const std::string bytes = *felt_bytes(drawing);
    const Result<Drawing> back = parse_felt(bytes);
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(*back, drawing);
    EXPECT_EQ(*felt_bytes(*back), bytes);
  }
}

/// Returns the error of reading a file whose tables an SQL statement has changed.
std::string error_after(const char* sql) {
  Result<Database> database = Database::create();
  EXPECT_TRUE(database);
  const std::string setup = "PRAGMA application_id=" + std::to_string(kFeltApplicationId) +
                            "; PRAGMA user_version=" + std::to_string(kFeltVersion);
  EXPECT_TRUE(database->run(setup.c_str()));
  EXPECT_TRUE(write_tables(*database, with_timings(4), nullptr));
  EXPECT_TRUE(database->run(sql)) << sql;
  const Result<Drawing> read = parse_felt(*database->bytes());
  return read ? "" : read.error().message;
}

TEST(KeyTimingTable, WrongRowsAreRefused) {
  EXPECT_EQ(error_after("SELECT 1"), "");
  EXPECT_THAT(error_after("UPDATE key_timing SET checksum=7 WHERE id=1"),
              HasSubstr("the timing of layer 2 is damaged"));
  EXPECT_THAT(error_after("UPDATE key_timing SET layer=99 WHERE id=1"), HasSubstr("key_timing"));
  EXPECT_THAT(error_after("UPDATE key_timing SET layer=2"), HasSubstr("key_timing"));
  EXPECT_THAT(error_after("UPDATE key_timing SET timing=5"), HasSubstr("key_timing"));
  EXPECT_THAT(error_after("UPDATE body_edit SET checksum=7 WHERE id=2"),
              HasSubstr("body edit 2 is damaged"));
  EXPECT_THAT(error_after("UPDATE body_edit SET kind='bend' WHERE id=2"), HasSubstr("damaged"));
  EXPECT_THAT(error_after("UPDATE body_edit SET shape=5 WHERE id=2"), HasSubstr("invalid value"));
  EXPECT_THAT(error_after("UPDATE body_edit SET id=9 WHERE id=2"), HasSubstr("damaged"));
}

TEST(KeyTimingTable, SalvageFindsTimingsAndEditsOfTheBody) {
  const Drawing drawing = with_timings(8);
  std::string bytes = *felt_bytes(drawing);
  bytes[100 + 8] ^= 0x55;  // in the schema
  ASSERT_FALSE(parse_felt(bytes));
  const Result<Salvaged> salvaged = salvage_felt_bytes(bytes);
  ASSERT_TRUE(salvaged) << salvaged.error().message;
  EXPECT_EQ(salvaged->drawing.document.body_edits().size(), 8U);
  for (const Layer& layer : drawing.document.layers()) {
    const Layer* found = salvaged->drawing.document.layer(layer.id);
    ASSERT_TRUE(found);
    EXPECT_TRUE(equal_timings(found->timing, layer.timing));
  }
}

}  // namespace
}  // namespace felt::key_timing_table_test
