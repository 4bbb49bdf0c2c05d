#pragma once

#include <memory>

#include "felt/io/ndjson/ndjson_lines.h"
#include "felt/io/ndjson/ndjson_record.h"

namespace felt {

/// Turns one line of .ndjson into a record. Strict: the whole line must be JSON in UTF-8 within the
/// limits of limits.h, keys that are not ours included; a key of ours may occur once. The error
/// names the key and the element ("points[17]: y is NaN, not a number"); the caller knows the file
/// and the line. Keeps its buffers from line to line, so that memory follows the longest line.
/// One thread at a time.
class NdjsonParser {
 public:
  NdjsonParser();
  ~NdjsonParser();
  NdjsonParser(NdjsonParser&&) noexcept;
  NdjsonParser& operator=(NdjsonParser&&) noexcept;

  /// {"id":"s1","points":[[x,y,pressure|null,t_ms|null],...]} into `out`, whose content is
  /// replaced; undefined after an error.
  Result<NdjsonKind> raw_stroke(const NdjsonLine& line, RawStroke& out);

  /// {"id":..,"closed":..,"segments":..,"joints":..,"widths":..} into `out`, as above. Says what
  /// the line says; `Stroke::create` decides whether that is a stroke.
  Result<NdjsonKind> sketch_stroke(const NdjsonLine& line, SketchRecord& out);

 private:
  struct State;
  void release_large_buffers();

  std::unique_ptr<State> state_;
};

}  // namespace felt
