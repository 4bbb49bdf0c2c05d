#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <functional>
#include <memory>
#include <set>
#include <string>

#include "desktop/engine/studio.h"
#include "desktop/files/drawing_file.h"
#include "felt/autosave/saver.h"
#include "felt/autosave/saver_feed.h"

namespace felt::desktop {

/// Where working stores may be, the best place first: working_roots(), or below the folder of a
/// test.
QStringList recovery_roots();

/// Keeps what a person draws from being lost when the program or the machine dies: tells a Saver
/// what the studio does, and hands it the haptic loop's samples, so that ink is kept even while
/// this thread hangs. Figures of a material that change, and the text of a medium that comes with
/// strokes, are told within half a second. Nothing here waits for a disk but the destructor and
/// flush(). A drawing that is closed in order takes its store with it; one whose process is gone is
/// offered at the next start (recovery_dialog.h).
class Journal : public QObject {
  Q_OBJECT

 public:
  /// `current` gives the whole drawing.
  Journal(Studio& studio, std::function<Drawing()> current, const QStringList& roots,
          QObject* parent = nullptr);
  /// Removes the store where nothing unsaved would go with it (finish_clean, or no changes).
  ~Journal() override;

  /// Another drawing is on the desk, called `name`, from `path` or nowhere.
  void begin(const QString& name, const QString& path);
  /// It is in this file, as it was when it was saved.
  void saved(const QString& name, const QString& path);
  /// The person does not want it kept.
  void finish_clean() { is_clean_ = true; }
  /// All that was told so far is on the disk then, or known not to be.
  void flush();

  /// Where it is kept now; "" where it cannot be.
  [[nodiscard]] QString folder() const;

 Q_SIGNALS:
  /// Keeping it fails, works elsewhere, or works again.
  void status_changed(const felt::SaverStatus& status);

 private:
  void keep_head();
  void keep_head_soon();
  void note_kept(const Drawing& head);
  [[nodiscard]] bool lacks_medium_of(const Edit& edit) const;

  QPointer<Studio> studio_;  // a window may take it away first
  std::function<Drawing()> current_;
  std::unique_ptr<Saver> saver_;
  SaverFeed feed_;
  QTimer head_soon_;
  std::set<std::string> kept_media_;  // whose texts the saver has
  bool is_clean_ = false;
};

}  // namespace felt::desktop
