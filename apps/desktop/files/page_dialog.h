#pragma once

#include <QColor>
#include <QDialog>
#include <string>

#include "felt/document/page.h"

class QComboBox;
class QDoubleSpinBox;
class QPushButton;
class QRadioButton;

namespace felt::desktop {

/// Asks for size, orientation and colour of the page.
class PageDialog : public QDialog {
  Q_OBJECT

 public:
  PageDialog(const Page& page, QWidget* parent);

  [[nodiscard]] Page page() const;

 private:
  void take_preset();
  void take_orientation();
  void find_preset();
  void choose_color();
  void show_color();

  QComboBox* preset_;
  QDoubleSpinBox* width_;
  QDoubleSpinBox* height_;
  QRadioButton* portrait_;
  QRadioButton* landscape_;
  QPushButton* color_key_;
  QPushButton* no_paper_;
  QColor color_;
  std::string surface_;
  bool is_changing_ = false;
};

}  // namespace felt::desktop
