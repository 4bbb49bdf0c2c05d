#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "felt/document/edit.h"
#include "felt/haptics/capabilities.h"
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

/// {"event":"pen","x":..,"y":..,"z":..,"pressure":..,"buttons":0,"lean":32.5}: the sample as read.
/// Velocity is no part of the text form; the player derives it as a device would.
struct PenEvent {
  Vec3 position;
  std::optional<double> pressure;
  std::uint32_t buttons = 0;
  std::optional<double> lean_deg{};  ///< of the pen from the upright, 0..90; absent where unknown
  friend bool operator==(const PenEvent&, const PenEvent&) = default;
};

/// {"event":"hand","x":..,"y":..,"z":..}: where the simulated hand wants the pen; forces then move
/// it. For the player, which owns the device; a session never sees it.
struct HandEvent {
  Vec3 target;
  std::optional<double> pressure;
  std::uint32_t buttons = 0;
  std::optional<double> lean_deg{};
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
  bool select = false;  ///< the added strokes become the selection, which stays as it was otherwise
  friend bool operator==(const ImportEvent&, const ImportEvent&) = default;
};

/// {"event":"select","what":"all"}: whole strokes of visible, unlocked layers.
struct SelectStrokes {
  enum class What : std::uint8_t {
    kAll,
    kNone,
    kInvert,  ///< what is wholly selected no longer is, all others wholly are
  };
  What what = What::kAll;
  friend bool operator==(const SelectStrokes&, const SelectStrokes&) = default;
};

/// {"event":"delete"}: the strokes that are wholly selected go; of others nothing does.
struct DeleteEvent {
  friend bool operator==(const DeleteEvent&, const DeleteEvent&) = default;
};
/// {"event":"duplicate"}: copies of the strokes that are wholly selected, a little beside them,
/// each on top of its layer; they are what is selected then.
struct DuplicateEvent {
  friend bool operator==(const DuplicateEvent&, const DuplicateEvent&) = default;
};

/// {"event":"restyle","color":"#b02020","medium":"chalk"}: the selected strokes, those that are
/// selected in part too, get this colour, this medium or both, as one step of undo. Their shapes
/// and widths stay.
struct RestyleEvent {
  std::string color = {};   ///< as "sheet.color" takes it; "" leaves it
  std::string medium = {};  ///< the id of one that is known and draws; "" leaves it
  friend bool operator==(const RestyleEvent&, const RestyleEvent&) = default;
};

/// {"event":"layer","do":"hide","id":2}, {"event":"layer","do":"add","name":"Ideas"}
struct LayerEvent {
  enum class Do : std::uint8_t {
    kAdd,     ///< above the one in use, and in use from then on; "Layer N" where there is no name
    kRemove,  ///< with its strokes
    kRename,
    kShow,
    kHide,
    kLock,
    kUnlock,
    kRaise,  ///< one place up; nothing at the top
    kLower,  ///< one place down; nothing at the bottom
    kUse,    ///< new ink goes there; no step of undo
    kMove,   ///< to the place `index`
  };
  Do what = Do::kAdd;
  LayerId layer;          ///< none for kAdd
  std::string name = {};  ///< of kAdd and kRename
  std::size_t index = 0;  ///< of kMove: 0 is the lowest place, beyond the highest is the highest
  friend bool operator==(const LayerEvent&, const LayerEvent&) = default;
};

/// The version of the tools' default options, which recordings name because they leave out options
/// that have their default. 1: Feltline 0.1.0 (old_defaults.h).
inline constexpr int kOptionDefaults = 2;

/// {"event":"device","max_force_n":3.3,...}: what the samples come from and forces go to, from now
/// on. The gesture in work is ended as if the pen were lifted. For recordings that are told to a
/// session as they are; the Player, which has a device of its own, refuses it. The workspace, which
/// tools do not look at, is no part of the text form.
struct UseDevice {
  Capabilities capabilities;
  /// Of the program that recorded it. The first event with other defaults than the session's sets
  /// the options that still have their default.
  int defaults = kOptionDefaults;
  friend bool operator==(const UseDevice&, const UseDevice&) = default;
};

/// {"event":"material","text":"kind = \"sheet\"..."}: this sheet or medium is known from now on,
/// and is the one of its id: what is in use is taken over at once. The text says all of it
/// (docs/formats/material.md).
struct UseMaterial {
  std::string text;
  friend bool operator==(const UseMaterial&, const UseMaterial&) = default;
};

/// Everything that can happen to a drawing session: its only input (architecture section 6). Times
/// never run backwards.
struct Event {
  std::int64_t time_ns = 0;
  std::variant<SelectTool, SetOption, PenEvent, HandEvent, UndoEvent, RedoEvent, CancelEvent,
               ImportEvent, SelectStrokes, DeleteEvent, DuplicateEvent, RestyleEvent, LayerEvent,
               UseDevice, UseMaterial>
      what;
  friend bool operator==(const Event&, const Event&) = default;
};

}  // namespace felt
