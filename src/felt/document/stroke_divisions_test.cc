#include "felt/document/stroke_divisions.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>

#include "felt/document/testing/random_document.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::stroke_divisions_test {
namespace {

StrokePtr some_stroke(double x) {
  return std::make_shared<const Stroke>(testing::straight_stroke({x, 0}, {x, 9}, 1, 1));
}

/// Returns a document with two layers of `count` strokes. Some strokes of the lower layer are
/// moved, so that the ids in it do not ascend.
Document two_layers(std::size_t count, std::mt19937_64& random) {
  Document document;
  EXPECT_TRUE(document.apply({"Layer", {}, {{{2}, std::nullopt, LayerState{"Top"}, 0, 1}}}));
  for (std::size_t i = 0; i < count; ++i) {
    const LayerId layer{1 + i % 2};
    const std::size_t size = document.layer(layer)->strokes.size();
    const std::size_t at = i % 5 == 0 ? random() % (size + 1) : size;
    EXPECT_TRUE(document.apply(
        {"Add", {{document.new_id(), nullptr, some_stroke(double(i)), {}, {layer, at}}}}));
  }
  return document;
}

RC_GTEST_PROP(StrokeDivisions, PartsStandWhereTheStrokeStood, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  const std::size_t count = 1 + random() % 40;
  Document document = two_layers(count, random);
  const Document original = document;
  std::map<LayerId, std::vector<StrokePtr>> expected;
  StrokeDivisions divisions;
  for (const Layer& layer : document.layers()) {
    for (const StrokeId id : layer.strokes) {
      if (random() % 2 == 0) {
        expected[layer.id].push_back(document.find(id));
        continue;
      }
      divisions.set(document, id, {some_stroke(-1), some_stroke(-2)});  // and then in another way
      if (random() % 8 == 0) {
        divisions.unset(id);
        expected[layer.id].push_back(document.find(id));
        continue;
      }
      std::vector<StrokePtr> parts;
      for (std::size_t k = random() % 4; k > 0; --k)
        parts.push_back(some_stroke(100.0 + double(k)));
      for (const StrokePtr& p : parts) expected[layer.id].push_back(p);
      divisions.set(document, id, parts);
    }
  }
  const Edit edit = divisions.build(document, "Erase");
  RC_ASSERT(edit.label == "Erase");
  RC_ASSERT(document.apply(edit).has_value());
  for (const Layer& layer : document.layers()) {
    std::vector<StrokePtr> now;
    for (const StrokeId id : layer.strokes) now.push_back(document.find(id));
    RC_ASSERT(now == expected[layer.id]);
  }
  RC_ASSERT(document.apply(edit.inverse()).has_value());
  RC_ASSERT(document == original);
}

TEST(StrokeDivisions, TheOrderOfTheCallsDoesNotMatter) {
  std::mt19937_64 random(3);
  const Document document = two_layers(20, random);
  StrokeDivisions up, down;
  const std::vector<StrokePtr> parts{some_stroke(1), some_stroke(2)};
  for (std::uint64_t i = 1; i <= 20; ++i) up.set(document, {i}, parts);
  for (std::uint64_t i = 20; i >= 1; --i) down.set(document, {i}, parts);
  EXPECT_EQ(up.build(document, "x"), down.build(document, "x"));
  EXPECT_FALSE(up.empty());
  up.clear();
  EXPECT_TRUE(up.empty());
  EXPECT_TRUE(up.build(document, "x").empty());
}

}  // namespace
}  // namespace felt::stroke_divisions_test
