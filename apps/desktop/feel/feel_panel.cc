#include "desktop/feel/feel_panel.h"

#include <QEvent>
#include <QGridLayout>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "desktop/feel/feel_actions.h"
#include "desktop/feel/feel_icons.h"
#include "desktop/feel/material_words.h"
#include "desktop/feel/safety_words.h"
#include "felt/haptics/drawing_feel.h"

namespace felt::desktop {
namespace {

constexpr QSize kSwatchPx{60, 36};
constexpr int kIconPx = 22;
constexpr int kPercentStep = 5, kPercentPage = 20;

QString id_of(const SurfaceMaterial& material) {
  return QString::fromUtf8(material.id.data(), qsizetype(material.id.size()));
}

QLabel* heading(const QString& text, QWidget* buddy, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setBuddy(buddy);
  return label;
}

}  // namespace

FeelPanel::FeelPanel(Studio& studio, QWidget* parent)
    : QWidget(parent), studio_(studio), forces_(new QPushButton(this)), words_(new QLabel(this)) {
  forces_->setIconSize({kIconPx, kIconPx});
  forces_->setMinimumHeight(5 * fontMetrics().height() / 2);
  QFont large = forces_->font();
  large.setPointSizeF(1.2 * large.pointSizeF());
  forces_->setFont(large);
  words_->setWordWrap(true);
  connect(forces_, &QPushButton::clicked, this, [this] {
    studio_.set_forces(!studio_.forces_are_on());
    tell_forces();
  });
  auto* rows = new QVBoxLayout(this);
  rows->addWidget(forces_);
  rows->addWidget(words_);
  rows->addWidget(make_strength());
  rows->addWidget(make_materials());
  rows->addStretch(1);
  connect(&studio_, &Studio::forces_changed, this, &FeelPanel::tell_forces);
  connect(&studio_, &Studio::device_changed, this, &FeelPanel::tell_forces);
  connect(&studio_, &Studio::strength_changed, this, &FeelPanel::tell_strength);
  connect(&studio_, &Studio::option_changed, this, [this](const QString& id) {
    if (id == QLatin1String("sheet.material")) tell_material();
  });
  connect(&studio_, &Studio::ticked, this, [this](const TickReport& tick) {
    if (tick.safety.state != told_state_) tell_forces();
  });
  tell_forces();
  tell_strength();
  tell_material();
  // The reliefs take some 10 ms each to make: not while the window opens.
  maker_.start([this] {
    for (const SurfaceMaterial& material : surface_materials()) surface_grain(material);
    QMetaObject::invokeMethod(this, &FeelPanel::draw_swatches, Qt::QueuedConnection);
  });
}

QWidget* FeelPanel::make_strength() {
  auto* box = new QWidget(this);
  slider_ = new QSlider(Qt::Horizontal, box);
  slider_->setRange(0, 100);
  slider_->setSingleStep(kPercentStep);
  slider_->setPageStep(kPercentPage);
  slider_->setAccessibleName(tr("Strength of all forces"));
  percent_ = new QSpinBox(box);
  percent_->setRange(0, 100);
  percent_->setSingleStep(kPercentStep);
  percent_->setSuffix(tr(" %"));
  percent_->setAccessibleName(tr("Strength of all forces in per cent"));
  connect(slider_, &QSlider::valueChanged, this,
          [this](int percent) { choose_strength(studio_, 0.01 * percent); });
  connect(percent_, &QSpinBox::valueChanged, this,
          [this](int percent) { choose_strength(studio_, 0.01 * percent); });
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins({});
  grid->addWidget(heading(tr("&Strength"), slider_, box), 0, 0, 1, 2);
  grid->addWidget(slider_, 1, 0);
  grid->addWidget(percent_, 1, 1);
  return box;
}

QWidget* FeelPanel::make_materials() {
  auto* box = new QWidget(this);
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins({});
  materials_ = new QButtonGroup(box);
  int index = 0;
  for (const SurfaceMaterial& material : surface_materials()) {
    auto* button = new QToolButton(box);
    button->setCheckable(true);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize(kSwatchPx);
    button->setText(material_label(material));
    button->setToolTip(material_words(material));
    button->setAccessibleDescription(material_words(material));
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setFocusPolicy(Qt::StrongFocus);
    materials_->addButton(button, index);
    grid->addWidget(button, 1 + index / 2, index % 2);
    ++index;
  }
  connect(materials_, &QButtonGroup::idClicked, this, [this](int id) {
    choose_material(studio_, id_of(surface_materials()[static_cast<std::size_t>(id)]));
  });
  material_ = new QLabel(box);
  material_->setWordWrap(true);
  grid->addWidget(heading(tr("Sh&eet"), materials_->button(0), box), 0, 0, 1, 2);
  grid->addWidget(material_, 1 + (index + 1) / 2, 0, 1, 2);
  return box;
}

void FeelPanel::tell_forces() {
  SafetyReport safety = studio_.tick().safety;
  told_state_ = safety.state;
  // Switched on, and no tick has come since: never "off" while a force may come.
  if (studio_.forces_are_on() && safety.state == SafetyState::kOff) {
    safety.state = SafetyState::kEngaging;
  }
  const bool has_motors = studio_.device().device().capabilities().has_force();
  const bool on = studio_.forces_are_on();
  const SafetyWords words = words_for(safety, has_motors, on);
  // The button says what it does, the line below it what is.
  forces_->setText(on ? tr("Stop forces") : tr("Switch forces on"));
  forces_->setIcon(on ? stop_icon(palette(), kIconPx, devicePixelRatioF())
                      : QIcon(level_icon(FeelLevel::kOn, palette(), kIconPx, devicePixelRatioF())));
  forces_->setToolTip(on ? tr("No force, at once (Esc twice)") : tr("Let the pen be pushed"));
  forces_->setPalette(on ? stop_palette(palette()) : palette());
  QStringList text{words.state + QLatin1Char('.')};
  if (!words.detail.isEmpty()) text << words.detail;
  if (on && safety.state != SafetyState::kLatched) text << tr("Esc twice stops them too.");
  words_->setText(text.join(QLatin1Char(' ')));
  forces_->setAccessibleDescription(words_->text());
}

void FeelPanel::tell_strength() {
  const int percent = qRound(100.0 * studio_.strength());
  const QSignalBlocker quiet_slider(slider_), quiet_percent(percent_);
  slider_->setValue(percent);
  percent_->setValue(percent);
}

void FeelPanel::tell_material() {
  const SurfaceMaterial& chosen = studio_.session().sheet().material();
  int index = 0;
  for (const SurfaceMaterial& material : surface_materials()) {
    if (material.id == chosen.id) materials_->button(index)->setChecked(true);
    ++index;
  }
  material_->setText(material_words(chosen));
}

void FeelPanel::draw_swatches() {
  int index = 0;
  for (const SurfaceMaterial& material : surface_materials()) {
    materials_->button(index++)->setIcon(
        material_icon(material, palette(), kSwatchPx, devicePixelRatioF()));
  }
}

void FeelPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && materials_ &&
      !materials_->button(0)->icon().isNull()) {
    draw_swatches();
    tell_forces();
  }
  QWidget::changeEvent(event);
}

}  // namespace felt::desktop
