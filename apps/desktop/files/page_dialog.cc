#include "desktop/files/page_dialog.h"

#include <QColorDialog>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPainter>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace felt::desktop {
namespace {

struct Preset {
  const char* name;
  double short_mm, long_mm;
};
constexpr Preset kPresets[] = {
    {"A5", 148.0, 210.0}, {"A4", 210.0, 297.0},     {"A3", 297.0, 420.0},
    {"A2", 420.0, 594.0}, {"Letter", 215.9, 279.4},
};
constexpr int kPresetCount = int(std::size(kPresets));

QDoubleSpinBox* side_box(double value, QWidget* parent) {
  auto* box = new QDoubleSpinBox(parent);
  box->setRange(Page::kMinMm, Page::kMaxMm);
  box->setDecimals(1);
  box->setSuffix(PageDialog::tr(" mm"));
  box->setValue(value);
  return box;
}

}  // namespace

PageDialog::PageDialog(const Page& page, QWidget* parent)
    : QDialog(parent),
      preset_(new QComboBox(this)),
      width_(side_box(page.width_mm, this)),
      height_(side_box(page.height_mm, this)),
      portrait_(new QRadioButton(tr("&Portrait"), this)),
      landscape_(new QRadioButton(tr("&Landscape"), this)),
      color_key_(new QPushButton(this)),
      no_paper_(new QPushButton(tr("&None"), this)),
      color_(page.paper.r, page.paper.g, page.paper.b, page.paper.a),
      surface_(page.surface) {
  setWindowTitle(tr("Page setup"));
  for (const Preset& preset : kPresets) preset_->addItem(QLatin1String(preset.name));
  preset_->addItem(tr("Custom"));
  (page.width_mm > page.height_mm ? landscape_ : portrait_)->setChecked(true);
  no_paper_->setToolTip(tr("No paper: transparent in exported pictures"));
  color_key_->setAccessibleDescription(tr("Colour of the paper"));
  auto* orientation = new QHBoxLayout;
  orientation->addWidget(portrait_);
  orientation->addWidget(landscape_);
  orientation->addStretch();
  auto* paper = new QHBoxLayout;
  paper->addWidget(color_key_, 1);
  paper->addWidget(no_paper_);
  auto* form = new QFormLayout;
  form->addRow(tr("&Size:"), preset_);
  form->addRow(tr("&Width:"), width_);
  form->addRow(tr("&Height:"), height_);
  form->addRow(tr("Orientation:"), orientation);
  form->addRow(tr("Paper:"), paper);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* all = new QVBoxLayout(this);
  all->addLayout(form);
  all->addWidget(buttons);
  all->setSizeConstraint(QLayout::SetFixedSize);
  connect(preset_, &QComboBox::activated, this, &PageDialog::take_preset);
  connect(landscape_, &QRadioButton::toggled, this, &PageDialog::take_orientation);
  connect(width_, &QDoubleSpinBox::valueChanged, this, &PageDialog::find_preset);
  connect(height_, &QDoubleSpinBox::valueChanged, this, &PageDialog::find_preset);
  connect(color_key_, &QPushButton::clicked, this, &PageDialog::choose_color);
  connect(no_paper_, &QPushButton::clicked, this, [this] {
    color_.setAlpha(0);
    show_color();
  });
  find_preset();
  show_color();
}

Page PageDialog::page() const {
  const auto byte = [](int v) { return static_cast<std::uint8_t>(v); };
  return {width_->value(),
          height_->value(),
          {byte(color_.red()), byte(color_.green()), byte(color_.blue()), byte(color_.alpha())},
          surface_};
}

void PageDialog::take_preset() {
  const int i = preset_->currentIndex();
  if (i >= kPresetCount) return;
  const bool lies = landscape_->isChecked();
  is_changing_ = true;
  width_->setValue(lies ? kPresets[i].long_mm : kPresets[i].short_mm);
  height_->setValue(lies ? kPresets[i].short_mm : kPresets[i].long_mm);
  is_changing_ = false;
}

void PageDialog::take_orientation() {
  if (is_changing_) return;
  const double width = width_->value(), height = height_->value();
  const bool lies = landscape_->isChecked();
  is_changing_ = true;
  width_->setValue(lies ? std::max(width, height) : std::min(width, height));
  height_->setValue(lies ? std::min(width, height) : std::max(width, height));
  is_changing_ = false;
}

/// Selects the preset and the orientation of the present size.
void PageDialog::find_preset() {
  if (is_changing_) return;
  is_changing_ = true;
  const double width = width_->value(), height = height_->value();
  (width > height ? landscape_ : portrait_)->setChecked(true);
  const double smallest = std::min(width, height), largest = std::max(width, height);
  int found = kPresetCount;
  for (int i = 0; i < kPresetCount; ++i) {
    if (std::abs(kPresets[i].short_mm - smallest) < 0.05 &&
        std::abs(kPresets[i].long_mm - largest) < 0.05) {
      found = i;
    }
  }
  preset_->setCurrentIndex(found);
  is_changing_ = false;
}

void PageDialog::choose_color() {
  QColor start = color_;
  start.setAlpha(255);
  const QColor chosen = QColorDialog::getColor(start, this, tr("Colour of the paper"));
  if (!chosen.isValid()) return;
  color_ = chosen;
  show_color();
}

void PageDialog::show_color() {
  const double ratio = devicePixelRatioF();
  const QSize size(32, 16);
  QPixmap pixmap(size * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(color_.alpha() > 0 ? color_ : Qt::transparent);
  QPainter painter(&pixmap);
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawRect(QRectF(QPointF(0, 0), size).adjusted(0.5, 0.5, -0.5, -0.5));
  if (color_.alpha() == 0) painter.drawLine(1, size.height() - 1, size.width() - 1, 1);
  painter.end();
  color_key_->setIcon(QIcon(pixmap));
  color_key_->setIconSize(size);
  color_key_->setText(color_.alpha() > 0 ? color_.name() : tr("No paper"));
}

}  // namespace felt::desktop
