#include "felt/motion/inbetween.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "felt/document/edit_builder.h"
#include "felt/document/fill.h"
#include "felt/motion/testing/made_drawings.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::inbetween_test {
namespace {

using testing::drawing_of;
using testing::made_strokes;
using testing::moved_strokes;
using testing::straight_stroke;

StrokePtr line(Point a, Point b, Rgba color = {}) {
  StrokeData data = straight_stroke(a, b, 0.5, 0.5).data();
  data.color = color;
  return std::make_shared<const Stroke>(Stroke::create(std::move(data)).value());
}

Inbetween motion_of(const Drawing& a, const Drawing& b, const InbetweenOptions& options = {}) {
  Result<Inbetween> motion = Inbetween::create(a, b, options);
  EXPECT_TRUE(motion) << (motion ? "" : motion.error().message);
  return *std::move(motion);
}

TEST(Inbetween, IsTheKeysAtBothEnds) {
  const Drawing a = drawing_of(made_strokes(12, 1)), b = drawing_of(made_strokes(9, 2));
  const Inbetween motion = motion_of(a, b);
  EXPECT_EQ(motion.at(0.0), a);
  EXPECT_EQ(motion.at(1.0), b);
  EXPECT_EQ(motion.at(-5.0), a);
  EXPECT_EQ(motion.at(std::nan("")), a);
  EXPECT_EQ(motion.at(7.0), b);
}

TEST(Inbetween, KeepsTheNamesOfStrokes) {
  const auto same = made_strokes(6, 3);
  std::vector<StrokePtr> more = same;
  more.push_back(line({150, 0}, {160, 90}));
  Drawing a = drawing_of(same), b = drawing_of(more);
  const std::vector<StrokeId>& of_a = a.document.layers().front().strokes;
  const std::vector<StrokeId>& of_b = b.document.layers().front().strokes;
  a.names = std::make_shared<const StrokeNames>(
      StrokeNames{{of_a[0], "ear"}, {of_a[4], "tail"}, {of_a[5], "s3"}});
  b.names = std::make_shared<const StrokeNames>(
      StrokeNames{{of_b[0], "left ear"}, {of_b[6], "whisker"}, {of_b[1], "tail"}});
  const Inbetween motion = motion_of(a, b);
  for (const double t : {0.25, 0.5}) {
    std::vector<std::string> names;
    for (const auto& [id, name] : used_names(motion.at(t))) names.push_back(name);
    std::sort(names.begin(), names.end());
    EXPECT_EQ(names, (std::vector<std::string>{"ear", "tail", "whisker"})) << "one each";
  }
  EXPECT_EQ(motion_of(drawing_of(same), drawing_of(more)).at(0.5).names, nullptr);
}

TEST(Inbetween, ComesCloseToTheKeys) {
  const auto from = made_strokes(25, 4);
  const auto to = moved_strokes(from, {{100, 100}, {130, 110}, 0.8, 1.2}, 1.0, 5);
  const Inbetween motion = motion_of(drawing_of(from), drawing_of(to));
  for (const bool is_end : {false, true}) {
    const auto near = motion.strokes_at(is_end ? 1.0 - 1e-9 : 1e-9);
    const auto& key = is_end ? to : from;
    ASSERT_EQ(near.size(), key.size());
    for (std::size_t i = 0; i < key.size(); ++i) {
      EXPECT_LT(distance(near[i]->position(0.0), key[i]->position(0.0)), 1e-5);
      EXPECT_LT(distance(near[i]->position(1e9), key[i]->position(1e9)), 1e-5);
    }
  }
}

TEST(Inbetween, GivesTheSameBytesEveryTime) {
  const Drawing a = drawing_of(made_strokes(20, 6)), b = drawing_of(made_strokes(22, 7));
  const Inbetween one = motion_of(a, b), two = motion_of(a, b);
  for (const double t : {0.1, 0.5, 0.9}) EXPECT_EQ(one.at(t), two.at(t));
}

TEST(Inbetween, ADrawingThatDoesNotChangeStaysWhereItIs) {
  const auto strokes = made_strokes(20, 9);
  const Inbetween motion = motion_of(drawing_of(strokes), drawing_of(strokes));
  const auto between = motion.strokes_at(0.37);
  ASSERT_EQ(between.size(), strokes.size());
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    for (const double share : {0.0, 0.3, 1.0}) {
      EXPECT_LT(distance(between[i]->position(share * between[i]->segment_count()),
                         strokes[i]->position(share * strokes[i]->segment_count())),
                0.5 * (share == 0.3) + 1e-6);
    }
  }
}

TEST(Inbetween, EveryStrokeBetweenIsValid) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    std::vector<StrokePtr> a, b;
    for (std::uint64_t i = 0; i < 6; ++i) {
      a.push_back(std::make_shared<const Stroke>(testing::random_stroke(seed * 40 + i)));
      if (i < 5)
        b.push_back(std::make_shared<const Stroke>(testing::random_stroke(seed * 40 + 20 + i)));
    }
    InbetweenOptions options;
    if (seed % 2 == 1) options.lone = LoneStroke::kGrow;
    const Inbetween motion = motion_of(drawing_of(a), drawing_of(b), options);
    for (const double t : {1e-7, 0.01, 0.25, 0.5, 0.75, 0.99, 1.0 - 1e-7}) {
      const auto strokes = motion.strokes_at(t);
      EXPECT_GE(strokes.size(), 4U);
      for (const StrokePtr& s : strokes) EXPECT_TRUE(check_invariants(s->data()));
    }
  }
}

TEST(Inbetween, LoneStrokesFadeOrGrow) {
  const Drawing nothing, one = drawing_of({line({10, 10}, {50, 10})});
  const Inbetween fades = motion_of(nothing, one);
  ASSERT_EQ(fades.strokes_at(0.25).size(), 1U);
  EXPECT_EQ(fades.strokes_at(0.25)[0]->color().a, 64);
  EXPECT_TRUE(fades.strokes_at(0.001).empty()) << "invisible";
  EXPECT_EQ(motion_of(one, nothing).strokes_at(0.25)[0]->color().a, 191);
  const Inbetween grows = motion_of(nothing, one, {{}, LoneStroke::kGrow});
  const StrokePtr part = grows.strokes_at(0.25)[0];
  EXPECT_EQ(part->color().a, 255);
  EXPECT_LT(distance(part->position(0.0), {10, 10}), 1e-6);
  EXPECT_LT(distance(part->position(1e9), {20, 10}), 1e-3);
  EXPECT_TRUE(motion_of(nothing, nothing).strokes_at(0.5).empty());
}

TEST(Inbetween, EndsThatTouchStayTogether) {
  // A triangle of three lines that turns, a line from its first corner, and one on its first side.
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto triangle = [&](double turn_rad, Point at) {
      const Similarity motion{{0, 0}, at, turn_rad, 1.0};
      const double apex = random.between(20.0, 40.0);
      const Point p = moved(motion, Point{0, 0}), q = moved(motion, Point{40, 0}),
                  r = moved(motion, Point{15, apex}), far = moved(motion, Point{-30, -5});
      const Point on = lerp(p, q, random.between(0.4, 0.6)), up = moved(motion, Point{20, -20});
      return drawing_of({line(p, q), line(q, r), line(r, p), line(p, far), line(on, up)});
    };
    const Drawing a = triangle(0.0, {60, 60}), b = triangle(random.between(-1.0, 1.0), {90, 70});
    const Inbetween motion = motion_of(a, b, {{{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}}});
    for (const double t : {0.2, 0.5, 0.8}) {
      const auto s = motion.strokes_at(t);
      ASSERT_EQ(s.size(), 5U);
      const auto start = [&](std::size_t i) { return s[i]->position(0.0); };
      const auto end = [&](std::size_t i) { return s[i]->position(1e9); };
      EXPECT_LT(distance(end(0), start(1)), 1e-6);
      EXPECT_LT(distance(end(1), start(2)), 1e-6);
      EXPECT_LT(distance(end(2), start(0)), 1e-6);
      EXPECT_LT(distance(start(3), start(0)), 1e-6);
      const Vec side = end(0) - start(0);
      EXPECT_LT(std::fabs(cross(side, start(4) - start(0))) / norm(side), 1e-6);
    }
  }
}

TEST(Inbetween, KeepsLayersGuidesAndPageOfTheFirstKey) {
  Drawing a = drawing_of({line({10, 10}, {50, 10})});
  a.page.width_mm = 123.0;
  const LayerId top{7};
  Edit edit{"Layers", {}};
  edit.layers.push_back({top, std::nullopt, LayerState{"Top"}, 0, 1});
  edit.layers.push_back({LayerId{8}, std::nullopt, LayerState{"Hidden", false}, 0, 2});
  edit.changes.push_back({StrokeId{50}, nullptr, line({10, 40}, {50, 40}), {}, {top, 0}});
  edit.changes.push_back({StrokeId{51}, nullptr, line({10, 60}, {50, 60}), {}, {LayerId{8}, 0}});
  ASSERT_TRUE(a.document.apply(edit));
  Drawing b = a;
  EditBuilder more(b.document);
  more.add(top, line({80, 90}, {85, 140}));
  ASSERT_TRUE(b.document.apply(std::move(more).build("More")));
  const Drawing between = motion_of(a, b).at(0.5);
  EXPECT_EQ(between.page.width_mm, 123.0);
  const auto layers = between.document.layers();
  ASSERT_EQ(layers.size(), 3U);
  EXPECT_EQ(layers[1].name, "Top");
  EXPECT_EQ(layers[0].strokes.size(), 1U);
  EXPECT_EQ(layers[1].strokes.size(), 2U);
  EXPECT_FALSE(layers[2].visible);
  EXPECT_TRUE(layers[2].strokes.empty());
}

TEST(Inbetween, FillsFadeOver) {
  Drawing a = drawing_of({line({10, 10}, {50, 10})});
  const Drawing b = a;
  FillLoop loop;
  for (const Point p :
       {Point{0, 0}, {3, 0}, {6, 0}, {9, 0}, {9, 3}, {9, 6}, {9, 9}, {6, 6}, {3, 3}, {0, 0}}) {
    loop.points.push_back(p);
  }
  EditBuilder edit(a.document);
  edit.add_fill(a.document.layers().front().id,
                std::make_shared<const Fill>(Fill{{loop}, {200, 0, 0, 200}, 0.0}));
  ASSERT_TRUE(a.document.apply(std::move(edit).build("Fill")));
  const Drawing between = motion_of(a, b).at(0.75);
  ASSERT_EQ(between.document.fill_count(), 1U);
  const FillId id = between.document.layers().front().fills.front();
  EXPECT_EQ(between.document.find_fill(id)->color.a, 50);
  EXPECT_TRUE(check_fill(*between.document.find_fill(id)));
}

TEST(Inbetween, TwoThousandStrokes) {
  const auto from = made_strokes(2000, 11);
  const auto to = moved_strokes(from, {{100, 100}, {110, 105}, 0.1, 1.0}, 0.2, 12);
  const Inbetween motion = motion_of(drawing_of(from), drawing_of(to));
  std::size_t right = 0;
  for (const StrokeMatch& m : motion.correspondence().matches) right += m.from == m.to ? 1 : 0;
  EXPECT_GE(right, 1900U);
  EXPECT_GE(motion.strokes_at(0.5).size(), 2000U);
}

}  // namespace
}  // namespace felt::inbetween_test
