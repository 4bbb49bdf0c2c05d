#include "desktop/window/canvas_page.h"

#include <QLabel>
#include <QStyle>
#include <QVBoxLayout>

#include "desktop/canvas/canvas_setting_keys.h"
#include "desktop/window/setting_rows.h"

namespace felt::desktop {

namespace {

constexpr int kGapPx = 12;

}  // namespace

CanvasPage::CanvasPage(QWidget* parent) : QWidget(parent) {
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->setSpacing(2);
  const auto add = [this, all](const char* key, bool fallback, const QString& text,
                               const QString& tip) {
    QCheckBox* box = setting_switch(QString::fromLatin1(key), fallback, text, tip, this);
    box->setAccessibleDescription(tip);
    all->addWidget(box);
    auto* note = new QLabel(tip, this);
    note->setForegroundRole(QPalette::PlaceholderText);
    note->setWordWrap(true);
    note->setIndent(style()->pixelMetric(QStyle::PM_IndicatorWidth) +
                    style()->pixelMetric(QStyle::PM_CheckBoxLabelSpacing));
    all->addWidget(note);
    all->addSpacing(kGapPx);
  };
  add(canvas_keys::kForceArrow, canvas_keys::kForceArrowDefault, tr("Show the &force as an arrow"),
      tr("Shows the direction and strength of the force at the nib"));
  add(canvas_keys::kPseudoHaptics, canvas_keys::kPseudoHapticsDefault,
      tr("The &nib moves with forces"), tr("With a mouse or a tablet, this makes forces visible"));
  add(canvas_keys::kGrain, canvas_keys::kGrainDefault,
      tr("Dry media show the &grain of the surface"),
      tr("Like chalk on paper. Exported outlines do not change"));
  all->addStretch(1);
}

}  // namespace felt::desktop
