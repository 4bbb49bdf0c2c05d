// Names of strokes in a .felt file. The table exists only if strokes have names of their own.
#include "felt/store/stroke_name_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "felt/document/edit_builder.h"
#include "felt/document/testing/random_document.h"
#include "felt/document/visible_strokes.h"
#include "felt/io/limits.h"
#include "felt/store/felt_salvage.h"

namespace felt::stroke_name_table_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Returns a drawing of some strokes of which every second one has a name.
Drawing named_drawing() {
  Drawing drawing;
  testing::RandomEdits edits(4);
  while (drawing.document.stroke_count() < 8) {
    EXPECT_TRUE(drawing.document.apply(edits.next(drawing.document)));
  }
  StrokeNames names;
  bool is_named = false;
  for (const Layer& layer : drawing.document.layers()) {
    for (const StrokeId id : layer.strokes) {
      if ((is_named = !is_named)) names[id] = "Bütten <" + std::to_string(id.value) + ">";
    }
  }
  drawing.names = std::make_shared<const StrokeNames>(std::move(names));
  return drawing;
}

TEST(StrokeNameTable, NamesComeBack) {
  const Drawing drawing = named_drawing();
  const std::string bytes = felt_bytes(drawing).value();
  const Drawing back = parse_felt(bytes).value();
  EXPECT_EQ(used_names(back), used_names(drawing));
  EXPECT_GE(used_names(back).size(), 4u);
  EXPECT_TRUE(back == drawing);
  EXPECT_EQ(felt_bytes(back).value(), bytes);
}

TEST(StrokeNameTable, AFileWithoutAnyHasNoSuchTable) {
  Drawing drawing = named_drawing();
  EXPECT_THAT(felt_bytes(drawing).value(), HasSubstr(std::string(kStrokeNameTable)));
  drawing.names = nullptr;
  EXPECT_THAT(felt_bytes(drawing).value(), Not(HasSubstr("TABLE stroke_name")));
}

TEST(StrokeNameTable, TheNameOfAStrokeThatIsGoneIsNotWritten) {
  Drawing drawing = named_drawing();
  const StrokeId gone = drawing.names->begin()->first;
  EditBuilder edit(drawing.document);
  edit.remove(gone);
  ASSERT_TRUE(drawing.document.apply(std::move(edit).build("Delete")));
  const Drawing back = parse_felt(felt_bytes(drawing).value()).value();
  EXPECT_FALSE(back.names->contains(gone));
  EXPECT_EQ(back.names->size(), drawing.names->size() - 1);
  EXPECT_TRUE(back == drawing);
}

TEST(StrokeNameTable, NamesThatFilesMayNotHaveAreRefused) {
  for (const std::string& bad : {std::string(), std::string(limits::kMaxNameBytes + 1, 'x'),
                                 std::string("a\0b", 3), std::string("\xff")}) {
    Drawing drawing = named_drawing();
    drawing.names =
        std::make_shared<const StrokeNames>(StrokeNames{{drawing.names->begin()->first, bad}});
    EXPECT_EQ(felt_bytes(drawing).error().code, ErrorCode::kInvalidData);
  }
}

TEST(StrokeNameTable, ADamagedNameIsSaidAndTheRestIsSalvaged) {
  const Drawing drawing = named_drawing();
  const auto first = drawing.names->begin();
  std::string bytes = felt_bytes(drawing).value();
  bytes[bytes.find(first->second)] = 'P';
  EXPECT_THAT(parse_felt(bytes).error().message, HasSubstr("the name of a stroke is damaged"));
  StrokeNames others = *drawing.names;
  others.erase(first->first);
  EXPECT_EQ(used_names(salvage_felt_bytes(bytes).value().drawing), others);
}

TEST(StrokeNameTable, IsSalvagedWithoutTheHeadOfTheFile) {
  const Drawing drawing = named_drawing();
  std::string bytes = felt_bytes(drawing).value();
  bytes.replace(0, 4096, 4096, '\0');
  EXPECT_EQ(used_names(salvage_felt_bytes(bytes).value().drawing), used_names(drawing));
}

/// Whichever two pages are lost, no new stroke gets the name of a lost one, which may have had the
/// same id.
TEST(StrokeNameTable, SalvagedNamesGoToNoNewStroke) {
  constexpr std::size_t kPage = 4096;
  Drawing drawing;
  testing::RandomEdits edits(5);
  Edit edit;
  StrokeNames names;
  const LayerId layer = drawing.document.layers().front().id;
  for (std::uint64_t i = 1; i <= 60; ++i) {
    edit.changes.push_back({{i}, nullptr, edits.stroke(), {}, {layer, i - 1}});
    names[{i}] = "cat-" + std::to_string(i);
  }
  ASSERT_TRUE(drawing.document.apply(edit));
  drawing.names = std::make_shared<const StrokeNames>(names);
  const std::string bytes = felt_bytes(drawing).value();
  const std::size_t pages = bytes.size() / kPage;
  std::size_t lost_last = 0;
  for (std::size_t a = 0; a < pages; ++a) {
    for (std::size_t b = a + 1; b < pages; ++b) {
      std::string damaged = bytes;
      for (const std::size_t page : {a, b}) damaged.replace(page * kPage, kPage, kPage, '\0');
      const auto salvaged = salvage_felt_bytes(damaged);
      if (!salvaged) continue;
      const Drawing& back = salvaged->drawing;
      if (back.document.new_id() < drawing.document.new_id()) ++lost_last;
      for (std::uint64_t n = 0; n < 60; ++n) {
        const StrokeId id = back.document.new_id(n);
        EXPECT_EQ(name_in_file(back, id), stroke_name(id)) << "pages " << a << ", " << b;
      }
    }
  }
  EXPECT_GT(lost_last, 0u) << "new strokes get the ids of lost ones";
}

/// Hostile bytes give a result or an error, never a crash.
TEST(StrokeNameTable, StandsUpToDamage) {
  const Drawing drawing = named_drawing();
  const std::string bytes = felt_bytes(drawing).value();
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 random(seed);
    std::string damaged = bytes;
    for (int i = 0; i < 3; ++i) damaged[random() % damaged.size()] = static_cast<char>(random());
    const auto salvaged = salvage_felt_bytes(damaged);
    if (!salvaged) continue;
    for (const auto& [id, name] : used_names(salvaged->drawing)) {
      EXPECT_EQ(name, name_in_file(drawing, id)) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace felt::stroke_name_table_test
