#include "desktop/files/file_dialogs.h"

#include "desktop/files/drawing_file.h"
#include "desktop/files/format_texts.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMessageBox>
#include <QPushButton>
#include <utility>

namespace felt::desktop {
namespace {

QString tr(const char* text, const char* comment = nullptr, int n = -1) {
  return QCoreApplication::translate("felt::desktop::FileDialogs", text, comment, n);
}

QMessageBox* error_box(QWidget* window, const QString& what, const QString& why,
                       const QString& details) {
  auto* box = new QMessageBox(QMessageBox::Critical, QStringLiteral("Feltline"), what,
                              QMessageBox::Ok, window);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setInformativeText(why);
  if (!details.isEmpty()) box->setDetailedText(details);
  box->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  return box;
}

}  // namespace

QString FileDialogs::open_name(QWidget* window, const QString& title, const QString& folder,
                               const QString& filters) {
  return QFileDialog::getOpenFileName(window, title, folder, filters);
}

QStringList FileDialogs::open_names(QWidget* window, const QString& title, const QString& folder,
                                    const QString& filters) {
  return QFileDialog::getOpenFileNames(window, title, folder, filters);
}

QString FileDialogs::save_name(QWidget* window, const QString& title, const QString& path,
                               const QString& filters, const QString& suffix) {
  QFileDialog dialog(window, title, QFileInfo(path).path(), filters);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  // The dialog appends the suffix, so that its question is about the name that is written.
  dialog.setDefaultSuffix(suffix);
  dialog.selectFile(QFileInfo(path).fileName());
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

QString FileDialogs::name_to_write(QWidget* window, const QString& title, const QString& path,
                                   FileFormat format) {
  QString suggested = path;
  for (;;) {
    const QString chosen =
        save_name(window, title, suggested, save_filter(format), suffix_of(format).mid(1));
    if (chosen.isEmpty()) return {};
    const QString asked_about = QFileInfo(chosen).absoluteFilePath();
    const QString name = with_suffix(asked_about, format);
    if (name == asked_about || !QFileInfo::exists(name)) return name;
    suggested = name;
  }
}

FileDialogs::Unsaved FileDialogs::ask_unsaved(QWidget* window, const QString& name) {
  QMessageBox box(QMessageBox::Warning, tr("Unsaved changes"),
                  tr("Save the changes to “%1”?").arg(name),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window);
  box.setInformativeText(tr("If you do not save, your changes since the last save are lost."));
  box.setDefaultButton(QMessageBox::Save);
  box.setEscapeButton(QMessageBox::Cancel);
  const int answer = box.exec();
  return answer == QMessageBox::Save      ? Unsaved::kSave
         : answer == QMessageBox::Discard ? Unsaved::kDiscard
                                          : Unsaved::kCancel;
}

FileDialogs::Overwrite FileDialogs::ask_overwrite(QWidget* window, const QString& name) {
  QMessageBox box(QMessageBox::Warning, tr("Changed on disk"),
                  tr("“%1” was changed by another program.").arg(name), QMessageBox::Cancel,
                  window);
  box.setInformativeText(tr("If you save now, your drawing replaces those changes."));
  const QPushButton* replace = box.addButton(tr("&Replace"), QMessageBox::DestructiveRole);
  const QPushButton* elsewhere = box.addButton(tr("Save &as…"), QMessageBox::AcceptRole);
  box.setDefaultButton(QMessageBox::Cancel);
  box.setEscapeButton(QMessageBox::Cancel);
  box.exec();
  return box.clickedButton() == replace     ? Overwrite::kReplace
         : box.clickedButton() == elsewhere ? Overwrite::kSaveAs
                                            : Overwrite::kCancel;
}

bool FileDialogs::ask_salvage(QWidget* window, const QString& name, const QString& why,
                              int strokes) {
  QMessageBox box(QMessageBox::Warning, tr("Damaged drawing"), tr("“%1” is damaged.").arg(name),
                  QMessageBox::Cancel, window);
  box.setInformativeText(
      tr("%n stroke(s) of it can be shown, as a new drawing; the file stays as it is.", nullptr,
         strokes));
  box.setDetailedText(why);
  const QPushButton* rescue = box.addButton(tr("&Show the readable part"), QMessageBox::AcceptRole);
  box.setEscapeButton(QMessageBox::Cancel);
  box.exec();
  return box.clickedButton() == rescue;
}

int FileDialogs::ask_page(QWidget* window, const QString& name, int pages) {
  bool is_chosen = false;
  const int page = QInputDialog::getInt(window, tr("Import a page"),
                                        tr("Page of “%1” (1 to %2):").arg(name).arg(pages), 1, 1,
                                        pages, 1, &is_chosen);
  return is_chosen ? page : 0;
}

void FileDialogs::show_error(QWidget* window, const QString& what, const QString& why,
                             const QString& details) {
  error_box(window, what, why, details)->open();
}

void FileDialogs::show_save_error(QWidget* window, const QString& what, const QString& why,
                                  const QString& details, std::function<void()> save_as) {
  QMessageBox* box = error_box(window, what, why, details);
  QPushButton* elsewhere = box->addButton(tr("Save &as…"), QMessageBox::AcceptRole);
  box->setDefaultButton(elsewhere);
  // Queued, so that the message box is closed before the file dialog opens.
  QObject::connect(elsewhere, &QPushButton::clicked, window, std::move(save_as),
                   Qt::QueuedConnection);
  box->open();
}

}  // namespace felt::desktop
