#include "desktop/materials/shape_row.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "felt/material/medium_style.h"

namespace felt::desktop {

ShapeRow::ShapeRow(QWidget* parent)
    : QWidget(parent), line_(new QLineEdit(this)), problem_(new QLabel(this)) {
  const QString name = tr("Shape");
  line_->setObjectName(QStringLiteral("style_shape"));
  line_->setMaxLength(int{kMaxStyleShapeBytes});
  line_->setAccessibleName(name);
  line_->setToolTip(
      tr("Path data of SVG with M, L, H, V, C and Z: x 0 to 1 along one repeat, y -0.5 to 0.5 "
         "across the line"));
  line_->setAccessibleDescription(line_->toolTip());
  auto* label = new QLabel(name, this);
  label->setBuddy(line_);
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(line_, 1);
  problem_->setWordWrap(true);
  problem_->hide();
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins({});
  rows->addLayout(row);
  rows->addWidget(problem_);
  connect(line_, &QLineEdit::editingFinished, this, &ShapeRow::take_text);
}

void ShapeRow::show_shape(const std::string& shape) {
  const QString text = QString::fromStdString(shape);
  if (line_->text() == text || (line_->isModified() && line_->hasFocus())) return;
  const QSignalBlocker quiet(line_);
  line_->setText(text);
  problem_->hide();
}

void ShapeRow::take_text() {
  const std::string text = line_->text().toStdString();
  const Result<StyleShape> shape = read_style_shape(text);
  problem_->setVisible(!shape);
  if (shape) {
    line_->setModified(false);
    Q_EMIT chosen(text);
  } else {
    problem_->setText(QString::fromStdString(shape.error().message));
  }
}

}  // namespace felt::desktop
