#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "felt/io/ndjson/ndjson_lines.h"
#include "felt/io/ndjson/ndjson_record.h"
#include "felt/session/event.h"

namespace felt {

/// The kinds of lines in an event script (docs/formats/events.md).
enum class ScriptLineKind {
  kEvent,   ///< an event of a drawing session
  kStroke,  ///< a raw pen stroke, {"points":..}; the caller decides how to use it
  kHeader,  ///< {"feltline":1,..}: describes the file
};

/// Converts the lines of one script to events. The reader is strict, like NdjsonParser: the whole
/// line must be JSON within the limits of limits.h. A known key may occur once; other keys must be
/// JSON and are ignored. Keys may come in any order. An unknown kind of event is an error, because
/// a session without that event would give a different drawing. Times must not decrease from event
/// to event.
///
/// Error messages name the key and the reason ("t_ms: ..."); the caller adds the file and the line.
/// After an error, the reader continues with the next line as if the invalid line did not exist.
/// Not thread-safe.
class EventReader {
 public:
  EventReader();
  ~EventReader();
  EventReader(EventReader&&) noexcept;
  EventReader& operator=(EventReader&&) noexcept;

  /// Reads a line into `event` or `stroke` and returns its kind; the other argument keeps its
  /// value. After an error both are unspecified. A line with the key "event" is always an event.
  Result<ScriptLineKind> read(const NdjsonLine& line, Event& event, RawStroke& stroke);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Receives the lines of a script, in order. If a function returns an error, the reading ends. The
/// error need not name the file and the line, because read_script() adds them.
struct ScriptSink {
  std::function<Result<void>(const Event&)> event;
  /// Called for each stroke. If null, a stroke is an error.
  std::function<Result<void>(const RawStroke&)> stroke;
};

/// Reads a whole script line by line, so memory is bounded by the longest line. Stops at the first
/// error of the source, of a line or of the sink. The message is "NAME:LINE: key: reason".
Result<void> read_script(const std::string& name, ReadBytes read, const ScriptSink& sink);

/// Returns all events of a script that contains only events. Fails like read_script().
Result<std::vector<Event>> read_events(const std::string& name, ReadBytes read);

}  // namespace felt
