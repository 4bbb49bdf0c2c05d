#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "felt/haptics/pen_sample.h"
#include "felt/tools/tool_options.h"

namespace felt {

/// {"event":"tool","id":"pencil"}
struct SelectTool {
  std::string id;
  friend bool operator==(const SelectTool&, const SelectTool&) = default;
};

/// {"event":"option","id":"pencil.snap","value":"both"}. Besides the tools' own tables there is
/// the sheet's: "sheet.material", "sheet.color".
struct SetOption {
  std::string id;
  OptionValue value;
  friend bool operator==(const SetOption&, const SetOption&) = default;
};

/// {"event":"pen","x":..,"y":..,"z":..,"pressure":..,"buttons":0}: the sample as read. Velocity is
/// no part of the text form; the player derives it as a device would.
struct PenEvent {
  Vec3 position;
  std::optional<double> pressure;
  std::uint32_t buttons = 0;
  friend bool operator==(const PenEvent&, const PenEvent&) = default;
};

/// {"event":"hand","x":..,"y":..,"z":..}: where the simulated hand wants the pen; forces then move
/// it. For the player, which owns the device; a session never sees it.
struct HandEvent {
  Vec3 target;
  std::optional<double> pressure;
  std::uint32_t buttons = 0;
  friend bool operator==(const HandEvent&, const HandEvent&) = default;
};

struct UndoEvent {
  friend bool operator==(const UndoEvent&, const UndoEvent&) = default;
};
struct RedoEvent {
  friend bool operator==(const RedoEvent&, const RedoEvent&) = default;
};
struct CancelEvent {
  friend bool operator==(const CancelEvent&, const CancelEvent&) = default;
};

/// {"event":"import","path":".."}: the strokes of a sketch file are added. Whoever reads the script
/// reads the file; the session gets it as an edit.
struct ImportEvent {
  std::string path;
  friend bool operator==(const ImportEvent&, const ImportEvent&) = default;
};

/// Everything that can happen to a drawing session: its only input (architecture section 6). Times
/// never run backwards.
struct Event {
  std::int64_t time_ns = 0;
  std::variant<SelectTool, SetOption, PenEvent, HandEvent, UndoEvent, RedoEvent, CancelEvent,
               ImportEvent>
      what;
  friend bool operator==(const Event&, const Event&) = default;
};

}  // namespace felt
