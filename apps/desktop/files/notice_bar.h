#pragma once

#include <QTimer>

#include "desktop/engine/message_bar.h"
#include "felt/formats/lost_objects.h"
#include "felt/io/import.h"

class QPushButton;
class QTreeWidget;

namespace felt::desktop {

/// Shows which parts of a file are not supported: one line over the canvas, and under "Details" a
/// list of these parts and their positions. The report of another file replaces the present one.
class NoticeBar : public MessageBar {
  Q_OBJECT

 public:
  explicit NoticeBar(QWidget* parent = nullptr);

  /// Shows a report on the file `name`. A report without notices hides the bar.
  void show_report(const QString& name, const ImportReport& report);
  /// Removes the report because another drawing is shown.
  void forget_report();
  /// Shows another message to the user until it is closed.
  void show_words(const QString& words);
  /// Says that a file was written, with a button that opens its folder: for kWrittenMs, or until
  /// it is closed if the file lacks objects of the drawing. `changed` are sentences about what else
  /// differs from the drawing.
  static constexpr int kWrittenMs = 15'000;
  void show_written(const QString& path, const LostObjects& lost = {}, const QString& changed = {});

 private:
  NoticeBar(QTreeWidget* list, QWidget* parent);
  void fit_list();
  void clear();

  QTreeWidget* list_;
  QPushButton* folder_;
  QTimer until_;
  QString path_;
};

}  // namespace felt::desktop
