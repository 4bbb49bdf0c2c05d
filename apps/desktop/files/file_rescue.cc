// The part of FileActions that looks after crashes.
#include <QFileInfo>
#include <QLabel>
#include <QStatusBar>
#include <QTimer>
#include <utility>

#include "desktop/files/file_actions.h"
#include "desktop/files/recovery_dialog.h"

namespace felt::desktop {

void FileActions::keep_journal(const QString& root) {
  journal_ = std::make_unique<Journal>(
      studio_, [this] { return drawing(); }, root);
  connect(journal_.get(), &Journal::failed, this, &FileActions::warn);
  journal_->begin(display_name(), path_);
}

/// In the first window of a process, once it is shown.
void FileActions::offer_once() {
  static bool is_done = false;
  if (std::exchange(is_done, true)) return;
  QTimer::singleShot(0, this, [this] { offer_recovery(recovery_root()); });
}

void FileActions::offer_recovery(const QString& root) {
  auto folders = std::make_shared<std::vector<AbandonedFolder>>(find_abandoned(root));
  if (folders->empty()) return;
  worker_.start([this, folders] {
    auto drawings = std::make_shared<std::vector<Result<Recovered>>>();
    for (const AbandonedFolder& folder : *folders) drawings->push_back(recover(folder.path));
    return [this, folders, drawings] { show_offers(std::move(*folders), std::move(*drawings)); };
  });
}

void FileActions::show_offers(std::vector<AbandonedFolder> folders,
                              std::vector<Result<Recovered>> drawings) {
  std::vector<RecoveryDialog::Offer> offers;
  for (std::size_t i = 0; i < folders.size(); ++i) {
    // One that cannot be read stays where it is: a newer program may know more.
    if (!drawings[i]) continue;
    if (drawings[i]->has_changes) {
      offers.push_back({std::move(folders[i]), *std::move(drawings[i])});
    } else {
      folders[i].remove();
    }
  }
  if (offers.empty()) return;
  auto* dialog = new RecoveryDialog(std::move(offers), window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &RecoveryDialog::recover_wanted, this, [this, dialog] {
    RecoveryDialog::Offer& offer = dialog->chosen();
    take_over(std::move(offer.folder), std::move(offer.recovered));
  });
  dialog->open();
}

void FileActions::take_over(AbandonedFolder folder, Recovered recovered) {
  if (!may_replace()) return;
  QString name = recovered.name.isEmpty() ? tr("Untitled") : recovered.name;
  if (name.endsWith(QStringLiteral(".felt"))) name.chop(5);
  if (!recovered.path.isEmpty()) folder_ = QFileInfo(recovered.path).path();
  adopt(std::move(recovered.drawing), tr("Recovered %1").arg(name));
  // Kept until its drawing is in a file: a second crash must not take it.
  rescued_.push_back(std::move(folder));
}

void FileActions::forget_rescued() {
  for (AbandonedFolder& folder : rescued_) folder.remove();
  rescued_.clear();
}

void FileActions::warn(const QString& why) {
  const QString text = tr("No crash protection: save often");
  auto* bar = window_->findChild<QStatusBar*>();
  if (!bar) return;
  auto* notice = new QLabel(QStringLiteral("⚠ ") + text, bar);
  notice->setToolTip(tr("What is needed for recovery cannot be written: %1").arg(why));
  notice->setAccessibleName(text);
  bar->addPermanentWidget(notice);
}

}  // namespace felt::desktop
