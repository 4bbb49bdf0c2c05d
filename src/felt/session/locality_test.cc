// An edit of one stroke among many does not change any other stroke, neither its bytes nor its
// address.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "felt/document/edit_builder.h"
#include "felt/session/session.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::locality_test {
namespace {

constexpr int kStrokes = 100'000;
constexpr int kRow = 400;
constexpr double kApartMm = 40.0;

Point start_of(int i) {
  return {kApartMm * (i % kRow), kApartMm * std::floor(i / kRow)};
}

/// Returns a document whose strokes are so far apart that a gesture on one does not affect the
/// others.
Document large_document() {
  Document document;
  EditBuilder builder(document);
  for (int i = 0; i < kStrokes; ++i) {
    const Point a = start_of(i);
    builder.add(
        {1}, std::make_shared<const Stroke>(testing::straight_stroke(a, a + Vec{12, 3}, 0.5, 0.8)));
  }
  EXPECT_TRUE(document.apply(std::move(builder).build("Lines")));
  return document;
}

using Strokes = std::map<StrokeId, StrokePtr>;

Strokes strokes_of(const Document& document) {
  Strokes strokes;
  for (const Layer& layer : document.layers()) {
    for (const StrokeId id : layer.strokes) strokes[id] = document.find(id);
  }
  return strokes;
}

/// Makes a gesture across stroke i.
void gesture(Session& session, int i, std::int64_t& now_ns) {
  const auto pen = [&](Point at, double z) {
    now_ns += 1'000'000;
    ASSERT_TRUE(session.apply({now_ns, PenEvent{{at.x, at.y, z}, {}, 0}}));
  };
  const Point from = start_of(i) + Vec{6, 1.5};
  for (int k = 0; k < 20; ++k) pen(from, 4.0 - 0.2 * k);
  for (int k = 0; k < 60; ++k) pen(from + 0.05 * k * Vec{0, 1}, -1.0);
  for (int k = 0; k < 60; ++k) pen(from + Vec{0, 3}, 0.1 * k);
}

/// The strokes that the edits of a session change.
struct Touched {
  std::set<StrokeId> strokes;
  void operator()(const Edit& edit) {
    EXPECT_TRUE(edit.layers.empty());
    for (const StrokeChange& c : edit.changes) strokes.insert(c.id);
  }
};

TEST(Locality, AnEditAmongAHundredThousandStrokesLeavesAllOthersAsTheyAre) {
  Touched touched;
  SessionOptions options;
  options.device = {.max_force_n = 3.3, .continuous_force_n = 0.0, .max_stiffness_n_per_m = 0.0};
  options.document = large_document();
  options.on_edit = std::ref(touched);
  Session session(make_tools(), std::move(options));
  std::int64_t now_ns = 0;
  std::size_t edits = 0;
  for (const auto& tool : session.tools()) {
    const std::string id(tool->info().id);
    SCOPED_TRACE(id);
    ASSERT_TRUE(session.apply({now_ns, SelectTool{id}}));
    const Strokes before = strokes_of(session.document());
    const std::vector<StrokeId> order = session.document().layers()[0].strokes;
    touched.strokes.clear();
    gesture(session, 50'000, now_ns);
    if (HasFatalFailure()) return;
    edits += touched.strokes.empty() ? 0 : 1;
    EXPECT_LE(touched.strokes.size(), 4u);
    const Strokes after = strokes_of(session.document());
    std::size_t moved = 0;
    for (const auto& [stroke, was] : before) {
      const auto now = after.find(stroke);
      const bool same = now != after.end() && now->second == was;
      if (!same && !touched.strokes.contains(stroke)) ++moved;
    }
    EXPECT_EQ(moved, 0u);
    // The order of all other strokes has not changed.
    std::vector<StrokeId> old_order = order, new_order = session.document().layers()[0].strokes;
    const auto is_touched = [&](StrokeId s) { return touched.strokes.contains(s); };
    std::erase_if(old_order, is_touched);
    std::erase_if(new_order, is_touched);
    EXPECT_TRUE(old_order == new_order);
    while (session.history().can_undo()) ASSERT_TRUE(session.apply({now_ns, UndoEvent{}}));
    EXPECT_TRUE(strokes_of(session.document()) == before) << "the very same strokes are back";
  }
  EXPECT_GT(edits, 0u);
}

}  // namespace
}  // namespace felt::locality_test
