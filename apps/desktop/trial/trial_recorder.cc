#include "desktop/trial/trial_recorder.h"

#include <QFile>
#include <cstdio>
#include <utility>

namespace felt::desktop {

TrialRecorder::TrialRecorder(Studio& studio, const QString& file)
    : studio_(studio),
      recorder_(studio.loop().device().info().label.toStdString(),
                studio.loop().servo().options().period_ns),
      file_(file) {
  connect(&studio, &Studio::session_began, this, [this] {
    has_begun_ = true;
    file_.begin();
  });
  connect(&studio, &Studio::event_applied, this, &TrialRecorder::add);
  connect(&studio.loop(), &HapticLoop::forces_read, this, &TrialRecorder::add_forces);
  connect(&file_, &RecordingFile::failed, this, [](const QString& why) {
    std::fprintf(stderr, "feltline-desktop: %s; a crash would lose this trial\n", qPrintable(why));
  });
}

void TrialRecorder::add(Event event) {
  if (!has_begun_) return;
  if (!start_ns_) start_ns_ = event.time_ns;
  event.time_ns -= *start_ns_;
  recorder_.event(event);
  file_.add(event);
  const auto* pen = std::get_if<PenEvent>(&event.what);
  if (!pen || has_contact_ || !in_contact(sample_of(event.time_ns, *pen))) return;
  has_contact_ = true;
  Q_EMIT touched();
}

void TrialRecorder::add_forces(const TickForces& forces) {
  if (!start_ns_ || forces.time_ns < *start_ns_) return;
  if (!studio_.session().device().has_force()) return;
  recorder_.forces(forces.time_ns - *start_ns_, forces.asked, forces.sent);
}

FeltRecording TrialRecorder::take() {
  studio_.disconnect(this);
  studio_.loop().disconnect(this);
  file_.flush();
  return recorder_.take();
}

void TrialRecorder::remove_file() {
  file_.flush();
  QFile::remove(file_.path());
}

}  // namespace felt::desktop
