#pragma once

#include <QString>
#include <QStringList>
#include <QWidget>
#include <functional>

#include "felt/formats/file_format.h"

namespace felt::desktop {

/// Questions to the user about files. Uses the native dialogs; tests override them.
class FileDialogs {
 public:
  enum class Unsaved { kSave, kDiscard, kCancel };
  enum class Overwrite { kReplace, kSaveAs, kCancel };

  virtual ~FileDialogs() = default;

  /// Asks for a file to open. Returns "" if the user chose none. `filters` are as for QFileDialog.
  virtual QString open_name(QWidget* window, const QString& title, const QString& folder,
                            const QString& filters);
  virtual QStringList open_names(QWidget* window, const QString& title, const QString& folder,
                                 const QString& filters);
  /// Asks for a name to save to. Asks for confirmation before an existing file is replaced.
  /// Appends `suffix` (".felt") if the name has no extension.
  virtual QString save_name(QWidget* window, const QString& title, const QString& path,
                            const QString& filters, const QString& suffix);
  /// Asks with save_name() and returns the chosen name with the extension of the format. Adding the
  /// extension may give the name of an existing file about which the dialog did not ask ("a 1.2"
  /// becomes "a 1.2.felt"); in this case asks again.
  QString name_to_write(QWidget* window, const QString& title, const QString& path,
                        FileFormat format);
  /// Asks what to do with unsaved changes of a drawing that is about to be closed.
  virtual Unsaved ask_unsaved(QWidget* window, const QString& name);
  /// Asks what to do with a file that another program changed since it was read.
  virtual Overwrite ask_overwrite(QWidget* window, const QString& name);
  /// Reports that a drawing is damaged; `strokes` is the number of strokes that can be recovered.
  /// Returns true if the user wants to see these strokes.
  virtual bool ask_salvage(QWidget* window, const QString& name, const QString& why, int strokes);
  /// Asks which page of a file with `pages` pages to import. Returns 0 if the user cancelled.
  virtual int ask_page(QWidget* window, const QString& name, int pages);
  /// Shows an error until the user closes it, without blocking the program. `details` is the
  /// library's own message.
  virtual void show_error(QWidget* window, const QString& what, const QString& why,
                          const QString& details);
  /// Shows an error with a button to save to another file.
  virtual void show_save_error(QWidget* window, const QString& what, const QString& why,
                               const QString& details, std::function<void()> save_as);
};

}  // namespace felt::desktop
