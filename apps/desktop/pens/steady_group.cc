#include "desktop/pens/steady_group.h"

#include <QGridLayout>
#include <QPushButton>
#include <variant>

#include "desktop/pens/steady_dialog.h"

namespace felt::desktop {
namespace {

constexpr auto kSteadyOption = "pencil.steady";

}  // namespace

SteadyGroup::SteadyGroup(Studio& studio, QWidget* parent)
    : QGroupBox(parent), studio_(studio), on_(new QCheckBox), words_(new QLabel) {
  setTitle(tr("Steady hand"));
  auto* layout = new QGridLayout(this);
  on_->setText(tr("&Remove the shaking of the hand"));
  on_->setToolTip(
      tr("Lines become calm while you draw, and calmer when you lift the pen. The command Line as "
         "drawn brings the shaken line back."));
  connect(on_, &QCheckBox::clicked, this, [this](bool on) {
    studio_.apply(SetOption{kSteadyOption, on});
  });
  words_->setWordWrap(true);
  auto* measure = new QPushButton(tr("&Measure\u2026"));
  measure->setToolTip(tr("Measures how the hand shakes, by a spiral of ten seconds."));
  connect(measure, &QPushButton::clicked, this, [this] { SteadyDialog(studio_, this).exec(); });
  connect(&studio_, &Studio::option_changed, this, &SteadyGroup::load);
  layout->addWidget(on_, 0, 0, 1, 2);
  layout->addWidget(words_, 1, 0);
  layout->addWidget(measure, 1, 1, Qt::AlignTop);
  layout->setColumnStretch(0, 1);
  load();
}

void SteadyGroup::load() {
  const Result<OptionValue> on = studio_.session().option(kSteadyOption);
  const auto* is_on = on ? std::get_if<bool>(&*on) : nullptr;
  on_->setChecked(is_on && *is_on);
  words_->setText(
      tr("Set to a hand that shakes %1.").arg(shake_words(shake_of(studio_.session()))));
}

}  // namespace felt::desktop
