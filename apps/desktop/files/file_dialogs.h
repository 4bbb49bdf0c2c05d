#pragma once

#include <QString>
#include <QStringList>
#include <QWidget>
#include <functional>

#include "felt/formats/file_format.h"

namespace felt::desktop {

/// What a person is asked about files. The native dialogs; tests answer in their place.
class FileDialogs {
 public:
  enum class Unsaved { kSave, kDiscard, kCancel };
  enum class Overwrite { kReplace, kSaveAs, kCancel };

  virtual ~FileDialogs() = default;

  /// "" where nothing was chosen. `filters` as QFileDialog takes them.
  virtual QString open_name(QWidget* window, const QString& title, const QString& folder,
                            const QString& filters);
  virtual QStringList open_names(QWidget* window, const QString& title, const QString& folder,
                                 const QString& filters);
  /// Asks before an existing file is taken. `suffix` (".felt") is appended where there is none.
  virtual QString save_name(QWidget* window, const QString& title, const QString& path,
                            const QString& filters, const QString& suffix);
  /// The name that is written: what save_name gave, with the ending of the format. Where that is
  /// another file than the one that was asked about, and is there ("a 1.2", "a 1.2.felt"), it asks
  /// once more.
  QString name_to_write(QWidget* window, const QString& title, const QString& path,
                        FileFormat format);
  /// A drawing with changes is to go.
  virtual Unsaved ask_unsaved(QWidget* window, const QString& name);
  /// The file was changed by others since it was read.
  virtual Overwrite ask_overwrite(QWidget* window, const QString& name);
  /// A drawing is damaged, but so many strokes of it can be had. True: show them.
  virtual bool ask_salvage(QWidget* window, const QString& name, const QString& why, int strokes);
  /// Stays until it is closed; the program goes on. `details` are the library's own words.
  virtual void show_error(QWidget* window, const QString& what, const QString& why,
                          const QString& details);
  /// The same, with a button that saves elsewhere.
  virtual void show_save_error(QWidget* window, const QString& what, const QString& why,
                               const QString& details, std::function<void()> save_as);
};

}  // namespace felt::desktop
