#pragma once

#include <optional>
#include <string>
#include <utility>

#include "felt/replay/forces_csv.h"
#include "output.h"

namespace felt::cli {

/// Writes the file of `--forces`. The file gets its name when finish() succeeds, not before.
class ForcesFile {
 public:
  /// Creates the file. Fails if it cannot be written. The message begins with the name of the file.
  static Result<ForcesFile> create(const std::string& path) {
    Result<Output> output = Output::create(path);
    if (!output) return tl::unexpected(output.error());
    Result<ForcesCsv> csv = ForcesCsv::create();
    if (!csv) return tl::unexpected(csv.error());
    return ForcesFile(*std::move(output), *std::move(csv));
  }

  /// Adds a tick. `pressure` is 0..1 and determines the width of the ink.
  Result<void> add(const TickReport& tick, std::optional<double> pressure) {
    return csv_.add(tick, pressure);
  }
  /// Completes the file. Call it only once.
  Result<void> finish() {
    const Result<void> done =
        csv_.finish([this](std::string_view bytes) { return output_.write(bytes); });
    return done ? output_.commit() : done;
  }

 private:
  ForcesFile(Output output, ForcesCsv csv) : output_(std::move(output)), csv_(std::move(csv)) {}

  Output output_;
  ForcesCsv csv_;
};

}  // namespace felt::cli
