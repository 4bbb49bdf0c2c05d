#pragma once

#include <memory>

#include "felt/io/ndjson/ndjson_lines.h"
#include "felt/io/ndjson/ndjson_record.h"

namespace felt {

/// Converts one line of .ndjson to a record. The parser is strict: the whole line, including the
/// values of unknown keys, must be JSON in UTF-8 within the limits of limits.h. A known key may
/// occur once. Error messages name the key and the element ("points[17]: y is NaN, not a number");
/// the caller adds the file and the line. The parser reuses its buffers, but it releases very large
/// ones after the line. Not thread-safe.
class NdjsonParser {
 public:
  NdjsonParser();
  ~NdjsonParser();
  NdjsonParser(NdjsonParser&&) noexcept;
  NdjsonParser& operator=(NdjsonParser&&) noexcept;

  /// Reads {"id":"s1","points":[[x,y,pressure|null,t_ms|null],...]} into `out`, replacing its
  /// content. After an error `out` is unspecified.
  Result<NdjsonKind> raw_stroke(const NdjsonLine& line, RawStroke& out);

  /// Reads {"id":..,"closed":..,"segments":..,"joints":..,"widths":..} into `out`, replacing its
  /// content. After an error `out` is unspecified.
  /// Does not check that the values make a stroke; `Stroke::create` does.
  Result<NdjsonKind> sketch_stroke(const NdjsonLine& line, SketchRecord& out);

 private:
  struct State;
  void release_large_buffers();

  std::unique_ptr<State> state_;
};

}  // namespace felt
