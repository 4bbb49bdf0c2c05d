#include "felt/store/felt_salvage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "felt/document/testing/random_document.h"
#include "felt/document/testing/small_picture.h"
#include "felt/store/page_scan.h"

namespace felt::felt_salvage_test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::size_t kPage = 4096;

/// Returns several pages of strokes in three layers. One of the strokes is larger than a page.
Drawing some_drawing() {
  Drawing drawing;
  testing::RandomEdits edits(3);
  Edit edit;
  edit.layers.push_back({{2}, std::nullopt, LayerState{"Birds", true, false}, 0, 1});
  edit.layers.push_back({{3}, std::nullopt, LayerState{"Trees", false, true}, 0, 2});
  std::vector<std::size_t> places(4);
  for (std::uint64_t i = 1; i <= 150; ++i) {
    const std::uint64_t layer = 1 + i % 3;
    edit.changes.push_back({{i}, nullptr, edits.stroke(), {}, {{layer}, places[layer]++}});
  }
  StrokeData data;
  data.points.push_back({0, 0});
  for (int i = 1; i <= 400; ++i) {
    const double x = 1.0 / 3.0 * i;
    data.points.insert(data.points.end(), {{x - 0.2, 0.1}, {x - 0.1, 0.1}, {x, 1.0 / (i % 7 + 1)}});
  }
  data.joints.assign(399, JointKind::kCorner);
  data.widths = {{0.0, 1.0}, {400.0, 2.0}};
  edit.changes.push_back({{151},
                          nullptr,
                          std::make_shared<const Stroke>(Stroke::create(data).value()),
                          {},
                          {{1}, places[1]}});
  EXPECT_TRUE(drawing.document.apply(edit));
  drawing.page = {300.0, 200.5, {9, 9, 9, 255}};
  drawing.page.surface = "paper";
  drawing.layer = {2};
  drawing.palette = {"mine", 4, {{{1, 2, 3, 255}, "Grün"}, {{4, 5, 6, 255}, ""}}};
  drawing.view = Viewport{{10.0, 0.5}, 3.0, -20.0, true};
  return drawing;
}

/// Returns true if all strokes except the lost ones were recovered, in their layers.
bool keeps_all_of(const Drawing& got, const Drawing& drawing, const std::set<std::uint64_t>& lost) {
  for (const Layer& layer : drawing.document.layers()) {
    for (const StrokeId id : layer.strokes) {
      if (lost.contains(id.value)) continue;
      const StrokePtr found = got.document.find(id);
      if (!found || !(*found == *drawing.document.find(id))) return false;
      if (got.document.layer_of(id) != layer.id) return false;
    }
  }
  return true;
}

/// Returns true if all ink except the lost strokes was recovered. A flipped bit may give a stroke
/// the id of another stroke. Both are then intact, and one of them gets a new id.
bool keeps_ink_of(const Drawing& got, const Drawing& drawing, const std::set<std::uint64_t>& lost) {
  std::vector<StrokePtr> all;
  for (const Layer& layer : got.document.layers()) {
    for (const StrokeId id : layer.strokes) all.push_back(got.document.find(id));
  }
  for (const Layer& layer : drawing.document.layers()) {
    for (const StrokeId id : layer.strokes) {
      const Stroke& stroke = *drawing.document.find(id);
      const auto is_it = [&stroke](const StrokePtr& other) { return *other == stroke; };
      if (!lost.contains(id.value) && std::none_of(all.begin(), all.end(), is_it)) return false;
    }
  }
  return true;
}

/// Returns the strokes that have bytes in the pages `from` to `to`.
std::set<std::uint64_t> strokes_in(const std::string& bytes, std::size_t from, std::size_t to) {
  const auto ids = [](const std::string& file) {
    std::set<std::uint64_t> all;
    const auto salvaged = salvage_felt_bytes(file);
    if (!salvaged) return all;
    for (const Layer& layer : salvaged->drawing.document.layers()) {
      for (const StrokeId id : layer.strokes) all.insert(id.value);
    }
    return all;
  };
  std::string blank = bytes;
  blank.replace(from * kPage, (to - from) * kPage, (to - from) * kPage, '\0');
  std::set<std::uint64_t> all = ids(bytes);
  for (const std::uint64_t id : ids(blank)) all.erase(id);
  return all;
}

TEST(FeltSalvage, AWholeFileComesBackAsItIs) {
  const Drawing drawing = some_drawing();
  const Salvaged salvaged = salvage_felt_bytes(felt_bytes(drawing).value()).value();
  EXPECT_TRUE(salvaged.drawing == drawing);
  EXPECT_THAT(salvaged.problems, IsEmpty());
}

TEST(FeltSalvage, WithoutAHeadAllIsThere) {
  const Drawing drawing = some_drawing();
  std::string bytes = felt_bytes(drawing).value();
  bytes.replace(0, kPage, kPage, '\0');
  const Salvaged salvaged = salvage_felt_bytes(bytes).value();
  EXPECT_TRUE(salvaged.drawing == drawing);
  EXPECT_EQ(salvaged.problems.size(), 1u);
  EXPECT_TRUE(felt_bytes(salvaged.drawing));
}

/// Destroys each page in turn. Only the content of that page may be lost.
/// Returns some_drawing() with looks of layers: one is translucent, and two have the same picture.
Drawing drawing_with_looks() {
  Drawing drawing = some_drawing();
  Edit edit;
  const auto layers = drawing.document.layers();
  LayerState birds = layers[1].state(), trees = layers[2].state();
  birds.opacity = 0.375;
  birds.picture = testing::red_blue_picture(50.0, 7.0);
  trees.picture = testing::red_blue_picture(1.0 / 3.0, 7.0);
  trees.blend = BlendMode::kMultiply;
  birds.group = trees.group = std::make_shared<const LayerGroup>(
      LayerGroup{{5}, "Outside", true, true, 0.25, BlendMode::kMultiply});
  edit.layers.push_back({layers[1].id, layers[1].state(), birds, 1, 1});
  edit.layers.push_back({layers[2].id, layers[2].state(), trees, 2, 2});
  EXPECT_TRUE(drawing.document.apply(edit));
  return drawing;
}

TEST(FeltSalvage, LayersKeepTheirLooksAndGroups) {
  const Drawing drawing = drawing_with_looks();
  std::string bytes = felt_bytes(drawing).value();
  bytes.replace(0, 100, 100, '\0');  // only the head of the file
  const Salvaged salvaged = salvage_felt_bytes(bytes).value();
  const auto layers = salvaged.drawing.document.layers();
  ASSERT_EQ(layers.size(), 3U);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    EXPECT_TRUE(layers[i].state() == drawing.document.layers()[i].state()) << i;
  }
}

TEST(FeltSalvage, ADamagedPictureIsLeftOut) {
  const Drawing drawing = drawing_with_looks();
  const std::string& png = drawing.document.layers()[2].picture->data->png;
  std::string bytes = felt_bytes(drawing).value();
  bytes.replace(0, 100, 100, '\0');
  const std::size_t at = bytes.find(png);
  ASSERT_NE(at, std::string::npos);
  bytes[at + png.size() - 20] ^= 1;
  const Salvaged salvaged = salvage_felt_bytes(bytes).value();
  const auto layers = salvaged.drawing.document.layers();
  ASSERT_EQ(layers.size(), 3U);
  EXPECT_EQ(layers[1].opacity, 0.375);
  EXPECT_EQ(layers[1].picture, nullptr);
  EXPECT_EQ(layers[2].picture, nullptr);
  EXPECT_THAT(salvaged.problems.back(), HasSubstr("Other data"));
}

TEST(FeltSalvage, EveryStrokeOnWholePagesIsThere) {
  const Drawing drawing = some_drawing();
  const std::string bytes = felt_bytes(drawing).value();
  const std::size_t pages = bytes.size() / kPage;
  ASSERT_GE(pages, 10u);
  std::size_t together = 0;
  for (std::size_t page = 0; page < pages; ++page) {
    const std::set<std::uint64_t> lost = strokes_in(bytes, page, page + 1);
    together += lost.size();
    for (const char fill : {'\0', '\xff', '\x0d'}) {
      std::string changed = bytes;
      changed.replace(page * kPage, kPage, kPage, fill);
      const Result<Salvaged> salvaged = salvage_felt_bytes(changed);
      ASSERT_TRUE(salvaged) << page;
      EXPECT_TRUE(keeps_all_of(salvaged->drawing, drawing, lost)) << page;
      EXPECT_EQ(salvaged->drawing.document.stroke_count() + lost.size(), 151u) << page;
      EXPECT_FALSE(salvaged->problems.empty()) << page;
      EXPECT_TRUE(felt_bytes(salvaged->drawing)) << page;
    }
  }
  EXPECT_GE(together, 151u);  // each stroke was in some page, the large one in several
  EXPECT_LT(together, 151u + 10u);
}

TEST(FeltSalvage, ACutFileGivesWhatIsBeforeTheCut) {
  const Drawing drawing = some_drawing();
  const std::string bytes = felt_bytes(drawing).value();
  std::mt19937 random(6);
  for (std::size_t page = 1; page < bytes.size() / kPage; ++page) {
    const std::set<std::uint64_t> lost = strokes_in(bytes, page, bytes.size() / kPage);
    const auto salvaged =
        salvage_felt_bytes(std::string_view(bytes).substr(0, page * kPage + random() % kPage));
    if (!salvaged) {
      EXPECT_EQ(lost.size(), 151u);
      continue;
    }
    EXPECT_TRUE(keeps_all_of(salvaged->drawing, drawing, lost)) << page;
  }
}

TEST(FeltSalvage, FlippedBitsCostOnlyWhatTheyHit) {
  const Drawing drawing = some_drawing();
  const std::string bytes = felt_bytes(drawing).value();
  std::mt19937 random(7);
  for (int run = 0; run < 1000; ++run) {
    std::string changed = bytes;
    const std::size_t at = random() % bytes.size();
    changed[at] ^= static_cast<char>(1 << random() % 8);
    const Result<Salvaged> salvaged = salvage_felt_bytes(changed);
    ASSERT_TRUE(salvaged) << "byte " << at;
    const std::set<std::uint64_t> lost = strokes_in(bytes, at / kPage, at / kPage + 1);
    EXPECT_TRUE(at / kPage == 0 || keeps_ink_of(salvaged->drawing, drawing, lost)) << "byte " << at;
  }
}

TEST(FeltSalvage, SaysWhatIsMissing) {
  const Drawing drawing = some_drawing();
  const std::string bytes = felt_bytes(drawing).value();
  const auto problems = [](const std::string& file) {
    std::string all;
    const Salvaged salvaged = salvage_felt_bytes(file).value();
    for (const std::string& problem : salvaged.problems) all += problem + "\n";
    return all;
  };
  std::string all_problems;
  for (std::size_t page = 1; page < bytes.size() / kPage; ++page) {
    std::string changed = bytes;
    changed.replace(page * kPage, kPage, kPage, '\0');
    all_problems += problems(changed);
  }
  EXPECT_THAT(all_problems, HasSubstr("The file is damaged"));
  EXPECT_THAT(all_problems, HasSubstr("The page size"));
  EXPECT_THAT(all_problems, HasSubstr("3 layers lost their names"));
  EXPECT_THAT(all_problems, HasSubstr("of the layer “Birds” could not be read"));
  EXPECT_THAT(salvage_felt_bytes("").error().message,
              HasSubstr("is empty; it does not contain any part of a drawing"));
  EXPECT_THAT(salvage_felt_bytes(std::string(10'000, 'x')).error().message,
              HasSubstr("any part of a drawing"));
  EXPECT_THAT(salvage_felt("/none/x.felt").error().message, HasSubstr("/none/x.felt"));
  std::string newer = bytes;
  newer[63] = 2;
  EXPECT_THAT(problems(newer), HasSubstr("written by a newer Feltline"));
}

/// If all cells refer to the same large row, the work is still bounded by the size of the file.
TEST(FeltSalvage, IsBoundedWhateverThePagesSay) {
  std::string bytes(std::size_t{1} << 20, '\x0d');
  std::size_t reported = 0;
  scan_rows(bytes, [&](const ScannedRow& row) {
    for (const ScannedRow::Value& value : row.values) {
      if (const auto* text = std::get_if<ScannedRow::Bytes>(&value)) reported += text->value.size();
    }
  });
  EXPECT_LT(reported, std::size_t{8} << 20);
}

}  // namespace
}  // namespace felt::felt_salvage_test
