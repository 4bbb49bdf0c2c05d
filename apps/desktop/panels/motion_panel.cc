#include "desktop/panels/motion_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <utility>

#include "desktop/engine/settings.h"
#include "desktop/engine/text_of.h"
#include "desktop/panels/key_layers.h"
#include "desktop/panels/panel_setting_keys.h"

namespace felt::desktop {
namespace {

using Do = LayerEvent::Do;

constexpr int kMaxBetween = 1000;
constexpr double kFramesPerSecond = 24.0;
constexpr int kOnionDelayMs = 60;

QSpinBox* frames_box(int least, const char* key, int fallback, QWidget* parent) {
  auto* box = new QSpinBox(parent);
  box->setRange(least, kMaxBetween);
  const QString name = QString::fromLatin1(key);
  box->setValue(static_cast<int>(Settings::the().number(name, fallback)));
  QObject::connect(box, &QSpinBox::valueChanged, parent,
                   [name](int value) { Settings::the().set(name, value); });
  return box;
}

}  // namespace

MotionPanel::MotionPanel(Studio& studio, Actions& actions, QWidget* parent)
    : QWidget(parent),
      studio_(studio),
      list_(new QListWidget(this)),
      between_(frames_box(0, panel_keys::kMotionBetween, panel_keys::kMotionBetweenDefault, this)),
      hold_(frames_box(1, panel_keys::kMotionHold, 1, this)),
      ease_(new QComboBox(this)),
      length_(new QLabel(this)) {
  add_actions(actions);
  build(actions);
  onion_delay_.setSingleShot(true);
  onion_delay_.setInterval(kOnionDelayMs);
  connect(&onion_delay_, &QTimer::timeout, this, &MotionPanel::send_onion);
  connect(&studio_, &Studio::edited, this, &MotionPanel::on_edit);
  connect(&studio_, &Studio::opened, this,
          [this, onion = actions.find(QStringLiteral("view.onion_skin"))] {
            hidden_.clear();
            onion->setChecked(false);
            show_keys();
          });
  connect(&studio_, &Studio::layer_changed, this, [this] {
    show_keys();
    if (is_onion_on_) send_onion();
  });
  show_keys();
}

void MotionPanel::add_actions(Actions& actions) {
  actions.add(QStringLiteral("layer.add_key"), tr("Add &key drawing"), {},
              tr("Adds a layer for the next key drawing"), [this] { add_key(); });
  actions.add_switch(QStringLiteral("view.onion_skin"), tr("&Onion skin"), {},
                     tr("The key drawings before and after the current one shine through"), false,
                     [this](bool on) { set_onion(on); });
  actions.add(QStringLiteral("view.play"), tr("&Play the motion"), {},
              tr("Plays the key drawings and the drawings between them; Esc stops"),
              [this] { Q_EMIT wants_play(); });
  actions.add(QStringLiteral("file.animation"), tr("Export &animation…"), {},
              tr("Write the key drawings and the drawings between them as files"),
              [this] { Q_EMIT wants_export(); });
}

void MotionPanel::build(const Actions& actions) {
  list_->setAccessibleName(tr("Key drawings"));
  list_->setFrameShape(QFrame::NoFrame);
  list_->setToolTip(
      tr("Each layer with lines that is not locked is a key drawing, from the bottom "
         "up"));
  add_ease(tr("Even"), "linear");
  add_ease(tr("Starts slowly"), "ease-in");
  add_ease(tr("Ends slowly"), "ease-out");
  add_ease(tr("Starts and ends slowly"), "ease-in-out");
  const QString ease_key = QString::fromLatin1(panel_keys::kMotionEase);
  ease_->setCurrentIndex(std::max(0, ease_->findData(Settings::the().text(ease_key))));
  connect(ease_, &QComboBox::currentIndexChanged, this,
          [this, ease_key] { Settings::the().set(ease_key, ease_->currentData()); });
  length_->setWordWrap(true);
  auto* form = new QFormLayout;
  form->setContentsMargins(8, 6, 8, 2);
  between_->setToolTip(tr("The number of drawings from one key drawing to the next"));
  hold_->setToolTip(tr("For how many frames each key drawing is shown"));
  form->addRow(tr("In-&betweens:"), between_);
  form->addRow(tr("&Hold:"), hold_);
  form->addRow(tr("&Speed:"), ease_);
  form->addRow(length_);
  auto* grid = new QGridLayout;
  grid->setContentsMargins(6, 2, 6, 6);
  const std::array<std::pair<const char*, QString>, 4> buttons{
      {{"layer.add_key", tr("New key")},
       {"view.onion_skin", tr("Onion skin")},
       {"view.play", tr("Play")},
       {"file.animation", tr("Export…")}}};
  int at = 0;
  for (const auto& [name, label] : buttons) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(actions.find(QString::fromLatin1(name)));
    button->setText(label);  // shorter than in the menu
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    grid->addWidget(button, at / 2, at % 2);
    ++at;
  }
  auto* lines = new QVBoxLayout(this);
  lines->setContentsMargins(0, 0, 0, 0);
  lines->addWidget(list_, 1);
  lines->addLayout(form);
  lines->addLayout(grid);
  connect(between_, &QSpinBox::valueChanged, this, &MotionPanel::show_length);
  connect(hold_, &QSpinBox::valueChanged, this, &MotionPanel::show_length);
  connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (row >= 0 && std::size_t(row) < keys_.size()) choose(keys_[std::size_t(row)]);
  });
}

void MotionPanel::add_ease(const QString& name, const char* ease) {
  ease_->addItem(name, QString::fromLatin1(ease));
}

KeyFilmOptions MotionPanel::options() const {
  KeyFilmOptions options;
  options.between = between_->value();
  options.hold = hold_->value();
  const std::string ease = ease_->currentData().toString().toStdString();
  if (Result<Ease> parsed = Ease::parse(ease)) options.ease = *std::move(parsed);
  return options;
}

void MotionPanel::choose(LayerId key) {
  const Layer* layer = studio_.session().document().layer(key);
  if (!layer || key == studio_.session().layer()) return;
  if (!layer->visible && !studio_.apply(LayerEvent{Do::kShow, key})) return;
  std::erase(hidden_, key);
  if (!studio_.apply(LayerEvent{Do::kUse, key})) return;
  if (is_onion_on_) hide_others();
}

void MotionPanel::add_key() {
  if (studio_.apply(LayerEvent{Do::kAdd, {}}) && is_onion_on_) hide_others();
}

/// Hides all key drawings but the current layer.
void MotionPanel::hide_others() {
  const LayerId current = studio_.session().layer();
  for (const LayerId key : key_layers(studio_.session().document())) {
    if (key == current || !studio_.session().document().layer(key)->visible) continue;
    if (studio_.apply(LayerEvent{Do::kHide, key})) hidden_.push_back(key);
  }
}

void MotionPanel::set_onion(bool on) {
  if (std::exchange(is_onion_on_, on) == on) return;
  if (on) {
    hide_others();
  } else {
    for (const LayerId key : std::exchange(hidden_, {})) {
      const Layer* layer = studio_.session().document().layer(key);
      if (layer && !layer->visible) studio_.apply(LayerEvent{Do::kShow, key});
    }
  }
  send_onion();
}

void MotionPanel::send_onion() {
  onion_delay_.stop();
  if (!is_onion_on_) {
    Q_EMIT onion_changed(std::nullopt);
    return;
  }
  Q_EMIT onion_changed(onion_skin(studio_.session().document(), studio_.session().layer()));
}

void MotionPanel::on_edit(const Edit& edit) {
  show_keys();
  if (!is_onion_on_) return;
  const LayerId current = studio_.session().layer();
  const auto is_elsewhere = [current](const auto& change) {
    return (change.before && change.before_place.layer != current) ||
           (change.after && change.after_place.layer != current);
  };
  // The onion skin does not contain the current layer.
  if (!edit.layers.empty() || std::any_of(edit.changes.begin(), edit.changes.end(), is_elsewhere) ||
      std::any_of(edit.fills.begin(), edit.fills.end(), is_elsewhere)) {
    onion_delay_.start();
  }
}

void MotionPanel::show_keys() {
  const Document& document = studio_.session().document();
  keys_ = key_layers(document);
  const QSignalBlocker quiet(list_);
  while (list_->count() > static_cast<int>(keys_.size())) delete list_->takeItem(0);
  while (list_->count() < static_cast<int>(keys_.size())) list_->addItem(QString());
  int current = -1;
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    const int row = static_cast<int>(i);
    list_->item(row)->setText(
        tr("%1: %2").arg(QLocale().toString(row + 1), text_of(document.layer(keys_[i])->name)));
    if (keys_[i] == studio_.session().layer()) current = row;
  }
  list_->setCurrentRow(current);
  show_length();
}

void MotionPanel::show_length() {
  const int keys = static_cast<int>(keys_.size());
  if (keys < 2) {
    length_->setText(tr("Draw the second key drawing on a layer of its own."));
    return;
  }
  const int frames = keys * hold_->value() + (keys - 1) * between_->value();
  const QLocale locale;
  length_->setText(
      tr("%1 frames, %2 s")
          .arg(locale.toString(frames), locale.toString(frames / kFramesPerSecond, 'f', 1)));
}

}  // namespace felt::desktop
