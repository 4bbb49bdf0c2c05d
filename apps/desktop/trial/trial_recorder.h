#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <optional>

#include "desktop/engine/recording_file.h"
#include "desktop/engine/studio.h"
#include "felt/store/felt_recording.h"

namespace felt::desktop {

/// Records one trial: from the next Studio::start_over() on, all events, and the forces of all
/// ticks if the device has forces. The events are also written to a file while they happen, at most
/// 50 ms later, so that a crash loses no more (unfinished_trials.h). Times count from the start of
/// the trial. Requires a studio with StudioOptions::reads_forces, which outlives this object.
class TrialRecorder : public QObject {
  Q_OBJECT

 public:
  /// `file` is the path of the file.
  TrialRecorder(Studio& studio, const QString& file);

  /// Returns true if the pen has touched the surface.
  [[nodiscard]] bool has_contact() const noexcept { return has_contact_; }
  /// Ends the recording and returns it.
  [[nodiscard]] FeltRecording take();
  /// Deletes the file. Call it when the trial is saved.
  void remove_file();

 Q_SIGNALS:
  /// Emitted when the pen touches the surface for the first time.
  void touched();

 private:
  void add(Event event);
  void add_forces(const TickForces& forces);

  Studio& studio_;
  FeltRecorder recorder_;
  RecordingFile file_;
  std::optional<std::int64_t> start_ns_;
  bool has_begun_ = false;
  bool has_contact_ = false;
};

}  // namespace felt::desktop
