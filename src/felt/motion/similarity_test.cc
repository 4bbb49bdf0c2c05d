#include "felt/motion/similarity.h"

#include <gtest/gtest.h>

#include <vector>

#include "felt/base/random.h"

namespace felt::similarity_test {
namespace {

Similarity random_similarity(Random& random) {
  const auto place = [&] { return Point{random.between(0.0, 200.0), random.between(0.0, 200.0)}; };
  const Point from = place(), to = place();
  return {from, to, random.between(-3.0, 3.0), random.between(0.4, 2.5)};
}

TEST(Similarity, GoesAndComesBack) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Similarity motion = random_similarity(random);
    const Point a{random.between(0.0, 200.0), 7.0}, b{3.0, random.between(0.0, 200.0)};
    EXPECT_LT(distance(moved_back(motion, moved(motion, a)), a), 1e-10);
    EXPECT_LT(distance(carried(motion, a, b, 0.0), a), 1e-10);
    EXPECT_LT(distance(carried(motion, a, b, 1.0), b), 1e-10);
    EXPECT_LT(distance(moved(motion, a, 0.0), a), 1e-10);
  }
}

TEST(Similarity, IsFittedDespitePointsThatMoveOnTheirOwn) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Similarity motion = random_similarity(random);
    std::vector<PointPair> pairs;
    for (int i = 0; i < 40; ++i) {
      const Point from{random.between(0.0, 100.0), random.between(0.0, 100.0)};
      Point to = moved(motion, from) + Vec{0.01 * random.normal(), 0.01 * random.normal()};
      if (i % 4 == 0) to += Vec{random.between(10.0, 30.0), random.between(10.0, 30.0)};
      pairs.push_back({from, to});
    }
    const Similarity fit = fit_robust_similarity(pairs, *fit_similarity(pairs));
    for (const Point p : {Point{0.0, 0.0}, Point{100.0, 0.0}, Point{0.0, 100.0}}) {
      EXPECT_LT(distance(moved(fit, p), moved(motion, p)), 0.1);
    }
  }
}

TEST(Similarity, IsNotFittedToOnePlace) {
  const std::vector<PointPair> none, same{{{1, 1}, {2, 2}}, {{1, 1}, {3, 3}}};
  EXPECT_FALSE(fit_similarity(none));
  EXPECT_FALSE(fit_similarity(same));
}

}  // namespace
}  // namespace felt::similarity_test
