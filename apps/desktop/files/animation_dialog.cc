#include "desktop/files/animation_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSpinBox>
#include <algorithm>
#include <array>

#include "desktop/engine/settings.h"
#include "desktop/files/files_setting_keys.h"

namespace felt::desktop {
namespace {

constexpr std::array kAnimationFormats{AnimationFormat::kAnimatedSvg, AnimationFormat::kPngFiles,
                                       AnimationFormat::kSvgFiles};

QString animation_name(AnimationFormat format) {
  switch (format) {
    case AnimationFormat::kPngFiles:
      return AnimationDialog::tr("Numbered PNG files");
    case AnimationFormat::kSvgFiles:
      return AnimationDialog::tr("Numbered SVG files");
    case AnimationFormat::kAnimatedSvg:
      break;
  }
  return AnimationDialog::tr("One animated SVG");
}

}  // namespace

QString suffix_of(AnimationFormat format) {
  return format == AnimationFormat::kPngFiles ? QStringLiteral(".png") : QStringLiteral(".svg");
}

QString filter_of(AnimationFormat format) {
  return animation_name(format) + QStringLiteral(" (*%1)").arg(suffix_of(format));
}

AnimationDialog::AnimationDialog(QWidget* parent)
    : QDialog(parent), format_(new QComboBox(this)), size_(new QSpinBox(this)) {
  setWindowTitle(tr("Export animation"));
  const Settings& settings = Settings::the();
  for (const AnimationFormat format : kAnimationFormats) {
    format_->addItem(animation_name(format), static_cast<int>(format));
  }
  const int chosen = static_cast<int>(settings.number(files_keys::kAnimationFormat, 0.0));
  format_->setCurrentIndex(std::max(0, format_->findData(chosen)));
  size_->setRange(FilmOptions::kMinSidePx, FilmOptions::kMaxSidePx);
  size_->setSuffix(tr(" pixels"));
  size_->setToolTip(tr("The longer side of the pictures"));
  size_->setValue(static_cast<int>(
      settings.number(files_keys::kTimelapseSize, files_keys::kTimelapseSizeDefault)));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  buttons->addButton(tr("&Export…"), QDialogButtonBox::AcceptRole)->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &AnimationDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  const auto show = [this] { size_->setEnabled(request().format == AnimationFormat::kPngFiles); };
  connect(format_, &QComboBox::currentIndexChanged, this, show);
  auto* form = new QFormLayout(this);
  form->addRow(tr("&Format:"), format_);
  form->addRow(tr("&Size:"), size_);
  form->addRow(buttons);
  show();
}

AnimationRequest AnimationDialog::request() const {
  AnimationRequest request;
  request.format = static_cast<AnimationFormat>(format_->currentData().toInt());
  request.longer_px = size_->value();
  return request;
}

void AnimationDialog::accept() {
  Settings& settings = Settings::the();
  settings.set(files_keys::kAnimationFormat, format_->currentData());
  settings.set(files_keys::kTimelapseSize, size_->value());
  QDialog::accept();
}

}  // namespace felt::desktop
