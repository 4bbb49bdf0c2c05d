#include "felt/motion/assignment.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

namespace felt {
namespace {

/// Solves one block of a table: some of its rows and columns, with at most as many rows as columns.
/// The duals and paths are those of Crouse 2016, algorithm 3.
class BlockSolver {
 public:
  BlockSolver(std::size_t rows, std::size_t columns, std::vector<float> costs)
      : rows_(rows),
        columns_(columns),
        costs_(std::move(costs)),
        row_dual_(rows),
        column_dual_(columns),
        row_of_(columns, kUnassigned),
        column_of_(rows, kUnassigned) {}

  std::vector<std::int32_t> solve() {
    for (std::size_t row = 0; row < rows_; ++row) augment(static_cast<std::int32_t>(row));
    return column_of_;
  }

 private:
  void augment(std::int32_t start) {
    shortest_.assign(columns_, std::numeric_limits<double>::infinity());
    from_.assign(columns_, kUnassigned);
    open_.resize(columns_);
    std::iota(open_.begin(), open_.end(), 0);
    closed_.clear();
    std::int32_t row = start, sink = kUnassigned;
    double least = 0.0;
    while (sink == kUnassigned) {
      const std::size_t next = relax(row, least);
      least = shortest_[static_cast<std::size_t>(open_[next])];
      const std::int32_t column = open_[next];
      if (row_of_[static_cast<std::size_t>(column)] == kUnassigned) sink = column;
      closed_.push_back(column);
      row = row_of_[static_cast<std::size_t>(column)];
      open_[next] = open_.back();
      open_.pop_back();
    }
    update_duals(start, least);
    flip(start, sink);
  }

  /// Shortens the paths to the open columns through `row`; returns the place of the nearest of
  /// them, if possible one without a row.
  std::size_t relax(std::int32_t row, double least) {
    const auto r = static_cast<std::size_t>(row);
    std::size_t best = 0;
    double best_length = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < open_.size(); ++k) {
      const auto c = static_cast<std::size_t>(open_[k]);
      const double length =
          least + static_cast<double>(costs_[r * columns_ + c]) - row_dual_[r] - column_dual_[c];
      if (length < shortest_[c]) {
        shortest_[c] = length;
        from_[c] = row;
      }
      const bool is_free = shortest_[c] == best_length && row_of_[c] == kUnassigned;
      if (shortest_[c] < best_length || is_free) {
        best_length = shortest_[c];
        best = k;
      }
    }
    return best;
  }

  void update_duals(std::int32_t start, double least) {
    row_dual_[static_cast<std::size_t>(start)] += least;
    for (const std::int32_t column : closed_) {
      const auto c = static_cast<std::size_t>(column);
      const double by = least - shortest_[c];
      if (row_of_[c] != kUnassigned) row_dual_[static_cast<std::size_t>(row_of_[c])] += by;
      column_dual_[c] -= by;
    }
  }

  void flip(std::int32_t start, std::int32_t sink) {
    for (std::int32_t column = sink;;) {
      const std::int32_t row = from_[static_cast<std::size_t>(column)];
      row_of_[static_cast<std::size_t>(column)] = row;
      std::swap(column_of_[static_cast<std::size_t>(row)], column);
      if (row == start) return;
    }
  }

  std::size_t rows_, columns_;
  std::vector<float> costs_;
  std::vector<double> row_dual_, column_dual_, shortest_;
  std::vector<std::int32_t> row_of_, column_of_, from_, open_, closed_;
};

/// Sets of rows (0 to rows - 1) and columns (from `rows` on) that are linked by pairs below the
/// limit.
class Blocks {
 public:
  Blocks(const CostTable& table, float limit) : parent_(table.rows + table.columns) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    for (std::size_t r = 0; r < table.rows; ++r) {
      for (std::size_t c = 0; c < table.columns; ++c) {
        if (table.at(r, c) < limit) join(r, table.rows + c);
      }
    }
  }
  std::size_t find(std::size_t i) noexcept {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

 private:
  void join(std::size_t a, std::size_t b) noexcept {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  std::vector<std::size_t> parent_;
};

void solve_block(const CostTable& table, float limit, std::span<const std::size_t> rows,
                 std::span<const std::size_t> columns, std::vector<std::int32_t>& result) {
  const bool turned = rows.size() > columns.size();
  const auto outer = turned ? columns : rows, inner = turned ? rows : columns;
  std::vector<float> costs;
  costs.reserve(outer.size() * inner.size());
  for (const std::size_t o : outer) {
    for (const std::size_t i : inner) {
      costs.push_back(std::min(turned ? table.at(i, o) : table.at(o, i), limit));
    }
  }
  const auto assigned = BlockSolver(outer.size(), inner.size(), std::move(costs)).solve();
  for (std::size_t k = 0; k < outer.size(); ++k) {
    const std::size_t partner = inner[static_cast<std::size_t>(assigned[k])];
    const std::size_t row = turned ? partner : outer[k], column = turned ? outer[k] : partner;
    if (table.at(row, column) < limit) result[row] = static_cast<std::int32_t>(column);
  }
}

}  // namespace

std::vector<std::int32_t> min_cost_assignment(const CostTable& table, float limit) {
  std::vector<std::int32_t> result(table.rows, kUnassigned);
  Blocks blocks(table, limit);
  std::vector<std::vector<std::size_t>> rows(table.rows), columns(table.rows);
  for (std::size_t r = 0; r < table.rows; ++r) rows[blocks.find(r)].push_back(r);
  for (std::size_t c = 0; c < table.columns; ++c) {
    const std::size_t block = blocks.find(table.rows + c);
    if (block < table.rows) columns[block].push_back(c);
  }
  for (std::size_t block = 0; block < table.rows; ++block) {
    if (columns[block].empty()) continue;
    solve_block(table, limit, rows[block], columns[block], result);
  }
  return result;
}

}  // namespace felt
