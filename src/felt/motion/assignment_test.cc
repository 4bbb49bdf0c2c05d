#include "felt/motion/assignment.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "felt/base/random.h"

namespace felt::assignment_test {
namespace {

CostTable random_table(std::size_t rows, std::size_t columns, std::uint64_t seed, int values) {
  Random random(seed);
  CostTable table{rows, columns, {}};
  for (std::size_t i = 0; i < rows * columns; ++i) {
    // Few different values give many equal costs.
    table.costs.push_back(static_cast<float>(std::floor(random.between(0.0, values))) /
                          static_cast<float>(values));
  }
  return table;
}

double cost_of(const CostTable& table, const std::vector<std::int32_t>& columns, double limit) {
  double sum = 0.0;
  for (std::size_t r = 0; r < table.rows; ++r) {
    if (columns[r] != kUnassigned) {
      sum += static_cast<double>(table.at(r, static_cast<std::size_t>(columns[r]))) - limit;
    }
  }
  return sum;
}

/// Returns the least cost by trying everything.
double least_cost(const CostTable& table, double limit, std::size_t row, std::vector<bool>& used) {
  if (row == table.rows) return 0.0;
  double best = least_cost(table, limit, row + 1, used);
  for (std::size_t c = 0; c < table.columns; ++c) {
    if (used[c]) continue;
    used[c] = true;
    best = std::min(best, static_cast<double>(table.at(row, c)) - limit +
                              least_cost(table, limit, row + 1, used));
    used[c] = false;
  }
  return best;
}

RC_GTEST_PROP(Assignment, CostsAsLittleAsTheBestOfAllAssignments, ()) {
  const auto rows = *rc::gen::inRange<std::size_t>(0, 6),
             columns = *rc::gen::inRange<std::size_t>(0, 6);
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const int values = *rc::gen::element(3, 10, 100000);
  const CostTable table = random_table(rows, columns, seed, values);
  const float limit = *rc::gen::element(0.2F, 0.5F, 2.0F);
  const auto assigned = min_cost_assignment(table, limit);
  RC_ASSERT(assigned.size() == rows);
  std::vector<bool> used(columns, false);
  for (std::size_t r = 0; r < rows; ++r) {
    if (assigned[r] == kUnassigned) continue;
    const auto column = static_cast<std::size_t>(assigned[r]);
    RC_ASSERT(!used[column]);
    RC_ASSERT(table.at(r, column) < limit);
    used[column] = true;
  }
  std::vector<bool> none(columns, false);
  const double best = least_cost(table, static_cast<double>(limit), 0, none);
  RC_ASSERT(std::fabs(cost_of(table, assigned, static_cast<double>(limit)) - best) < 1e-5);
}

TEST(Assignment, SolvesALargeTable) {
  const CostTable table = random_table(300, 310, 5, 1000000);
  const auto assigned = min_cost_assignment(table, 2.0F);
  EXPECT_EQ(std::count(assigned.begin(), assigned.end(), kUnassigned), 0);
  EXPECT_LT(cost_of(table, assigned, 0.0), 3.0);  // random: about 1.6 for any number of rows
}

}  // namespace
}  // namespace felt::assignment_test
