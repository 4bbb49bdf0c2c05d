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

/// One row of a table of options as a person sets it: a slider and a number, a check box, buttons
/// side by side for two or three choices, a list for more; its help as the tip, and a button that
/// brings the default back while the value is another. Shows what it is told, says what is chosen.
class OptionRow : public QWidget {
  Q_OBJECT

 public:
  /// The table must outlive it.
  explicit OptionRow(const OptionSpec& spec, QWidget* parent = nullptr);

  [[nodiscard]] const OptionSpec& spec() const noexcept { return spec_; }
  /// Shows a value, without saying that it was chosen.
  void show_value(const OptionValue& value);
  /// What its reset brings back, from now on; show_value() comes next.
  void set_default(const OptionValue& value);

  /// How wide its number wants to be, 0 without one; and is, so that numbers below each other are
  /// alike.
  [[nodiscard]] int number_width() const;
  void set_number_width(int px);

 Q_SIGNALS:
  void chosen(const felt::OptionValue& value);

 protected:
  /// A wheel that is meant for scrolling changes no value.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void make_number();
  void make_switch();
  void make_choice();
  void make_buttons();
  void make_list();
  /// The first line: the name and the button that resets.
  void add_name(QWidget* buddy);
  QHBoxLayout* add_line();
  QToolButton* make_reset();
  /// Gives a control its name, its help and the wheel's manners.
  void dress(QWidget* control, const QString& name);
  void show_number(double value);

  OptionSpec spec_;
  OptionScale scale_;
  QString label_;
  QVBoxLayout* lines_;
  QHBoxLayout* line_;  // the first
  QSlider* slider_ = nullptr;
  QDoubleSpinBox* spin_ = nullptr;
  QAbstractButton* check_ = nullptr;
  QComboBox* list_ = nullptr;
  std::vector<QAbstractButton*> buttons_;
  QToolButton* reset_ = nullptr;
};

}  // namespace felt::desktop
