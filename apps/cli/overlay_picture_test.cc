#include "apps/cli/overlay_picture.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "felt/document/visible_strokes.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/tools/tool.h"

namespace felt::cli::overlay_picture_test {
namespace {

using Role = Overlay::Role;
constexpr std::array kRoles{Role::kReach,    Role::kSnap,   Role::kTether,
                            Role::kGuide,    Role::kSpan,   Role::kVector,
                            Role::kSelected, Role::kHandle, Role::kCut};

/// A view of 100 x 100 mm with 2 pixels per mm.
PictureOptions small_area() {
  PictureOptions options;
  options.dpi = 50.8;
  options.area = Rect{0.0, 0.0, 100.0, 100.0};
  return options;
}

Image drawn(const SessionView& view) {
  Result<Image> image = draw_view(view, small_area(), 3.0);
  EXPECT_TRUE(image) << image.error().message;
  return *std::move(image);
}

Rgba at(const Image& image, double x_mm, double y_mm) {
  return image.at(static_cast<int>(2.0 * x_mm), static_cast<int>(2.0 * y_mm));
}

int away_from(Rgba a, Rgba b) {
  return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
}

TEST(OverlayPicture, RolesThatMeetInAToolLookDifferent) {
  for (const Role role : kRoles) EXPECT_EQ(role_color(role).a, 255);
  const std::array<std::pair<Role, Role>, 6> meet{{{Role::kReach, Role::kSnap},
                                                   {Role::kSpan, Role::kVector},
                                                   {Role::kSpan, Role::kCut},
                                                   {Role::kSelected, Role::kTether},
                                                   {Role::kSelected, Role::kHandle},
                                                   {Role::kReach, Role::kVector}}};
  for (const auto& [a, b] : meet) EXPECT_GT(away_from(role_color(a), role_color(b)), 90);
}

TEST(OverlayPicture, ARingIsWhereItIsInItsColour) {
  SessionView view;
  view.overlay.rings.push_back({{50.0, 40.0}, 20.0, Role::kSnap});
  const Image image = drawn(view);
  for (const double angle : {0.0, 1.0, 2.5, 4.0}) {
    const Rgba seen = at(image, 50.0 + 20.0 * std::cos(angle), 40.0 + 20.0 * std::sin(angle));
    EXPECT_LT(away_from(seen, role_color(Role::kSnap)), 200) << angle;
  }
  EXPECT_EQ(at(image, 50.0, 40.0), (Rgba{255, 255, 255, 255}));
  EXPECT_EQ(at(image, 50.0, 90.0), (Rgba{255, 255, 255, 255}));
}

TEST(OverlayPicture, TheSvgShowsTheSame) {
  SessionView view;
  const Stroke line = testing::straight_stroke({10.0, 50.0}, {90.0, 50.0}, 2.0, 2.0);
  view.document = document_of(std::array{std::make_shared<const Stroke>(line)});
  add_span(view.overlay, line, 0.0, 0.5, Role::kSpan);
  view.overlay.rings.push_back({{50.0, 40.0}, 20.0, Role::kReach});
  view.overlay.labels.push_back({{20.0, 20.0}, "7 < 8 & 30\u00b0"});
  view.overlay.labels.push_back({{20.0, 120.0}, "outside"});
  const Result<std::string> svg = view_svg(view, small_area(), 3.0);
  ASSERT_TRUE(svg) << svg.error().message;
  const auto at = [&svg](const char* part) { return svg->find(part); };
  EXPECT_NE(at("viewBox=\"0 0 100 100\""), std::string::npos);
  const std::size_t band = at("<polyline"), ink = at("<path d="), ring = at("stroke-dasharray");
  EXPECT_TRUE(band < ink && ink < ring && ring != std::string::npos) << *svg;
  EXPECT_NE(at(">7 &lt; 8 &amp; 30 deg</text>"), std::string::npos);
  EXPECT_EQ(at("outside"), std::string::npos);
  // 150 / 25.4 / 3 units are one mm, so the ring begins 70 mm to the right.
  EXPECT_NE(at("137.80,78.74 "), std::string::npos);
}

TEST(OverlayPicture, MarkedSpansLieBelowTheInk) {
  SessionView view;
  const Stroke line = testing::straight_stroke({10.0, 50.0}, {90.0, 50.0}, 2.0, 2.0);
  view.document = document_of(std::array{std::make_shared<const Stroke>(line)});
  add_span(view.overlay, line, 0.0, 0.5, Role::kSpan);
  const Image image = drawn(view);
  EXPECT_EQ(at(image, 30.0, 50.0), (Rgba{0, 0, 0, 255}));
  EXPECT_LT(at(image, 30.0, 51.5).r, 220) << "a band beside the ink";
  EXPECT_EQ(at(image, 70.0, 51.5), (Rgba{255, 255, 255, 255}));
}

TEST(OverlayPicture, ADegreeSignIsSpelledOut) {
  SessionView sign, spelled, other;
  sign.overlay.labels.push_back({{20.0, 50.0}, "30\u00b0"});
  spelled.overlay.labels.push_back({{20.0, 50.0}, "30 deg"});
  other.overlay.labels.push_back({{20.0, 50.0}, "31 deg"});
  EXPECT_EQ(drawn(sign), drawn(spelled));
  EXPECT_FALSE(drawn(spelled) == drawn(other));
}

TEST(OverlayPicture, ALabelIsSeenWholeOrNotAtAll) {
  const Image empty = drawn({});
  for (const Point place : {Point{101.0, 50.0}, Point{-1.0, 50.0}, Point{50.0, 104.0}}) {
    SessionView view;
    view.overlay.labels.push_back({place, "7 lines"});
    EXPECT_EQ(drawn(view), empty) << place.x << ", " << place.y;
  }
  SessionView view;
  view.overlay.labels.push_back({{99.0, 50.0}, "7 lines"});
  const Image image = drawn(view);
  EXPECT_FALSE(image == empty);
  for (int y = 0; y < image.height(); ++y) {
    EXPECT_EQ(image.at(image.width() - 1, y), (Rgba{255, 255, 255, 255})) << y;
  }
}

TEST(OverlayPicture, ShapesBeyondTheAreaNeitherHangNorShow) {
  SessionView view;
  const Image empty = drawn(view);
  for (const Role role : kRoles) {
    view.overlay.rings.push_back({{50.0, 50.0}, 1e9, role});
    view.overlay.lines.push_back({{-1e12, 5.0}, {-1e13, 5.0}, role});
    view.overlay.outlines.push_back({{{1e9, 1e9}, {2e9, 1e9}, {2e9, 2e9}}, true, role});
    view.overlay.dots.push_back({{std::nan(""), 0.0}, role});
  }
  view.overlay.labels.push_back({{1e9, -1e9}, "far"});
  EXPECT_EQ(drawn(view), empty);
}

TEST(OverlayPicture, AGestureInWorkIsSeen) {
  Session session(make_tools(), {.device = {}});
  for (int i = 0; i <= 60; ++i) {
    PenSample sample;
    sample.time_ns = i * 5'000'000;
    sample.position = {20.0 + i, 50.0, i == 0 ? 3.0 : -1.0};
    ASSERT_TRUE(session.sample(sample));
  }
  const SessionView view = view_of(session, Point{80.0, 50.0});
  EXPECT_EQ(view.document.stroke_count(), 0U);
  EXPECT_FALSE(view.overlay.ink.empty());
  EXPECT_TRUE(bounds_of(view).contains({80.0, 50.0}));
  const Image image = drawn(view);
  EXPECT_LT(at(image, 50.0, 50.0).r, 60) << "wet ink";
  EXPECT_LT(at(image, 80.0, 50.0).r, 120) << "the pen";
  EXPECT_TRUE(session.finish());
  EXPECT_EQ(view_of(session, {}).document.stroke_count(), 1U);
}

TEST(OverlayPicture, APreviewIsWhatIsSeen) {
  // Uses any tool with a preview during a gesture at the end of a line: the view must contain it.
  Session session(make_tools(), {.device = {},
                                 .document = document_of(std::array{std::make_shared<const Stroke>(
                                     testing::straight_stroke({20, 50}, {80, 50}, 1, 1))})});
  bool found = false;
  for (const auto& tool : session.tools()) {
    ASSERT_TRUE(session.apply({0, SelectTool{std::string(tool->info().id)}}));
    for (int i = 0; i <= 40 && !found; ++i) {
      PenSample sample;
      sample.time_ns = i * 5'000'000;
      sample.position = {80.0, 50.0 + 0.2 * i, i == 0 ? 3.0 : -1.0};
      ASSERT_TRUE(session.sample(sample));
      if (!session.preview() || session.preview()->changes.empty()) continue;
      const StrokePtr after = session.preview()->changes.front().after;
      const auto seen = visible_strokes(view_of(session, {}).document);
      found = after && !seen.empty() && *seen.front() == *after;
      EXPECT_TRUE(found) << tool->info().id;
    }
    ASSERT_TRUE(session.apply({0, CancelEvent{}}));
    if (found) break;
  }
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace felt::cli::overlay_picture_test
