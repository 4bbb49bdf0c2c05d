#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "felt/base/constants.h"
#include "felt/base/random.h"
#include "felt/devices/simulated/person.h"
#include "felt/devices/simulated/samples/sample_sets.h"
#include "felt/geometry/polyline.h"
#include "felt/motion/inbetween.h"
#include "felt/motion/stroke_matches.h"
#include "felt/motion/stroke_shape.h"
#include "tests/drawing/snapping/snap_count.h"

namespace felt::motion_redrawn_test {
namespace {

using Paths = std::vector<std::vector<HandSample>>;

constexpr std::size_t kPairs = 50, kStrokes = 24;

/// Returns neighbouring strokes of a sample set: a part of the cat or of the page.
Paths some_strokes(const std::vector<SampleSet>& sets, Random& random) {
  const SampleSet& set = sets[random.between(0.0, 1.0) < 0.5 ? 0 : 2];
  const auto last = static_cast<double>(set.strokes.size() - kStrokes);
  const auto first = static_cast<std::size_t>(random.between(0.0, last));
  Paths paths;
  for (std::size_t i = first; i < first + kStrokes; ++i) paths.push_back(set.strokes[i].samples);
  return paths;
}

std::string ndjson_of(const Paths& paths) {
  std::ostringstream out;
  for (const auto& path : paths) {
    out << "{\"points\":[";
    for (std::size_t i = 0; i < path.size(); ++i) {
      out << (i > 0 ? "," : "") << '[' << path[i].position.x << ',' << path[i].position.y << ','
          << path[i].pressure << ',' << 7.5 * static_cast<double>(i) << ']';
    }
    out << "]}\n";
  }
  return out.str();
}

/// A second drawing of the same strokes, and which of them is which.
struct Redrawing {
  Paths paths;
  /// The stroke of the first drawing that each path is a part of.
  std::vector<std::size_t> origins;
};

/// Moves the paths, splits one, leaves one out, reverses some and changes the order.
Redrawing redrawing_of(const Paths& paths, Random& random) {
  const double angle = random.between(-0.6, 0.6), scale = random.between(0.85, 1.2);
  const Vec shift{random.between(-30.0, 30.0), random.between(-30.0, 30.0)};
  const auto pick = [&] { return static_cast<std::size_t>(random.between(0.0, kStrokes)); };
  const std::size_t missing = pick();
  std::size_t divided = 0;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (i != missing && paths[i].size() > paths[divided].size()) divided = i;
  }
  Redrawing result;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (i == missing) continue;
    std::vector<HandSample> path = paths[i];
    const Vec own{0.4 * random.normal(), 0.4 * random.normal()};
    for (HandSample& sample : path) {
      const Vec v = sample.position - Point{100.0, 100.0};
      sample.position = Point{100.0, 100.0} + shift + own +
                        scale * Vec{std::cos(angle) * v.x - std::sin(angle) * v.y,
                                    std::sin(angle) * v.x + std::cos(angle) * v.y};
    }
    if (i == divided) {
      const auto middle = path.begin() + static_cast<std::ptrdiff_t>(path.size() / 2);
      result.paths.emplace_back(path.begin(), middle);
      result.origins.push_back(i);
      path.erase(path.begin(), middle);
    }
    if (random.between(0.0, 1.0) < 0.3) std::reverse(path.begin(), path.end());
    result.paths.push_back(std::move(path));
    result.origins.push_back(i);
  }
  // Half of the drawings are drawn in much the same order, the others in any order.
  const double range = random.between(0.0, 1.0) < 0.5 ? 2.0 : static_cast<double>(kStrokes);
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < result.paths.size(); ++i) {
    order.emplace_back(static_cast<double>(i) + random.between(0.0, range), i);
  }
  std::sort(order.begin(), order.end());
  Redrawing sorted;
  for (const auto& [key, i] : order) {
    sorted.paths.push_back(result.paths[i]);
    sorted.origins.push_back(result.origins[i]);
  }
  return sorted;
}

/// Returns the ink that a person draws along the paths.
std::vector<StrokePtr> drawn_by(const Person& person, const Paths& paths) {
  const auto count = snap_test::draw_lines(ndjson_of(paths), {.person = person}, "off");
  EXPECT_TRUE(count) << (count ? "" : count.error().message);
  std::vector<StrokePtr> strokes;
  for (const Stroke& stroke : count->ink) strokes.push_back(std::make_shared<const Stroke>(stroke));
  return strokes;
}

struct Score {
  std::size_t right = 0, all = 0;
};

/// Counts the strokes of both drawings whose partners are exactly the right ones.
Score score_of(const Correspondence& found, const Redrawing& redrawing) {
  std::map<std::size_t, std::set<std::size_t>> wanted, given, wanted_back, given_back;
  for (std::size_t k = 0; k < redrawing.origins.size(); ++k) {
    wanted[redrawing.origins[k]].insert(k);
    wanted_back[k].insert(redrawing.origins[k]);
  }
  for (const StrokeMatch& m : found.matches) {
    if (!m.from || !m.to) continue;
    given[*m.from].insert(*m.to);
    given_back[*m.to].insert(*m.from);
  }
  Score score{0, kStrokes + redrawing.origins.size()};
  for (std::size_t i = 0; i < kStrokes; ++i) score.right += wanted[i] == given[i] ? 1 : 0;
  for (std::size_t k = 0; k < redrawing.origins.size(); ++k) {
    score.right += wanted_back[k] == given_back[k] ? 1 : 0;
  }
  return score;
}

/// Counts in-between strokes that are flipped: far shorter than both strokes that they come from.
std::size_t collapsed(const Inbetween& motion, const std::vector<StrokePtr>& a,
                      const std::vector<StrokePtr>& b) {
  double shortest = 1e300;
  for (const auto& key : {a, b}) {
    double sum = 0.0;
    for (const StrokePtr& stroke : key) sum += shape_of(*stroke).length_mm;
    shortest = std::min(shortest, sum);
  }
  std::size_t count = 0;
  for (const double t : {0.25, 0.5, 0.75}) {
    double sum = 0.0;
    for (const StrokePtr& stroke : motion.strokes_at(t)) {
      EXPECT_TRUE(check_invariants(stroke->data()));
      sum += shape_of(*stroke).length_mm;
    }
    count += sum < 0.9 * shortest ? 1 : 0;
  }
  return count;
}

Drawing drawing_with(const std::vector<StrokePtr>& strokes) {
  Drawing drawing;
  Edit edit{"Draw", {}};
  const LayerId layer = drawing.document.layers().front().id;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    edit.changes.push_back({StrokeId{i + 1}, nullptr, strokes[i], {}, {layer, i}});
  }
  EXPECT_TRUE(drawing.document.apply(edit));
  return drawing;
}

// The bar: at least 95 % of the strokes of 50 drawings that people redrew, moved, turned, scaled,
// in other directions and in another order, with one stroke drawn as two and one left out.
TEST(MotionRedrawn, PeopleFindTheirStrokesAgain) {
  const std::vector<SampleSet> sets = make_sample_sets();
  Score total;
  std::size_t flat = 0, pairs = 0;
  for (std::uint64_t seed = 1; pairs < kPairs && seed < 2 * kPairs; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Paths first = some_strokes(sets, random);
    const Redrawing second = redrawing_of(first, random);
    const auto a = drawn_by(person_of(2 * seed), first);
    const auto b = drawn_by(person_of(2 * seed + 1), second.paths);
    // A hand that draws too lightly loses a stroke; then nobody knows which stroke is which.
    if (a.size() != first.size() || b.size() != second.paths.size()) continue;
    ++pairs;
    const Result<Inbetween> motion = Inbetween::create(drawing_with(a), drawing_with(b), {});
    ASSERT_TRUE(motion);
    const Score score = score_of(motion->correspondence(), second);
    std::printf("seed %2d: %zu of %zu strokes\n", static_cast<int>(seed), score.right, score.all);
    total.right += score.right;
    total.all += score.all;
    flat += collapsed(*motion, a, b);
  }
  ASSERT_EQ(pairs, kPairs);
  std::printf("all: %zu of %zu strokes, %.2f %%\n", total.right, total.all,
              100.0 * static_cast<double>(total.right) / static_cast<double>(total.all));
  EXPECT_GE(static_cast<double>(total.right), 0.95 * static_cast<double>(total.all));
  EXPECT_EQ(flat, 0U);
}

}  // namespace
}  // namespace felt::motion_redrawn_test
