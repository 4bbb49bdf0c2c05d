#include "desktop/panels/option_row.h"

#include <QAbstractItemView>
#include <QButtonGroup>
#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPalette>
#include <QSignalBlocker>
#include <QStyle>
#include <algorithm>

#include "desktop/engine/tool_texts.h"
#include "desktop/panels/tool_icons.h"

namespace felt::desktop {
namespace {

constexpr std::size_t kMaxButtons = 4;  // if an option has more choices, they are a list
constexpr int kMaxInLine = 3;           // four buttons are two lines of two
constexpr int kLineGapPx = 2;
constexpr int kResetIconPx = 14;
constexpr int kResetPx = 18;  // size of the button, which must not be higher than the name beside
                              // it
constexpr int kChoiceRoomPx = 7;
constexpr double kChoiceRoundPx = 3.5;

/// A label that elides the name if it is too narrow. The tool tip explains the option.
class NameLabel : public QLabel {
 public:
  using QLabel::QLabel;

  [[nodiscard]] QSize minimumSizeHint() const override {
    return {fontMetrics().averageCharWidth() * 6, QLabel::minimumSizeHint().height()};
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    style()->drawItemText(&painter, rect(), Qt::AlignLeft | Qt::AlignVCenter, palette(),
                          isEnabled(), fontMetrics().elidedText(text(), Qt::ElideRight, width()),
                          foregroundRole());
  }
};

/// One of a few choices side by side. The chosen one is filled and bold, so that it is visible in
/// every theme.
class ChoiceButton : public QToolButton {
 public:
  using QToolButton::QToolButton;

  [[nodiscard]] QSize sizeHint() const override {
    QFont font = this->font();
    font.setBold(true);
    const QFontMetrics metrics(font);
    return {metrics.horizontalAdvance(text()) + 2 * kChoiceRoomPx,
            metrics.height() + kChoiceRoomPx};
  }
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPalette& colors = palette();
    const bool lit = underMouse() && !isChecked();
    const QRectF box = QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0);
    painter.setBrush(colors.color(isChecked() ? QPalette::Highlight
                                  : lit       ? QPalette::Midlight
                                              : QPalette::Button));
    painter.setPen(
        QPen(colors.color(hasFocus() ? QPalette::Text : QPalette::Mid), hasFocus() ? 1.6 : 1.0));
    painter.drawRoundedRect(box, kChoiceRoundPx, kChoiceRoundPx);
    QFont font = this->font();
    font.setBold(isChecked());
    painter.setFont(font);
    painter.setPen(colors.color(isChecked() ? QPalette::HighlightedText : QPalette::ButtonText));
    painter.drawText(rect(), Qt::AlignCenter, text());
  }
};

}  // namespace

OptionRow::OptionRow(const OptionSpec& spec, QWidget* parent)
    : QWidget(parent),
      spec_(spec),
      scale_(spec),
      label_(translated(spec.label)),
      lines_(new QVBoxLayout(this)),
      line_(new QHBoxLayout) {
  setObjectName(QString::fromUtf8(spec.id.data(), qsizetype(spec.id.size())));
  setToolTip(translated(spec.help));
  setWhatsThis(translated(spec.help));
  lines_->setContentsMargins(0, 0, 0, 0);
  lines_->setSpacing(kLineGapPx);
  line_->setSpacing(4);
  lines_->addLayout(line_);
  reset_ = make_reset();
  if (spec.kind == OptionKind::kNumber) make_number();
  if (spec.kind == OptionKind::kSwitch) make_switch();
  if (spec.kind == OptionKind::kChoice) make_choice();
  show_value(default_value(spec));
}

void OptionRow::add_name(QWidget* buddy) {
  auto* name = new NameLabel(label_, this);
  name->setBuddy(buddy);
  line_->addWidget(name, 1);
  line_->addWidget(reset_);
}

QHBoxLayout* OptionRow::add_line() {
  auto* line = new QHBoxLayout;
  line->setSpacing(kLineGapPx * 4);
  lines_->addLayout(line);
  return line;
}

QToolButton* OptionRow::make_reset() {
  auto* button = new QToolButton(this);
  button->setIcon(icon_of("reset"));
  button->setIconSize({kResetIconPx, kResetIconPx});
  button->setFixedSize(kResetPx, kResetPx);
  button->setAutoRaise(true);
  button->setObjectName(QStringLiteral("reset"));
  const QString fallback = value_text(spec_, default_value(spec_));
  button->setAccessibleName(tr("Reset %1").arg(label_));
  button->setToolTip(tr("Back to %1").arg(fallback));
  QSizePolicy policy = button->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  button->setSizePolicy(policy);
  connect(button, &QToolButton::clicked, this, [this] { Q_EMIT chosen(default_value(spec_)); });
  return button;
}

void OptionRow::dress(QWidget* control, const QString& name) {
  control->setAccessibleName(name);
  control->setAccessibleDescription(translated(spec_.help));
  control->setToolTip(translated(spec_.help));
  control->setWhatsThis(translated(spec_.help));
  if (control->focusPolicy() == Qt::WheelFocus) control->setFocusPolicy(Qt::StrongFocus);
}

void OptionRow::make_number() {
  const double factor = scale_.shown_per_unit();
  spin_ = new QDoubleSpinBox(this);
  spin_->setDecimals(scale_.decimals());
  spin_->setRange(spec_.min * factor, spec_.max * factor);
  spin_->setSuffix(scale_.suffix());
  spin_->setKeyboardTracking(false);
  spin_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  spin_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  dress(spin_, label_);
  slider_ = new QSlider(Qt::Horizontal, this);
  slider_->setRange(0, OptionScale::kPlaces);
  slider_->setSingleStep(OptionScale::kPlaces / 100);
  slider_->setPageStep(OptionScale::kPlaces / 10);
  slider_->setMinimumWidth(60);
  dress(slider_, label_);
  add_name(spin_);
  QHBoxLayout* line = add_line();
  line->addWidget(slider_, 1);
  line->addWidget(spin_);
  connect(spin_, &QDoubleSpinBox::valueChanged, this, [this, factor](double shown) {
    Q_EMIT chosen(std::clamp(shown / factor, spec_.min, spec_.max));
  });
  connect(slider_, &QSlider::valueChanged, this,
          [this](int place) { Q_EMIT chosen(scale_.value_at(place)); });
}

void OptionRow::make_switch() {
  check_ = new QCheckBox(label_, this);
  dress(check_, label_);
  line_->addWidget(check_, 1);
  line_->addWidget(reset_);
  connect(check_, &QAbstractButton::toggled, this, [this](bool on) { Q_EMIT chosen(on); });
}

void OptionRow::make_choice() {
  if (spec_.choices.size() <= kMaxButtons) {
    make_buttons();
  } else {
    make_list();
  }
}

void OptionRow::make_buttons() {
  add_name(nullptr);
  auto* box = new QWidget(this);
  box->setAccessibleName(label_);
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(0);
  const int count = static_cast<int>(spec_.choices.size());
  const int columns = count > kMaxInLine ? (count + 1) / 2 : count;
  auto* group = new QButtonGroup(box);
  for (const std::string_view choice : spec_.choices) {
    auto* button = new ChoiceButton(box);
    button->setText(choice_text(choice));
    button->setCheckable(true);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    dress(button, tr("%1: %2").arg(label_, button->text()));
    group->addButton(button);
    const int at = static_cast<int>(buttons_.size());
    grid->addWidget(button, at / columns, at % columns);
    buttons_.push_back(button);
    connect(button, &QToolButton::clicked, this,
            [this, choice] { Q_EMIT chosen(std::string(choice)); });
  }
  lines_->addWidget(box);
}

void OptionRow::make_list() {
  list_ = new QComboBox(this);
  for (const std::string_view choice : spec_.choices) list_->addItem(choice_text(choice));
  dress(list_, label_);
  list_->view()->setAccessibleName(label_);
  add_name(list_);
  add_line()->addWidget(list_, 1);
  connect(list_, &QComboBox::activated, this, [this](int i) {
    Q_EMIT chosen(std::string(spec_.choices[static_cast<std::size_t>(i)]));
  });
}

void OptionRow::show_number(double value) {
  const QSignalBlocker no_spin(spin_), no_slider(slider_);
  spin_->setValue(value * scale_.shown_per_unit());
  // If the slider's position already means this value, it does not move, because the user may be
  // dragging it.
  if (scale_.value_at(slider_->value()) != value) slider_->setValue(scale_.place_of(value));
  slider_->setAccessibleDescription(scale_.text_of(value));
}

int OptionRow::number_width() const {
  return spin_ ? spin_->sizeHint().width() : 0;
}

void OptionRow::set_number_width(int px) {
  if (spin_) spin_->setFixedWidth(px);
}

void OptionRow::set_default(const OptionValue& value) {
  if (const auto* number = std::get_if<double>(&value)) spec_.fallback = *number;
  if (const auto* on = std::get_if<bool>(&value)) spec_.fallback = *on ? 1.0 : 0.0;
  if (const auto* choice = std::get_if<std::string>(&value)) {
    const auto at = std::find(spec_.choices.begin(), spec_.choices.end(), *choice);
    if (at != spec_.choices.end()) {
      spec_.fallback = static_cast<double>(at - spec_.choices.begin());
    }
  }
  reset_->setToolTip(tr("Back to %1").arg(value_text(spec_, value)));
}

void OptionRow::show_value(const OptionValue& value) {
  if (spin_) show_number(std::get<double>(value));
  if (check_) {
    const QSignalBlocker quiet(check_);
    check_->setChecked(std::get<bool>(value));
  }
  for (std::size_t i = 0; i < spec_.choices.size(); ++i) {
    if (std::get<std::string>(value) != spec_.choices[i]) continue;
    if (list_) list_->setCurrentIndex(static_cast<int>(i));
    if (!buttons_.empty()) buttons_[i]->setChecked(true);
  }
  reset_->setVisible(value != default_value(spec_));
}

}  // namespace felt::desktop
