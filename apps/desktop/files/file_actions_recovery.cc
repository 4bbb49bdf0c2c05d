// The part of FileActions for crash recovery.
#include <QFileInfo>
#include <QLabel>
#include <QStatusBar>
#include <QTimer>
#include <utility>

#include "desktop/files/file_actions.h"
#include "desktop/files/recovery_dialog.h"

namespace felt::desktop {

void FileActions::start_autosave(const QStringList& roots) {
  autosave_ = std::make_unique<StudioAutosave>(
      studio_, [this] { return drawing(); }, roots);
  connect(autosave_.get(), &StudioAutosave::status_changed, this, &FileActions::show_status);
  autosave_->begin(display_name(), path_);
}

/// Reports what was added to the drawing. The autosave has the names of strokes only since it
/// began.
void FileActions::report_added(const QString& name, const ImportReport& report) {
  if (autosave_ && !autosave_->has_names(names_)) autosave_->begin(display_name(), {});
  Q_EMIT taken(name, report);
}

/// Offers recovery once per process, in the first window, after the window was shown.
void FileActions::offer_once() {
  static bool is_done = false;
  if (std::exchange(is_done, true)) return;
  QTimer::singleShot(0, this, [this] { offer_recovery(recovery_roots()); });
}

void FileActions::offer_recovery(const QStringList& roots) {
  std::vector<std::string> places;
  for (const QString& root : roots) places.push_back(root.toStdString());
  worker_.start([this, places = std::move(places)] {
    auto offers =
        std::make_shared<std::vector<RecoveryOffer>>(read_offers(find_abandoned_autosaves(places)));
    return [this, offers] { show_offers(std::move(*offers)); };
  });
}

void FileActions::show_offers(std::vector<RecoveryOffer> offers) {
  if (offers.empty()) return;
  auto* dialog = new RecoveryDialog(std::move(offers), window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &RecoveryDialog::recover_wanted, this,
          [this, dialog] { take_over(std::move(dialog->chosen())); });
  // The autosave is kept, because the user may still want to recover it after seeing the saved
  // drawing.
  connect(dialog, &RecoveryDialog::open_wanted, this, [this](const QString& path) { open(path); });
  dialog->open();
}

void FileActions::take_over(RecoveryOffer offer) {
  if (!may_replace()) return;
  Recovered& recovered = offer.recovered;
  QString name = recovered.name.empty() ? tr("Untitled") : QString::fromStdString(recovered.name);
  if (name.endsWith(QStringLiteral(".felt"))) name.chop(5);
  if (!recovered.path.empty()) {
    folder_ = QFileInfo(QString::fromStdString(recovered.path)).path();
  }
  adopt(std::move(recovered.drawing), tr("Recovered %1").arg(name));
  // Kept until a file contains the drawing, so that a second crash does not lose it.
  rescued_.push_back(std::move(offer.store));
}

void FileActions::forget_rescued() {
  for (AbandonedAutosave& store : std::exchange(rescued_, {})) {
    static_cast<void>(std::move(store).remove());
  }
}

/// Shows a warning while the autosave fails. The warning does not block work.
void FileActions::show_status(const AutosaveStatus& status) {
  delete warning_;
  auto* bar = window_->findChild<QStatusBar*>();
  if (!bar || status.state == AutosaveStatus::State::kWorking) return;
  const QString why = QString::fromStdString(status.why);
  const bool is_lost = status.state == AutosaveStatus::State::kFailing;
  const QString text =
      is_lost ? tr("No crash protection: save often") : tr("Autosave in another place");
  warning_ = new QLabel(QStringLiteral("⚠ ") + text, bar);
  warning_->setToolTip(is_lost
                           ? tr("The autosave cannot be written: %1").arg(why)
                           : tr("The drawing is autosaved in %1, because the usual place fails: %2")
                                 .arg(QString::fromStdString(status.folder), why));
  warning_->setAccessibleName(text);
  bar->addPermanentWidget(warning_);
}

}  // namespace felt::desktop
