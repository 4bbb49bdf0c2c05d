#pragma once

#include <QString>
#include <cstdint>
#include <functional>

#include "felt/material/material_file.h"

namespace felt::desktop {

class Studio;

inline constexpr const char* kSheetMaterialId = "sheet.material";

/// The options of a new studio.
struct StudioOptions {
  /// Id of a device of pen_devices().
  QString device = QStringLiteral("tablet");
  /// False: no thread and no timer; Studio::advance() moves the time. For tests and pictures.
  bool live = true;
  /// True: the first options of this program (first_options.h). False: the library's defaults,
  /// which scripts rely on.
  bool first_options = true;
  /// Time from the last event until a live studio pauses its loop and its timer, if its device has
  /// no motors. The next event resumes them.
  std::int64_t rest_ns = 3'000'000'000;
  /// Called before the first session begins, so that a recorder can connect to session_began and
  /// event_applied and misses nothing.
  std::function<void(Studio&)> connect_early = {};
  /// Materials that can be chosen from the start; set without events, unlike set_user_materials().
  Materials materials = Materials::built_in();
};

/// The state that a file being written has: Studio::change_mark(), Studio::set_saved().
struct ChangeMark {
  std::uint64_t position = 0;       ///< of the history
  std::uint64_t other_changes = 0;  ///< that are not steps of the history, so far
};

}  // namespace felt::desktop
