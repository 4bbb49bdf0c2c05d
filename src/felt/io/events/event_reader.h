#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "felt/io/ndjson/ndjson_lines.h"
#include "felt/io/ndjson/ndjson_record.h"
#include "felt/session/event.h"

namespace felt {

/// What one line of an event script holds (docs/formats/events.md).
enum class ScriptLineKind {
  kEvent,   ///< something that happens to a drawing session
  kStroke,  ///< a raw pen stroke, {"points":..}: no event; whoever plays it decides how
  kHeader,  ///< {"feltline":1,..}: says something about the file
};

/// Turns the lines of one script into events. Strict, like NdjsonParser: the whole line must be
/// JSON within the limits of limits.h, a key of ours may occur once, other keys are checked to be
/// JSON and ignored. Keys may come in any order. An event of an unknown kind is an error, since
/// leaving it out would play another session. Times never run backwards from event to event.
///
/// Errors name the key and the reason ("t_ms: ..."); the caller knows the file and the line. After
/// an error the reader goes on with the next line as if the bad one had not been there. One thread
/// at a time.
class EventReader {
 public:
  EventReader();
  ~EventReader();
  EventReader(EventReader&&) noexcept;
  EventReader& operator=(EventReader&&) noexcept;

  /// Says what the line is and puts it into `event` or `stroke`; the other keeps its value. Both
  /// are undefined after an error. A line with the key "event" is an event, whatever else it has.
  Result<ScriptLineKind> read(const NdjsonLine& line, Event& event, RawStroke& stroke);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// What to do with the lines of a script, in their order. An error ends the reading; it needs no
/// place, which read_script adds.
struct ScriptSink {
  std::function<Result<void>(const Event&)> event;
  /// Null: strokes are an error.
  std::function<Result<void>(const RawStroke&)> stroke;
};

/// Reads a whole script, a line at a time: memory is bounded by the longest one. Stops at the first
/// error, of the source, of a line or of the sink, and says where: "NAME:LINE: key: reason".
Result<void> read_script(const std::string& name, ReadBytes read, const ScriptSink& sink);

/// All events of a script that holds nothing else. Same errors.
Result<std::vector<Event>> read_events(const std::string& name, ReadBytes read);

}  // namespace felt
