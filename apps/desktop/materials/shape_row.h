#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QWidget>
#include <string>

namespace felt::desktop {

/// A row for the shape of a medium's style, as path data. A text that is no shape is marked, with
/// the reason below it, and is not used.
class ShapeRow : public QWidget {
  Q_OBJECT

 public:
  explicit ShapeRow(QWidget* parent = nullptr);

  void show_shape(const std::string& shape);

 Q_SIGNALS:
  void chosen(const std::string& shape);

 private:
  void take_text();

  QLineEdit* line_;
  QLabel* problem_;
};

}  // namespace felt::desktop
