#pragma once

#include <QString>
#include <cstdint>
#include <functional>

#include "felt/material/material_file.h"

namespace felt::desktop {

class Studio;

inline constexpr const char* kSurfaceOptionId = "surface.material";
inline constexpr const char* kInkColorId = "ink.color";

/// The options of a new studio.
struct StudioOptions {
  /// Id of a device of pen_devices().
  QString device = QStringLiteral("tablet");
  /// If false, no thread and no timer run; Studio::advance() advances the time. For tests and
  /// pictures.
  bool live = true;
  /// If true, the options of the tools start with this program's defaults (first_options.h); if
  /// false, with the library's defaults, on which scripts rely.
  bool first_options = true;
  /// Time from the last event until a live studio pauses its loop and its timer. The next event
  /// resumes them. With a device that has forces, or that the user holds, they never pause.
  std::int64_t rest_ns = 3'000'000'000;
  /// If true, HapticLoop::forces_read reports the forces of every tick, for a recorder.
  bool reads_forces = false;
  /// Called before the first session begins, so that a recorder can connect to session_began and
  /// event_applied without missing an event.
  std::function<void(Studio&)> connect_early = {};
  /// Materials that can be chosen from the start. They are set without events, unlike those of
  /// set_user_materials().
  Materials materials = Materials::built_in();
};

/// Identifies the state of a drawing that is being written to a file. Studio::change_mark() makes
/// it; Studio::set_saved() uses it.
struct ChangeMark {
  std::uint64_t position = 0;       ///< position in the history
  std::uint64_t other_changes = 0;  ///< number of changes so far that are not steps of the history
};

}  // namespace felt::desktop
