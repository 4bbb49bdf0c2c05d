#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace felt {

/// A table of costs: `rows` times `columns` finite numbers, row by row.
struct CostTable {
  std::size_t rows = 0, columns = 0;
  std::vector<float> costs{};

  [[nodiscard]] float& at(std::size_t row, std::size_t column) noexcept {
    return costs[row * columns + column];
  }
  [[nodiscard]] float at(std::size_t row, std::size_t column) const noexcept {
    return costs[row * columns + column];
  }
};

/// Marks a row without a column in an assignment.
inline constexpr std::int32_t kUnassigned = -1;

/// Assigns rows to columns, each at most once, so that the sum of the costs is minimal, and returns
/// the column of each row. A pair that would cost `limit` or more stays unassigned; this is the
/// same as paying limit / 2 for each row and each column without a partner.
///
/// Pairs below the limit divide the table into independent blocks. Each block is solved by shortest
/// augmenting paths: Jonker and Volgenant, "A shortest augmenting path algorithm for dense and
/// sparse linear assignment problems", 1987, doi:10.1007/BF02278710, in the form for rectangular
/// tables of Crouse, "On implementing 2D rectangular assignment algorithms", 2016,
/// doi:10.1109/TAES.2016.140952. Takes at most cubic time in the size of the largest block.
/// Equal tables give equal assignments.
std::vector<std::int32_t> min_cost_assignment(const CostTable& table, float limit);

}  // namespace felt
