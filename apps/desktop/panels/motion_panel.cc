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

#include "desktop/panels/layers_model.h"
#include "desktop/panels/onion_skin.h"
#include "felt/motion/key_layers.h"

namespace felt::desktop {
namespace {

using Do = LayerEvent::Do;

constexpr double kFramesPerSecond = 24.0;
constexpr int kOnionDelayMs = 60;

QSpinBox* frames_box(int least, int most, QWidget* parent) {
  auto* box = new QSpinBox(parent);
  box->setRange(least, most);
  box->setKeyboardTracking(false);  // a number is one change, not each of its digits
  return box;
}

/// Shows a number without a signal, unless it is shown already: a number that is being typed stays.
void show_number(QSpinBox& box, int number) {
  if (box.value() == number) return;
  const QSignalBlocker quiet(box);
  box.setValue(number);
}

}  // namespace

MotionPanel::MotionPanel(Studio& studio, Actions& actions, QWidget* parent)
    : QWidget(parent),
      studio_(studio),
      list_(new QListWidget(this)),
      between_(frames_box(0, KeyTiming::kMaxBetween, this)),
      hold_(frames_box(1, KeyTiming::kMaxHold, this)),
      ease_(new QComboBox(this)),
      length_(new QLabel(this)) {
  add_actions(actions);
  build(actions);
  onion_delay_.setSingleShot(true);
  onion_delay_.setInterval(kOnionDelayMs);
  connect(&onion_delay_, &QTimer::timeout, this, &MotionPanel::show_onion);
  connect(&studio_, &Studio::edited, this, &MotionPanel::on_edit);
  connect(&studio_, &Studio::opened, this,
          [this, onion = actions.find(QStringLiteral("view.onion_skin"))] {
            onion->setChecked(false);
            show_keys();
          });
  connect(&studio_, &Studio::layer_changed, this, [this] {
    show_keys();
    if (is_onion_on_) onion_delay_.start();
  });
  show_keys();
}

void MotionPanel::add_actions(Actions& actions) {
  actions.add(QStringLiteral("layer.add_key"), tr("Add &key drawing"), {},
              tr("Adds a layer for the next key drawing"), [this] { add_key(); });
  actions.add(QStringLiteral("layer.same_timing"), tr("Same &timing for all key drawings"), {},
              tr("Gives the in-betweens, hold and speed of this key drawing to all"),
              [this] { use_timing_for_all(); });
  actions.add_switch(QStringLiteral("view.onion_skin"), tr("&Onion skin"), {},
                     tr("The key drawings before and after the current one shine through"), false,
                     [this](bool on) { set_onion(on); });
  actions.add_switch(QStringLiteral("view.correct_matches"), tr("Correct &matches"), {},
                     tr("Shows which line becomes which, and lets you draw from line to line"),
                     false, [this](bool on) { Q_EMIT wants_matches(on); });
  actions.add(QStringLiteral("view.play"), tr("&Play the motion"), {},
              tr("Plays the key drawings and the drawings between them; Esc stops"),
              [this] { Q_EMIT wants_play(); });
  actions.add(QStringLiteral("file.animation"), tr("Export &animation…"), {},
              tr("Write the key drawings and the drawings between them as files"),
              [this] { Q_EMIT wants_export(); });
}

/// Returns the buttons of the commands for key drawings.
QGridLayout* MotionPanel::make_buttons(const Actions& actions) {
  auto* grid = new QGridLayout;
  grid->setContentsMargins(6, 2, 6, 6);
  const std::array<std::pair<const char*, QString>, 6> buttons{
      {{"layer.add_key", tr("New key")},
       {"view.onion_skin", tr("Onion skin")},
       {"view.correct_matches", tr("Matches")},
       {"layer.same_timing", tr("Same for all")},
       {"view.play", tr("Play")},
       {"file.animation", tr("Export…")}}};
  int at = 0;
  for (const auto& [name, label] : buttons) {
    auto* button = new QToolButton(this);
    QAction* action = actions.find(QString::fromLatin1(name));
    // Shorter than in the menu. A text of the button itself would be lost when the action changes.
    action->setIconText(label);
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    grid->addWidget(button, at / 3, at % 3);
    ++at;
  }
  return grid;
}

void MotionPanel::build(const Actions& actions) {
  list_->setAccessibleName(tr("Key drawings"));
  list_->setFrameShape(QFrame::NoFrame);
  list_->setToolTip(
      tr("Each layer with lines that is not locked is a key drawing, from the bottom "
         "up"));
  add_ease(tr("Even"), {});
  add_ease(tr("Starts slowly"), {0.42, 0.0, 1.0, 1.0});
  add_ease(tr("Ends slowly"), {0.0, 0.0, 0.58, 1.0});
  add_ease(tr("Starts and ends slowly"), {0.42, 0.0, 0.58, 1.0});
  length_->setWordWrap(true);
  length_->setObjectName(QStringLiteral("length"));
  auto* form = new QFormLayout;
  form->setContentsMargins(8, 6, 8, 2);
  between_->setToolTip(tr("The number of drawings from this key drawing to the next"));
  hold_->setToolTip(tr("For how many frames this key drawing is shown"));
  ease_->setToolTip(tr("The speed from this key drawing to the next"));
  form->addRow(tr("In-&betweens:"), between_);
  form->addRow(tr("&Hold:"), hold_);
  form->addRow(tr("&Speed:"), ease_);
  form->addRow(length_);
  auto* lines = new QVBoxLayout(this);
  lines->setContentsMargins(0, 0, 0, 0);
  lines->addWidget(list_, 1);
  lines->addLayout(form);
  lines->addLayout(make_buttons(actions));
  const auto change = [this](TimingEvent event) {
    event.layers = {studio_.session().layer()};
    studio_.apply(std::move(event));
    show_timing();  // a change during a gesture has no effect
  };
  connect(between_, &QSpinBox::valueChanged, this,
          [change](int frames) { change({.between = frames}); });
  connect(hold_, &QSpinBox::valueChanged, this, [change](int frames) { change({.hold = frames}); });
  connect(ease_, &QComboBox::activated, this, [this, change](int item) {
    if (item >= 0 && std::size_t(item) < eases_.size()) change({.ease = eases_[std::size_t(item)]});
  });
  connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (row >= 0 && std::size_t(row) < keys_.size()) choose(keys_[std::size_t(row)]);
  });
}

void MotionPanel::add_ease(const QString& name, const EaseCurve& ease) {
  ease_->addItem(name);
  eases_.push_back(ease);
}

KeyTiming MotionPanel::timing() const {
  const Layer* layer = studio_.session().document().layer(studio_.session().layer());
  return timing_or_default(layer ? layer->timing : nullptr);
}

void MotionPanel::use_timing_for_all() {
  const KeyTiming timing = this->timing();
  if (!keys_.empty()) {
    studio_.apply(TimingEvent{keys_, timing.between, timing.hold, timing.ease, std::nullopt});
  }
}

void MotionPanel::choose(LayerId key) {
  const Layer* layer = studio_.session().document().layer(key);
  if (!layer || key == studio_.session().layer()) return;
  if (!layer->visible && !studio_.apply(LayerEvent{Do::kShow, key})) return;
  if (studio_.apply(LayerEvent{Do::kUse, key}) && is_onion_on_) show_onion();
}

void MotionPanel::add_key() {
  LayerEvent event{Do::kAdd, {}};
  event.timing_of = studio_.session().layer();
  if (studio_.apply(std::move(event)) && is_onion_on_) show_onion();
}

void MotionPanel::set_onion(bool on) {
  if (std::exchange(is_onion_on_, on) != on) show_onion();
}

/// Shows only the current key drawing, and the onion skin of its neighbours; or all layers.
void MotionPanel::show_onion() {
  onion_delay_.stop();
  const Session& session = studio_.session();
  std::vector<LayerId> others;
  if (is_onion_on_) others = key_layers(session.document());
  std::erase(others, session.layer());
  std::sort(others.begin(), others.end());
  const auto is_late = [&] { return others != session.out_of_view(); };
  if (is_late() && !session.gesture_in_progress()) studio_.apply(UseView{others});
  // A view has no effect during a gesture, which the apply may have begun: it waits for the end.
  if (is_late() && session.gesture_in_progress()) return onion_delay_.start();
  if (!is_onion_on_) {
    Q_EMIT onion_changed(std::nullopt);
    return;
  }
  Q_EMIT onion_changed(onion_skin(session.document(), session.layer()));
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

/// Adds the current layer to the list if it will be a key drawing as soon as something is drawn on
/// it, so that a new key drawing is in the list at once. Returns its index.
std::optional<std::size_t> MotionPanel::add_begun_key() {
  const Document& document = studio_.session().document();
  const LayerId current = studio_.session().layer();
  const Layer* layer = document.layer(current);
  const bool is_empty = layer && layer->strokes.empty() && layer->fills.empty() && !layer->picture;
  if (keys_.empty() || !is_empty || layer->locked) return std::nullopt;
  std::size_t index = 0;
  for (const Layer& below : document.layers()) {
    if (below.id == current) break;
    if (index < keys_.size() && keys_[index] == below.id) ++index;
  }
  keys_.insert(keys_.begin() + static_cast<std::ptrdiff_t>(index), current);
  return index;
}

void MotionPanel::show_keys() {
  const Document& document = studio_.session().document();
  keys_ = key_layers(document);
  const std::optional<std::size_t> begun = add_begun_key();
  const QSignalBlocker quiet(list_);
  while (list_->count() > static_cast<int>(keys_.size())) delete list_->takeItem(0);
  while (list_->count() < static_cast<int>(keys_.size())) list_->addItem(QString());
  int current = -1;
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    const int row = static_cast<int>(i);
    const QString name = LayersModel::shown_name(*document.layer(keys_[i]));
    list_->item(row)->setText(
        (i == begun ? tr("%1: %2 (empty)") : tr("%1: %2")).arg(QLocale().toString(row + 1), name));
    if (keys_[i] == studio_.session().layer()) current = row;
  }
  list_->setCurrentRow(current);
  show_timing();
  show_length();
}

void MotionPanel::show_timing() {
  const KeyTiming timing = this->timing();
  show_number(*between_, timing.between);
  show_number(*hold_, timing.hold);
  const auto found = std::find(eases_.begin(), eases_.end(), timing.ease);
  const int item = static_cast<int>(found - eases_.begin());
  const bool is_listed = found != eases_.end();
  const int listed = static_cast<int>(eases_.size());
  if (ease_->count() > listed && is_listed) ease_->removeItem(listed);
  if (ease_->count() == listed && !is_listed) ease_->addItem(tr("Another curve"));
  ease_->setCurrentIndex(item);
}

void MotionPanel::show_length() {
  if (key_layers(studio_.session().document()).size() < 2) {
    length_->setText(tr("Draw the second key drawing on a layer of its own."));
    return;
  }
  const auto frames = static_cast<qlonglong>(film_frames(studio_.session().document()));
  const QLocale locale;
  length_->setText(
      tr("%1 frames, %2 s")
          .arg(locale.toString(frames),
               locale.toString(static_cast<double>(frames) / kFramesPerSecond, 'f', 1)));
}

}  // namespace felt::desktop
