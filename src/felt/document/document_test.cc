#include "felt/document/document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "felt/document/drawing_guide.h"
#include "felt/document/edit_builder.h"
#include "felt/document/testing/random_document.h"

namespace felt::document_test {
namespace {

using ::testing::HasSubstr;

StrokePtr line(double x) {
  return std::make_shared<const Stroke>(testing::straight_stroke({x, 0}, {x, 10}, 1, 1));
}

/// Returns a document with strokes 1..n in layer 1.
Document with_strokes(int n) {
  Document d;
  EditBuilder edit(d);
  for (int i = 0; i < n; ++i) edit.add({1}, line(i));
  EXPECT_TRUE(d.apply(std::move(edit).build("Draw")));
  return d;
}

std::string error_of(const Document& document, const Edit& edit) {
  Document copy = document;
  const auto result = copy.apply(edit);
  EXPECT_FALSE(result) << "should not fit";
  EXPECT_EQ(copy, document) << "a refused edit left something behind";
  EXPECT_EQ(copy.new_id(), document.new_id());
  return result ? "" : result.error().message;
}

TEST(Document, BeginsWithOneEmptyLayer) {
  const Document d;
  ASSERT_EQ(d.layers().size(), 1u);
  EXPECT_EQ(d.layers()[0].name, "Ink");
  EXPECT_TRUE(d.layers()[0].visible);
  EXPECT_FALSE(d.layers()[0].locked);
  EXPECT_EQ(d.stroke_count(), 0u);
  EXPECT_FALSE(d.find({1}));
  EXPECT_EQ(d.new_id().value, 1u);
}

TEST(Document, PlacesAreAbsoluteWhateverElseMoves) {
  Document d = with_strokes(6);
  // 1..6 becomes 7 2 4' 6 1: four changes in an arbitrary order.
  const Edit edit{"Shuffle",
                  {{{1}, d.find({1}), d.find({1}), {{1}, 0}, {{1}, 4}},
                   {{5}, d.find({5}), nullptr, {{1}, 4}, {}},
                   {{7}, nullptr, line(7), {}, {{1}, 0}},
                   {{3}, d.find({3}), nullptr, {{1}, 2}, {}},
                   {{4}, d.find({4}), line(44), {{1}, 3}, {{1}, 2}}}};
  ASSERT_TRUE(d.apply(edit));
  EXPECT_THAT(d.layers()[0].strokes, ::testing::ElementsAre(StrokeId{7}, StrokeId{2}, StrokeId{4},
                                                            StrokeId{6}, StrokeId{1}));
  Edit turned = edit;
  std::reverse(turned.changes.begin(), turned.changes.end());
  Document other = with_strokes(6);
  ASSERT_TRUE(other.apply(turned));
  EXPECT_EQ(other, d);
}

TEST(Document, RefusesWhatDoesNotFitAndSaysWhy) {
  const Document d = with_strokes(3);
  const StrokePtr s = line(9);
  EXPECT_THAT(error_of(d, {"Pull", {{{9}, s, s, {{1}, 0}, {{1}, 0}}}}),
              HasSubstr("the edit 'Pull' does not match the document: stroke 9 does not exist"));
  EXPECT_THAT(error_of(d, {"", {{{2}, nullptr, s, {}, {{1}, 3}}}}), HasSubstr("already exists"));
  EXPECT_THAT(error_of(d, {"", {{{2}, s, nullptr, {{1}, 1}, {}}}}), HasSubstr("has changed"));
  EXPECT_THAT(error_of(d, {"", {{{2}, d.find({2}), nullptr, {{1}, 0}, {}}}}),
              HasSubstr("is not at index 0"));
  EXPECT_THAT(error_of(d, {"", {{{2}, d.find({2}), nullptr, {{8}, 1}, {}}}}),
              HasSubstr("of layer 8"));
  EXPECT_THAT(error_of(d, {"", {{{9}, nullptr, s, {}, {{2}, 0}}}}),
              HasSubstr("layer 2 does not exist"));
  EXPECT_THAT(error_of(d, {"", {{{9}, nullptr, s, {}, {{1}, 4}}}}), HasSubstr("beyond the end"));
  EXPECT_THAT(error_of(d, {"", {{{9}, nullptr, s, {}, {{1}, 3}}, {{8}, nullptr, s, {}, {{1}, 3}}}}),
              HasSubstr("used twice"));
  EXPECT_THAT(error_of(d, {"", {{{9}, nullptr, s, {}, {{1}, 3}}, {{9}, nullptr, s, {}, {{1}, 4}}}}),
              HasSubstr("stroke 9 is changed twice"));
  EXPECT_THAT(error_of(d, {"", {{{9}, nullptr, nullptr, {}, {}}}}), HasSubstr("neither"));
  EXPECT_THAT(error_of(d, {"", {{{0}, nullptr, s, {}, {{1}, 3}}}}), HasSubstr("without an id"));
  // Only the last change is invalid. The changes before it must not remain.
  EXPECT_THAT(error_of(d, {"", {{{9}, nullptr, s, {}, {{1}, 3}}, {{7}, s, nullptr, {{1}, 0}, {}}}}),
              HasSubstr("stroke 7 does not exist"));
}

TEST(Document, HasAtMost256Guides) {
  Document d;
  Edit many{"Add", {}}, one{"Add", {}}, swapped{"Add", {}};
  const auto guide = std::make_shared<const DrawingGuide>();
  for (std::uint64_t i = 1; i <= kMaxDrawingGuides; ++i)
    many.guides.push_back({{i}, nullptr, guide});
  ASSERT_TRUE(d.apply(many));
  const Document full = d;
  one.guides.push_back({{1000}, nullptr, guide});
  EXPECT_THAT(error_of(d, one), HasSubstr("at most 256 guides"));
  EXPECT_EQ(d, full);
  swapped.guides = {{{1}, guide, nullptr}, {{1000}, nullptr, guide}};
  EXPECT_TRUE(d.apply(swapped));
}

TEST(Document, RefusesLayersThatDoNotFit) {
  const Document d = with_strokes(2);
  const LayerState ink{"Ink"}, other{"Other"};
  EXPECT_THAT(error_of(d, {"", {}, {{{1}, ink, std::nullopt, 0, 0}}}), HasSubstr("no layer"));
  EXPECT_THAT(
      error_of(d, {"", {}, {{{1}, ink, std::nullopt, 0, 0}, {{2}, std::nullopt, other, 0, 0}}}),
      HasSubstr("2 strokes are on it"));
  EXPECT_THAT(error_of(d, {"", {}, {{{1}, other, ink, 0, 0}}}), HasSubstr("has changed"));
  EXPECT_THAT(error_of(d, {"", {}, {{{1}, ink, other, 1, 0}}}), HasSubstr("is not at index"));
  EXPECT_THAT(error_of(d, {"", {}, {{{1}, ink, other, 0, 1}}}), HasSubstr("beyond the end"));
  EXPECT_THAT(error_of(d, {"", {}, {{{1}, std::nullopt, other, 0, 1}}}), HasSubstr("already"));
  EXPECT_THAT(error_of(d, {"", {}, {{{2}, other, std::nullopt, 1, 0}}}),
              HasSubstr("does not exist"));
}

TEST(Document, R52_AnyEditsAreUndoneByTheirInversesBackwards) {
  std::size_t changes = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    testing::RandomEdits random(seed);
    Document d;
    std::vector<Document> states{d};
    std::vector<Edit> edits;
    for (int k = 0; k < 30; ++k) {
      edits.push_back(random.next(d));
      changes += edits.back().changes.size();
      const auto ok = d.apply(edits.back());
      ASSERT_TRUE(ok) << ok.error().message;
      ASSERT_TRUE(testing::is_consistent(d));
      ASSERT_EQ(edits.back().inverse().inverse(), edits.back());
      states.push_back(d);
    }
    for (std::size_t k = edits.size(); k-- > 0;) {
      const auto ok = d.apply(edits[k].inverse());
      ASSERT_TRUE(ok) << ok.error().message;
      ASSERT_EQ(d, states[k]);
      for (const Layer& layer : d.layers()) {
        // Undo restores the same objects, and therefore every bit.
        for (StrokeId id : layer.strokes) ASSERT_EQ(d.find(id), states[k].find(id));
      }
    }
    for (std::size_t k = 0; k < edits.size(); ++k) ASSERT_TRUE(d.apply(edits[k]));
    EXPECT_EQ(d, states.back());
  }
  EXPECT_GT(changes, 5000u);
}

TEST(Document, IdsAreNeverReusedNotEvenAfterUndo) {
  Document d;
  std::set<StrokeId> seen;
  testing::RandomEdits random(1);
  for (int k = 0; k < 200; ++k) {
    const Edit edit = random.next(d);
    for (const StrokeChange& c : edit.changes) {
      if (!c.before) {
        EXPECT_TRUE(seen.insert(c.id).second) << c.id.value;
      }
    }
    ASSERT_TRUE(d.apply(edit));
    if (k % 3 == 0) {
      ASSERT_TRUE(d.apply(edit.inverse()));
    }
    EXPECT_FALSE(seen.contains(d.new_id()));
    EXPECT_FALSE(seen.contains(d.new_id(5)));
    EXPECT_FALSE(d.layer(d.new_layer_id()));
  }
  EXPECT_GT(seen.size(), 200u);
}

TEST(Document, CopiesAreSnapshots) {
  Document d = with_strokes(3);
  const Document before = d;
  EditBuilder edit(d);
  edit.replace({2}, line(50));
  edit.remove({1});
  ASSERT_TRUE(d.apply(std::move(edit).build("Change")));
  EXPECT_EQ(before, with_strokes(3));
  EXPECT_NE(before, d);
  EXPECT_EQ(before.find({3}), d.find({3}));
}

TEST(EditBuilder, WorksThePlacesOut) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    testing::RandomEdits edits(seed);
    testing::RandomStroke random(seed);
    Document d;
    for (int k = 0; k < 5; ++k) ASSERT_TRUE(d.apply(edits.next(d)));
    EditBuilder builder(d);
    std::vector<std::pair<LayerId, std::vector<StrokeId>>> expected;
    for (const Layer& layer : d.layers()) {
      auto& order = expected.emplace_back(layer.id, std::vector<StrokeId>{}).second;
      for (StrokeId id : layer.strokes) {
        const double dice = random.uniform(0, 1);
        if (dice < 0.3) {
          builder.remove(id);
          continue;
        }
        if (dice < 0.5) builder.replace(id, edits.stroke());
        order.push_back(id);
      }
      if (random.chance(0.5)) order.push_back(builder.add(layer.id, edits.stroke()));
      if (random.chance(0.5)) order.push_back(builder.add(layer.id, edits.stroke()));
    }
    const auto ok = d.apply(std::move(builder).build("Built"));
    ASSERT_TRUE(ok) << ok.error().message;
    for (const auto& [id, order] : expected) EXPECT_EQ(d.layer(id)->strokes, order);
  }
}

TEST(Document, ReservedIdsNameNothingNew) {
  Document document;
  document.reserve_ids({41}, {6});
  EXPECT_EQ(document.new_id(), StrokeId{42});
  EXPECT_EQ(document.new_layer_id(), LayerId{7});
  document.reserve_ids({3}, {2});  // never lowers the ids
  EXPECT_EQ(document.new_id(), StrokeId{42});
  EXPECT_EQ(document.new_layer_id(), LayerId{7});
}

}  // namespace
}  // namespace felt::document_test
