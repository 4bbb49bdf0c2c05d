#include "felt/tools/guide_picture.h"

#include <gtest/gtest.h>

#include "felt/document/testing/random_guides.h"

namespace felt::guide_picture_test {
namespace {

constexpr Rect kPage{0.0, 0.0, 210.0, 297.0};

TEST(GuidePicture, EveryKindIsSeenOnThePageAndBounded) {
  testing::RandomStroke random(2);
  Document document;
  std::vector<int> seen(kDrawingGuideKinds, 0);
  for (int i = 0; i < 400; ++i) {
    DrawingGuide guide = testing::random_guide(random);
    guide.origin = {random.uniform(10.0, 200.0), random.uniform(10.0, 280.0)};
    Overlay overlay;
    add_guide_picture(overlay, guide, document, kPage);
    const std::size_t marks = overlay.lines.size() + overlay.rings.size() + overlay.outlines.size();
    EXPECT_LE(marks, 3U * kMaxGuideLines);
    if (marks > 0) ++seen[static_cast<std::size_t>(guide.kind)];
  }
  for (std::size_t kind = 0; kind < kDrawingGuideKinds; ++kind) {
    if (kind == static_cast<std::size_t>(DrawingGuideKind::kTrace)) continue;  // no such stroke
    EXPECT_GT(seen[kind], 0) << guide_kind_name(static_cast<DrawingGuideKind>(kind));
  }
}

TEST(GuidePicture, AGridKeepsToThePageAndAFineOneStaysDrawable) {
  DrawingGuide grid{DrawingGuideKind::kGrid, {3, 4}, 0.3};
  for (const double spacing_mm : {0.5, 5.0, 1e5}) {
    grid.size_mm = spacing_mm;
    Overlay overlay;
    add_guide_picture(overlay, grid, {}, kPage);
    EXPECT_LE(overlay.lines.size(), 2U * kMaxGuideLines);
    for (const Overlay::Line& line : overlay.lines) {
      for (const Point p : {line.from, line.to}) {
        EXPECT_TRUE(kPage.inflated(1e-6).contains(p)) << p.x << ", " << p.y;
      }
    }
  }
}

TEST(GuidePicture, APreviewReplacesWhatItChanges) {
  Document document;
  const auto line =
      std::make_shared<const DrawingGuide>(DrawingGuide{DrawingGuideKind::kLine, {50, 50}, 0.0});
  Edit add;
  add.guides.push_back({{1}, nullptr, line});
  ASSERT_TRUE(document.apply(add));
  Edit remove;
  remove.guides.push_back({{1}, line, nullptr});
  Edit hide;
  hide.toggles_guides = true;
  Overlay shown, removed, hidden;
  add_guide_pictures(shown, document, nullptr, kPage);
  add_guide_pictures(removed, document, &remove, kPage);
  add_guide_pictures(hidden, document, &hide, kPage);
  EXPECT_EQ(shown.lines.size(), 1U);
  EXPECT_TRUE(removed.lines.empty());
  EXPECT_TRUE(hidden.lines.empty());
}

TEST(GuidePicture, ASymmetryOfNAxesShowsTheInkAtAllOtherImages) {
  Overlay overlay;
  DrawingGuide symmetry{DrawingGuideKind::kSymmetry};
  symmetry.axes = 3;
  add_ink_images(overlay, symmetry);
  EXPECT_EQ(overlay.ink_images.size(), 5U);
  overlay.clear();
  EXPECT_TRUE(overlay.ink_images.empty());
}

}  // namespace
}  // namespace felt::guide_picture_test
