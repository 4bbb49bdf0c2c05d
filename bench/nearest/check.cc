#include <cmath>
#include <cstdio>
#include <random>

#include "felt/geometry/nearest.h"
#include "felt/geometry/testing/nearest_cases.h"
#include "rows.h"

namespace felt::bench {

std::size_t check(std::size_t cases) {
  constexpr int kSamples = 2000;
  std::size_t wrong = 0;
  std::printf("kind       cases    wrong  worst (mm)   most pieces\n");
  for (int k = 0; k < kCaseKinds; ++k) {
    const auto kind = static_cast<CaseKind>(k);
    const double size = kind == CaseKind::kTiny ? 1e-6 : 100.0;
    std::mt19937_64 random(static_cast<unsigned>(1000 + k));
    const std::size_t count = cases / kCaseKinds + (k < static_cast<int>(cases % kCaseKinds));
    std::size_t wrong_here = 0;
    double worst = 0.0;
    int max_pieces = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const NearestCase c = make_case(kind, random);
      int pieces_left = 1 << 20;
      const auto hit = nearest_within(c.curve, c.query, 1e300, pieces_left);
      const double truth = sampled_distance(c.curve, c.query, kSamples);
      const double excess = hit ? std::sqrt(hit->distance_squared) - truth : HUGE_VAL;
      // nearest.h documents 1e-12 of the size, plus 1e-14 of the distance of a far query.
      if (!(excess <= 1e-12 * size + 2e-14 * truth)) ++wrong_here;
      worst = std::max(worst, excess);
      max_pieces = std::max(max_pieces, (1 << 20) - pieces_left);
    }
    wrong += wrong_here;
    std::printf("%4d %11zu %8zu %11.3g %13d\n", k, count, wrong_here, worst, max_pieces);
    std::fflush(stdout);
  }
  std::printf("%zu wrong of %zu\n", wrong, cases);
  return wrong;
}

}  // namespace felt::bench
