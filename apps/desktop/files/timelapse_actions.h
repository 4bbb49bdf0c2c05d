#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <functional>
#include <memory>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"
#include "desktop/files/file_worker.h"
#include "desktop/files/timelapse_file.h"

class QProgressDialog;

namespace felt::desktop {

class FileActions;

/// Handles "file.timelapse": makes a film of a recording on a thread of its own, so that
/// neither the pen nor a save waits for it. A window beside the canvas shows the progress and can
/// cancel the film. One film at a time; the destructor cancels it.
class TimelapseActions : public QObject {
  Q_OBJECT

 public:
  TimelapseActions(FileActions& files, Studio& studio, Actions& actions, QWidget* window);
  ~TimelapseActions() override;

  /// Starts a film. Errors are shown to the user. Requires that no film is being made.
  void make(const QString& path, const TimelapseRequest& request);
  /// Runs the work of a film in the same way: `work` writes the file `path` on the other thread.
  void run(const QString& path, std::function<Result<void>(TimelapseProgress&)> work);
  /// Cancels the film that is being made, if any.
  void cancel() { progress_->is_cancelled = true; }
  [[nodiscard]] bool is_busy() const { return worker_.is_busy(); }
  /// Returns the request for the session that is being recorded, or for the recording in the
  /// drawing. Requires that there is one.
  [[nodiscard]] TimelapseRequest with_session(TimelapseRequest request) const;
  [[nodiscard]] TimelapseRequest with_drawing(TimelapseRequest request) const;

 Q_SIGNALS:
  /// The film is complete (`done`), was cancelled, or failed. `changed` says what of the recording
  /// was changed or left out; it may be empty.
  void made(const QString& path, bool done, const QString& changed);

 private:
  void ask();
  [[nodiscard]] QString ask_name(TimelapseFormat format) const;
  void show_progress(const QString& name);
  void end(const QString& path, const Result<void>& done);

  FileActions& files_;
  Studio& studio_;
  QWidget* window_;
  QAction* action_;
  std::shared_ptr<TimelapseProgress> progress_ = std::make_shared<TimelapseProgress>();
  QPointer<QProgressDialog> shown_;
  QTimer poll_;
  FileWorker worker_;
};

}  // namespace felt::desktop
