#include "desktop/feel/feel_panel.h"

#include <QEvent>
#include <QGridLayout>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <span>
#include <utility>

#include "desktop/feel/feel_actions.h"
#include "desktop/feel/feel_icons.h"
#include "desktop/feel/material_words.h"
#include "desktop/feel/safety_words.h"
#include "felt/haptics/bricks/drawing_feel.h"

namespace felt::desktop {
namespace {

constexpr QSize kSwatchPx{64, 26};
constexpr int kRoomPx = 8;  // margin around picture and text
constexpr int kPanelIconPx = 22;
constexpr int kScaleStep = 5, kScalePage = 20;

QLabel* heading(const QString& text, QWidget* buddy, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setBuddy(buddy);
  return label;
}

}  // namespace

FeelPanel::FeelPanel(Studio& studio, QWidget* parent)
    : QWidget(parent), studio_(studio), forces_(new QPushButton(this)), words_(new QLabel(this)) {
  forces_->setIconSize({kPanelIconPx, kPanelIconPx});
  forces_->setMinimumHeight(5 * fontMetrics().height() / 2);
  QFont large = forces_->font();
  large.setPointSizeF(1.2 * large.pointSizeF());
  forces_->setFont(large);
  words_->setWordWrap(true);
  connect(forces_, &QPushButton::clicked, this, [this] {
    studio_.loop().set_forces(!studio_.loop().forces_are_on());
    report_forces();
  });
  auto* rows = new QVBoxLayout(this);
  rows->addWidget(forces_);
  rows->addWidget(words_);
  rows->addWidget(make_strength());
  rows->addWidget(make_materials());
  rows->addStretch(1);
  connect(&studio_.loop(), &HapticLoop::forces_changed, this, &FeelPanel::report_forces);
  connect(&studio_.loop(), &HapticLoop::device_changed, this, &FeelPanel::report_forces);
  connect(&studio_.loop(), &HapticLoop::device_status_changed, this, &FeelPanel::report_forces);
  connect(&studio_.loop(), &HapticLoop::strength_changed, this, &FeelPanel::report_strength);
  connect(&studio_, &Studio::option_changed, this, [this](const QString& id) {
    if (id == QLatin1String("surface.material")) report_material();
  });
  const auto follow_materials = [this] {
    fill_materials();
    report_material();
    make_reliefs();
  };
  connect(&studio_, &Studio::materials_changed, this, follow_materials);
  connect(&studio_, &Studio::opened, this, follow_materials);
  connect(&studio_.loop(), &HapticLoop::ticked, this, [this](const TickReport& tick) {
    if (tick.safety.state != reported_state_) report_forces();
  });
  report_forces();
  report_strength();
  report_material();
  make_reliefs();
}

/// Makes the pictures of the reliefs on another thread, because each takes some 10 ms.
void FeelPanel::make_reliefs() {
  const std::span<const SurfaceMaterial> all = studio_.materials().surfaces();
  maker_.start([this, surfaces = std::vector<SurfaceMaterial>(all.begin(), all.end())] {
    for (const SurfaceMaterial& surface : surfaces) surface_grain(surface);
    QMetaObject::invokeMethod(this, &FeelPanel::draw_swatches, Qt::QueuedConnection);
  });
}

QWidget* FeelPanel::make_strength() {
  auto* box = new QWidget(this);
  slider_ = new QSlider(Qt::Horizontal, box);
  slider_->setRange(0, 100);
  slider_->setSingleStep(kScaleStep);
  slider_->setPageStep(kScalePage);
  slider_->setAccessibleName(tr("Strength of all forces"));
  percent_ = new QSpinBox(box);
  percent_->setRange(0, 100);
  percent_->setSingleStep(kScaleStep);
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
  auto* rows = new QVBoxLayout(box);
  rows->setContentsMargins({});
  auto* head = new QHBoxLayout;
  auto* edit = new QToolButton(box);
  edit->setText(tr("Edit\u2026"));
  edit->setToolTip(tr("Change how surfaces and media feel, look and sound"));
  edit->setAccessibleName(tr("Edit surfaces and media"));
  edit->setFocusPolicy(Qt::StrongFocus);
  connect(edit, &QToolButton::clicked, this, &FeelPanel::wants_editor);
  materials_ = new QButtonGroup(box);
  connect(materials_, &QButtonGroup::idClicked, this, [this](int index) {
    choose_material(studio_, QString::fromStdString(ids_[static_cast<std::size_t>(index)]));
  });
  grid_ = new QGridLayout;
  material_ = new QLabel(box);
  material_->setWordWrap(true);
  fill_materials();
  head->addWidget(heading(tr("Surfac&e"), materials_->button(0), box), 1);
  head->addWidget(edit);
  rows->addLayout(head);
  rows->addLayout(grid_);
  rows->addWidget(material_);
  return box;
}

void FeelPanel::fill_materials() {
  std::vector<std::string> ids;
  for (const SurfaceMaterial& material : studio_.materials().surfaces()) ids.push_back(material.id);
  const auto count = static_cast<int>(ids.size());
  for (int i = static_cast<int>(ids_.size()); i < count; ++i) {
    auto* button = new QToolButton(this);
    button->setCheckable(true);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize(kSwatchPx);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    // Some styles reserve too little height for the text below a picture and would cut it off.
    button->setMinimumHeight(kSwatchPx.height() + button->fontMetrics().height() + kRoomPx);
    button->setFocusPolicy(Qt::StrongFocus);
    materials_->addButton(button, i);
    grid_->addWidget(button, i / 2, i % 2);
  }
  for (int i = static_cast<int>(ids_.size()) - 1; i >= count; --i) delete materials_->button(i);
  ids_ = std::move(ids);
  for (int i = 0; i < count; ++i) {
    const SurfaceMaterial& material = studio_.materials().surfaces()[static_cast<std::size_t>(i)];
    QAbstractButton* button = materials_->button(i);
    button->setText(material_label(material));
    button->setToolTip(material_words(material));
    button->setAccessibleDescription(material_words(material));
  }
}

QAbstractButton* FeelPanel::button_of(const std::string& id) const {
  const auto at = std::find(ids_.begin(), ids_.end(), id);
  return at == ids_.end() ? nullptr : materials_->button(static_cast<int>(at - ids_.begin()));
}

void FeelPanel::report_forces() {
  SafetyReport safety = studio_.loop().tick().safety;
  reported_state_ = safety.state;
  // Forces were switched on, but no tick has arrived since then. The panel must not show "off"
  // while a force may begin at any moment.
  if (studio_.loop().forces_are_on() && safety.state == SafetyState::kOff) {
    safety.state = SafetyState::kEngaging;
  }
  const bool has_motors = studio_.loop().device().device().capabilities().has_force();
  const bool on = studio_.loop().forces_are_on();
  const SafetyWords words =
      words_for(safety, has_motors, on, studio_.loop().device_status().last_fault);
  // The button's text is its effect. The line below the button shows the present state.
  forces_->setText(on ? tr("Stop forces") : tr("Switch forces on"));
  forces_->setIcon(
      on ? stop_icon(palette(), kPanelIconPx, devicePixelRatioF())
         : QIcon(level_icon(FeelLevel::kOn, palette(), kPanelIconPx, devicePixelRatioF())));
  forces_->setToolTip(on ? tr("Stops all forces immediately (Esc twice)")
                         : tr("Let forces act on the pen"));
  forces_->setPalette(on ? stop_palette(palette()) : palette());
  QStringList text{words.state + QLatin1Char('.')};
  if (!words.detail.isEmpty()) text << words.detail;
  if (on && safety.state != SafetyState::kLatched) text << tr("Esc twice stops them too.");
  words_->setText(text.join(QLatin1Char(' ')));
  forces_->setAccessibleDescription(words_->text());
}

void FeelPanel::report_strength() {
  const int percent = qRound(100.0 * studio_.loop().strength());
  const QSignalBlocker quiet_slider(slider_), quiet_percent(percent_);
  slider_->setValue(percent);
  percent_->setValue(percent);
}

void FeelPanel::report_material() {
  const SurfaceMaterial& chosen = studio_.session().surface();
  if (QAbstractButton* button = button_of(chosen.id)) button->setChecked(true);
  material_->setText(material_words(chosen));
}

void FeelPanel::draw_swatches() {
  for (const SurfaceMaterial& material : studio_.materials().surfaces()) {
    QAbstractButton* button = button_of(material.id);
    if (!button) continue;
    button->setIcon(material_icon(material, palette(), kSwatchPx, devicePixelRatioF()));
  }
}

void FeelPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && materials_ &&
      !materials_->button(0)->icon().isNull()) {
    draw_swatches();
    report_forces();
  }
  QWidget::changeEvent(event);
}

}  // namespace felt::desktop
