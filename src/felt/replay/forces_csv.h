#pragma once

#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/rt/servo.h"

namespace felt {

/// A table of forces: a header, then a row per tick, with numbers in the shortest form that reads
/// back as the same double:
///
///   t_ms,x,y,z,vx,vy,vz,pressure,ask_x,ask_y,ask_z,sent_x,sent_y,sent_z,plane_x,plane_y,plane_z,..
///
/// in ms, mm, mm/s and N. After the fixed columns, each force term that occurs has three columns,
/// in order of first occurrence; they are 0 on ticks without the term. `pressure` is empty if it is
/// unknown.
///
/// Which terms occur is known only at the end. Until then the rows are in an unnamed temporary
/// file, so that memory use does not grow with the number of ticks.
class ForcesCsv {
 public:
  using Write = std::function<Result<void>(std::string_view bytes)>;

  /// Fails if no temporary file can be created.
  static Result<ForcesCsv> create();

  /// Adds a tick. `pressure` 0..1 determines the width.
  Result<void> add(const TickReport& tick, std::optional<double> pressure);
  /// Writes the whole table, a piece at a time. Call once.
  Result<void> finish(const Write& write);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  /// From this row on, rows have columns for the first `terms` names.
  struct Growth {
    std::int64_t row;
    std::size_t terms;
  };

  ForcesCsv() = default;
  std::size_t group_of(std::string_view name);
  Result<void> spool();
  /// Returns the text that a row needs at its end to be as wide as the header.
  [[nodiscard]] std::string padding_of(std::int64_t row) const;
  /// Appends a piece of the rows, padded. `row` is the number of the row in which it begins.
  void pad_rows(std::span<const char> bytes, std::int64_t& row, std::string& text) const;
  Result<void> copy_rows(const Write& write);

  std::unique_ptr<std::FILE, Close> spool_;
  std::string rows_;                // the rows that are not yet in the temporary file
  std::vector<std::string> names_;  // names of the terms, by group
  std::vector<Force> forces_;       // forces of this row, by group
  std::vector<Growth> growth_;
  std::int64_t row_count_ = 0;
};

}  // namespace felt
