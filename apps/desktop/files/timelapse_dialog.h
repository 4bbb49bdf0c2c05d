#pragma once

#include <QDialog>
#include <QList>
#include <QString>
#include <functional>

#include "desktop/files/timelapse_file.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace felt::desktop {

/// Where the recording of a film is.
enum class RecordingSource {
  kSession,  ///< the session of this window, which is being recorded
  kDrawing,  ///< the recording in the drawing
  kFile,     ///< a file that the user chooses
};

/// Asks for a recording, and for the format, the length and the size of its film. The choices are
/// stored in the settings. Says what is missing if the format needs a program that is not
/// installed.
class TimelapseDialog : public QDialog {
  Q_OBJECT

 public:
  /// `sources` are offered in their order; kFile is always offered. `choose_file` asks for a file
  /// and returns "" if the user chose none. `encoder` is TimelapseRequest::program.
  TimelapseDialog(const QList<RecordingSource>& sources, std::function<QString()> choose_file,
                  const QString& encoder, QWidget* parent);

  [[nodiscard]] RecordingSource source() const;
  /// Returns the choices. `recording` is set if source() is kFile; the caller sets the other
  /// sources, and the materials.
  [[nodiscard]] TimelapseRequest request() const;
  void accept() override;

 private:
  void build();
  QWidget* file_row();
  void show_choices();

  std::function<QString()> choose_file_;
  QString encoder_;
  QComboBox* source_;
  QLineEdit* file_;
  QPushButton* choose_;
  QComboBox* format_;
  QDoubleSpinBox* seconds_;
  QSpinBox* size_;
  QCheckBox* grain_;
  QLabel* hint_;
  QPushButton* go_ = nullptr;
};

/// Returns the file extension of a film: ".webm".
QString suffix_of(TimelapseFormat format);
/// Returns the filter of a film for file dialogs.
QString filter_of(TimelapseFormat format);

}  // namespace felt::desktop
