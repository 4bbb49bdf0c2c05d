#pragma once

#include <QAbstractButton>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>
#include <vector>

#include "desktop/panels/option_scale.h"
#include "felt/tools/tool_options.h"

namespace felt::desktop {

/// Shows one option of a tool as a control: a slider and a number, a check box, two to four
/// buttons, or a list if there are more choices. The option's help is the tool tip. If
/// the value differs from the default, a button restores the default. The row shows the value that
/// show_value() sets, and emits `chosen` with the value that the user chooses.
class OptionRow : public QWidget {
  Q_OBJECT

 public:
  /// `spec` is copied, but the texts to which it refers must outlive the row.
  explicit OptionRow(const OptionSpec& spec, QWidget* parent = nullptr);

  [[nodiscard]] const OptionSpec& spec() const noexcept { return spec_; }
  /// Shows a value without emitting `chosen`.
  void show_value(const OptionValue& value);
  /// Sets the value that the reset button restores. Requires that show_value() is called next.
  void set_default(const OptionValue& value);

  /// Returns the preferred width of the number field; 0 if the row has no number field.
  /// set_number_width() sets the width, so that the numbers of several rows align.
  [[nodiscard]] int number_width() const;
  void set_number_width(int px);

 Q_SIGNALS:
  void chosen(const felt::OptionValue& value);

 private:
  void make_number();
  void make_switch();
  void make_choice();
  void make_buttons();
  void make_list();
  /// Makes the first line: the name and the reset button.
  void add_name(QWidget* buddy);
  QHBoxLayout* add_line();
  QToolButton* make_reset();
  /// Sets a control's name and help.
  void dress(QWidget* control, const QString& name);
  void show_number(double value);

  OptionSpec spec_;
  OptionScale scale_;
  QString label_;
  QVBoxLayout* lines_;
  QHBoxLayout* line_;  // the first line
  QSlider* slider_ = nullptr;
  QDoubleSpinBox* spin_ = nullptr;
  QAbstractButton* check_ = nullptr;
  QComboBox* list_ = nullptr;
  std::vector<QAbstractButton*> buttons_;
  QToolButton* reset_ = nullptr;
};

}  // namespace felt::desktop
