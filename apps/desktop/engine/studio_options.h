#pragma once

#include <QString>
#include <cstdint>
#include <functional>

#include "felt/material/material_file.h"
#include "felt/rt/servo.h"
#include "felt/session/session.h"

namespace felt::desktop {

inline constexpr const char* kSheetMaterialId = "sheet.material";

/// What a studio begins with.
struct StudioOptions {
  /// Of pen_devices().
  QString device = QStringLiteral("tablet");
  /// False: no thread and no timer; whoever owns the studio moves time by advance(). For tests and
  /// pictures.
  bool live = true;
  /// Begins with the options that this program has at first (first_options.h). False: the
  /// library's, which scripts count on.
  bool first_options = true;
  /// So long after the last event a live studio whose device has no motors stops its loop and its
  /// timer; the next event starts them again.
  std::int64_t rest_ns = 3'000'000'000;
  /// Told every event of the session, pen samples as PenEvent, in order: a Recorder. The first ones
  /// say which device it is and which options are not the defaults, so that the events alone, told
  /// to another session, give the same drawing.
  std::function<void(const Event&)> on_event = {};
  /// A session begins, with this document; its events follow. There is one at the start, and one
  /// for each open().
  std::function<void(const Document&)> on_session = {};
  /// What may be chosen from the start: know() without events.
  Materials materials = Materials::built_in();
};

/// Hears what happens to the sessions of a studio, in order: each event that was taken and each
/// edit of the document, undo's and redo's too. On Qt's main thread, within the studio's call:
/// must be quick, and must not call back.
struct StudioListener {
  std::function<void(const Event&)> event;
  std::function<void(const Edit&)> edit;
  /// A loop begins or wakes whose samples for the saver may be taken (Servo::for_saver), and what
  /// the studio's clock is ahead of the loop's; null: it ends or sleeps, and nothing of it may be
  /// used any more.
  /// When it begins to listen, too.
  std::function<void(Servo*, std::int64_t)> loop = {};
};

/// What a file that is being written holds: Studio::change_mark(), Studio::set_saved().
struct ChangeMark {
  std::uint64_t position = 0;       ///< of the history
  std::uint64_t other_changes = 0;  ///< that are not steps of the history, so far
};

}  // namespace felt::desktop
