#pragma once

#include <QLockFile>
#include <QObject>
#include <QPointer>
#include <QString>
#include <deque>
#include <functional>
#include <memory>

#include "desktop/engine/studio.h"
#include "desktop/files/journal_writer.h"

namespace felt::desktop {

/// Where recovery folders are: XDG_STATE_HOME/feltline/recovery, or $HOME/.local/state/...
QString recovery_root();

/// Keeps what a person draws from being lost when the program or the machine dies: a folder of its
/// own with the drawing as it was, every edit since, and the samples of the gesture in work
/// (JournalWriter). What is older than 50 ms is with the system; the pen never waits for it. A
/// drawing that is closed in order takes its folder with it; a folder whose process is gone is
/// offered at the next start (recovery.h).
///
/// Edits say what became of strokes, so that recovery needs neither the tools nor their history;
/// only the line that was being drawn is drawn again from its samples.
class Journal : public QObject {
  Q_OBJECT

 public:
  /// `current` gives the whole drawing. Begins at once.
  Journal(Studio& studio, std::function<Drawing()> current, const QString& root,
          QObject* parent = nullptr);
  /// Removes the folder where nothing unsaved would go with it (finish_clean, or no changes).
  ~Journal() override;

  /// Another drawing is on the desk, called `name`, from `path` or nowhere.
  void begin(const QString& name, const QString& path);
  /// What is on the desk now is in this file.
  void saved(const QString& name, const QString& path);
  /// The person does not want it kept.
  void finish_clean() { is_clean_ = true; }
  /// All that was told so far is with the system then.
  void flush() { writer_->flush(); }

  [[nodiscard]] const QString& folder() const noexcept { return folder_; }

 Q_SIGNALS:
  /// It can no longer be written, and why.
  void failed(const QString& why);

 private:
  void hear(const Event& event);
  void hear(const Edit& edit);
  void begin_tail();
  void tell_head();
  void write_about(const QString& name, const QString& path);
  void renew();

  QPointer<Studio> studio_;  // a window may take it away first
  std::function<Drawing()> current_;
  QString folder_;
  std::unique_ptr<QLockFile> lock_;
  std::unique_ptr<JournalWriter> writer_;
  std::deque<Event> air_;  // the last samples above the sheet
  bool has_tail_ = false, was_down_ = false, wants_base_ = false;
  bool is_clean_ = false, is_modified_ = false;
  std::int64_t last_contact_ns_ = 0;
};

}  // namespace felt::desktop
