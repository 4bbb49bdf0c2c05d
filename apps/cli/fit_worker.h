#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drawing_output.h"
#include "felt/formats/drawing_reader.h"
#include "felt/io/ndjson/ndjson_parser.h"
#include "felt/io/quickdraw/quickdraw_line.h"
#include "felt/stroke/fit/ink_fitter.h"
#include "felt/stroke/steady/steady_line.h"
#include "fit_stats.h"

namespace felt::cli {

/// The settings of `fit` for each stroke.
struct FitSettings {
  InkFitOptions ink;
  double mm_per_unit = 1.0;
  bool refine = true;
  std::optional<Shake> steady = {};  ///< the shaking to remove before the fit
  bool measure = false;          ///< fill all members of FitStats; fitting then takes about five
                                 ///< times as long
  std::optional<Format> format;  ///< format of the output; if nullopt, results are not encoded
};

/// The work for one call of a worker: some lines of one input, or a whole input of another format.
struct FitItem {
  std::string name;  ///< of the input, for errors
  LineBatch lines;
  std::optional<Imported> drawing;
  std::size_t drawing_bytes = 0;  ///< size of the input that `drawing` comes from
  /// Number of the first record in this item. Records are numbered from 1 over all inputs.
  std::int64_t first_record = 1;
  std::optional<Error> failure;  ///< set if the input failed; the item then has no lines

  [[nodiscard]] std::size_t bytes() const noexcept { return lines.bytes() + drawing_bytes; }
};

/// An error in a line, or in a whole input (line 0).
struct FitError {
  std::int64_t line = 0;
  std::string what;
};

/// The result for one FitItem.
struct FitOutput {
  std::string name;  ///< of the input, for errors
  EncodedStrokes sketch;
  std::vector<FitError> errors;      ///< in the order of the lines
  std::vector<std::string> notices;  ///< complete messages
  /// The faults of samples, in the order of the lines; equal ones are not yet counted.
  std::vector<ImportNotice> faults;
  FitStats stats;
};

/// Parses raw strokes, fits them and encodes the result. Each thread needs its own FitWorker. The
/// encoded strokes depend only on the settings and the item, not on earlier items.
class FitWorker {
 public:
  explicit FitWorker(const FitSettings& settings);

  /// Replaces the content of `output` by the result for `item`. If a record is bad, adds an error
  /// to `output`.
  void operator()(const FitItem& item, FitOutput& output);

  /// Fits one stroke. `samples` are in mm.
  Result<Stroke> fit(std::span<const InkSample> samples, FitStats& stats);

 private:
  Result<void> process(const NdjsonLine& line, std::int64_t record, FitOutput& output);
  Result<void> process_drawing(const NdjsonLine& line, std::int64_t record, FitOutput& output);
  Result<void> process_raw(const NdjsonLine& line, std::int64_t number, FitOutput& output);
  void process_whole(const FitItem& item, const Imported& imported, FitOutput& output);
  Result<void> scale_to_mm();

  FitSettings settings_;
  NdjsonParser parser_;
  QuickdrawParser drawings_;
  std::optional<SteadyLine> steady_;  // if the settings have a shaking
  InkFitter fitter_;
  std::unique_ptr<StrokeMeter> meter_;
  RawStroke raw_;
};

}  // namespace felt::cli
