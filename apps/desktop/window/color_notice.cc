#include "desktop/window/color_notice.h"

#include <QHBoxLayout>
#include <QPixmap>
#include <QStyle>

#include "desktop/panels/color_contrast.h"
#include "desktop/panels/swatch_view.h"
#include "felt/session/session_medium.h"
#include "felt/stroke/color_text.h"

namespace felt::desktop {
namespace {

constexpr int kNoticePx = 16, kSwatchPx = 14;

Rgba usual_color_of_medium(const Studio& studio) {
  const Medium* medium = studio.materials().find_medium(drawing_medium(studio.session()));
  return medium ? rgba(QColor(QRgb(0xFF000000U | medium->color_rgb))) : Rgba{};
}

}  // namespace

ColorNotice::ColorNotice(Studio& studio, QWidget* parent)
    : MessageBar(new QWidget, QString(), parent), studio_(studio), use_(new QPushButton(this)) {
  setObjectName(QStringLiteral("color_notice"));
  set_icon(style()->standardIcon(QStyle::SP_MessageBoxInformation).pixmap(kNoticePx));
  extras().addWidget(use_);
  show_color(studio.session().ink_color());
  delay_.setSingleShot(true);
  delay_.setInterval(kDelayMs);
  connect(&delay_, &QTimer::timeout, this, &ColorNotice::offer);
  connect(use_, &QPushButton::clicked, this, [this] {
    studio_.apply(SetOption{kInkColorId, color_to_text(offered_)});
  });
  connect(&studio, &Studio::option_changed, this, [this](const QString& id) {
    if (id == QLatin1String(kInkColorId)) follow();
  });
  connect(&studio, &Studio::opened, this, &ColorNotice::follow);
  connect(&studio, &Studio::page_changed, this, &ColorNotice::follow);
  follow();
}

void ColorNotice::follow() {
  if (is_hard_to_see(studio_.session().ink_color(), studio_.page().paper)) return delay_.start();
  delay_.stop();
  said_.reset();
  hide();
}

void ColorNotice::offer() {
  const Rgba ink = studio_.session().ink_color(), paper = studio_.page().paper;
  if (said_ == std::pair(ink, paper)) return;
  said_ = {ink, paper};
  show_color(visible_instead_of(ink, usual_color_of_medium(studio_), paper));
  say(tr("The colour of the ink can hardly be seen on this page."), false);
}

/// Shows the colour on the button.
void ColorNotice::show_color(Rgba color) {
  offered_ = color;
  QPixmap sample(kSwatchPx, kSwatchPx);
  sample.fill(qcolor(offered_));
  use_->setIcon(sample);
  use_->setText(tr("&Use %1").arg(qcolor(offered_).name()));
  use_->setAccessibleName(tr("Use the colour %1").arg(qcolor(offered_).name()));
}

}  // namespace felt::desktop
