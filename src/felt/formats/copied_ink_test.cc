// What a copy command puts on the clipboard, and where a paste puts it.
#include "felt/formats/copied_ink.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "felt/document/testing/random_document.h"
#include "felt/tools/tool.h"

namespace felt::copied_ink_test {
namespace {

Document random_document(std::uint64_t seed) {
  Document document;
  testing::RandomEdits edits(seed);
  for (int i = 0; i < 12; ++i) EXPECT_TRUE(document.apply(edits.next(document)));
  return document;
}

Session session_with(const Document& document) {
  SessionOptions options;
  options.document = document;
  return Session(make_tools(), std::move(options));
}

/// Returns the strokes of visible layers for which `is_chosen` is true, in drawing order.
std::vector<StrokeId> visible_ids(const Document& document,
                                  const std::function<bool(StrokeId)>& is_chosen) {
  std::vector<StrokeId> ids;
  for (const Layer& layer : document.layers()) {
    for (const StrokeId id : layer.strokes) {
      if (layer.visible && is_chosen(id)) ids.push_back(id);
    }
  }
  return ids;
}

}  // namespace

RC_GTEST_PROP(CopiedInk, HasTheChosenVisibleStrokesUnchanged, (std::uint64_t seed, bool is_all)) {
  const Document document = random_document(seed);
  const Session session = session_with(document);
  const auto is_chosen = [is_all](StrokeId id) { return is_all || id.value % 2 == 0; };
  const Drawing copy = copied_drawing(session, is_chosen);
  RC_ASSERT(copy.document.layers().size() == 1);
  const std::vector<StrokeId> expected = visible_ids(document, is_chosen);
  RC_ASSERT(copy.document.layers().front().strokes == expected);
  for (const StrokeId id : expected) RC_ASSERT(*copy.document.find(id) == *document.find(id));
  // A fill comes with all of its strokes, or with nothing.
  for (const FillId id : copy.document.layers().front().fills) {
    const Fill& fill = *copy.document.find_fill(id);
    const auto is_any = [](StrokeId) { return true; };
    const auto is_copied = [&](StrokeId stroke) { return copy.document.find(stroke) != nullptr; };
    RC_ASSERT(!goes_with_strokes(fill, is_any) || goes_with_strokes(fill, is_copied));
  }
}

RC_GTEST_PROP(CopiedInk, AMoveKeepsShapesAndOrder, (std::uint64_t seed, int dx, int dy)) {
  const VisibleInk ink = visible_ink(random_document(seed));
  const Vec by_mm{0.01 * (dx % 10000), 0.01 * (dy % 10000)};
  const VisibleInk moved = moved_ink(ink, by_mm);
  RC_ASSERT(moved.strokes.size() == ink.strokes.size());
  RC_ASSERT(moved.fills.size() == ink.fills.size());
  for (std::size_t i = 0; i < ink.strokes.size(); ++i) {
    const StrokeData &before = ink.strokes[i]->data(), &after = moved.strokes[i]->data();
    RC_ASSERT(after.points.size() == before.points.size());
    for (std::size_t k = 0; k < before.points.size(); ++k) {
      RC_ASSERT(distance(after.points[k], before.points[k] + by_mm) < 1e-3);
    }
    RC_ASSERT(ink.strokes[i]->medium() == moved.strokes[i]->medium());
  }
  for (std::size_t i = 0; i < ink.fills.size(); ++i) {
    for (std::size_t k = 0; k < ink.fills[i]->loops.size(); ++k) {
      const FillLoop &before = ink.fills[i]->loops[k], &after = moved.fills[i]->loops[k];
      RC_ASSERT(after.points.size() == before.points.size());
      for (std::size_t j = 0; j < before.points.size(); ++j) {
        RC_ASSERT(distance(after.points[j], before.points[j] + by_mm) < 1e-9);
      }
    }
  }
}

TEST(CopiedInk, NothingChosenIsEmpty) {
  const Session session = session_with(random_document(7));
  const Drawing copy = copied_drawing(session, [](StrokeId) { return false; });
  EXPECT_EQ(copy.document.stroke_count(), 0U);
  const Session empty = session_with(Document());
  EXPECT_TRUE(ink_bounds(copied_drawing(empty, [](StrokeId) { return true; }).document).empty());
}

}  // namespace felt::copied_ink_test
