#include "desktop/window/general_page.h"

#include <QLabel>

#include "desktop/feel/feel_setting_keys.h"
#include "desktop/feel/friction_sound.h"
#include "desktop/window/setting_rows.h"
#include "desktop/window/window_setting_keys.h"

namespace felt::desktop {
namespace {

QLabel* note_with(const QString& text, QWidget* parent) {
  auto* note = new QLabel(text, parent);
  note->setForegroundRole(QPalette::PlaceholderText);
  note->setWordWrap(true);
  return note;
}

}  // namespace

GeneralPage::GeneralPage(QWidget* parent) : QWidget(parent) {
  QComboBox* theme = setting_choice(window_keys::kTheme, QStringLiteral("system"),
                                    {{QStringLiteral("system"), tr("Same as the desktop")},
                                     {QStringLiteral("light"), tr("Light")},
                                     {QStringLiteral("dark"), tr("Dark")}},
                                    tr("Theme"), this);
  QComboBox* language = setting_choice(window_keys::kLanguage, QString(),
                                       {{QString(), tr("Same as the desktop")},
                                        {QStringLiteral("en"), QStringLiteral("English")},
                                        {QStringLiteral("de"), QStringLiteral("Deutsch")},
                                        {QStringLiteral("nl"), QStringLiteral("Nederlands")}},
                                       tr("Language"), this);
  QLabel* note = note_with(tr("The new language is used from the next start."), this);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->setVerticalSpacing(12);
  form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
  form->addRow(tr("&Theme:"), theme);
  form->addRow(tr("&Language:"), language);
  form->addRow(QString(), note);
  form->addRow(tr("At startup:"),
               setting_switch(window_keys::kReopenLast, false, tr("&Open the last drawing again"),
                              tr("If no file is given"), this));
  add_sound(*form);
}

void GeneralPage::add_sound(QFormLayout& form) {
  QCheckBox* sound =
      setting_switch(feel_keys::kSound, feel_keys::kSoundDefault, tr("So&und of drawing"),
                     tr("Hear the pen rub on the surface"), this);
  QSlider* volume = setting_slider(feel_keys::kSoundVolume, feel_keys::kSoundVolumeDefault,
                                   tr("Volume of the sound of drawing"), this);
  sound->setEnabled(FrictionSound::is_built_in());
  volume->setEnabled(FrictionSound::is_built_in());
  QLabel* note = note_with({}, this);
  note->setObjectName(QStringLiteral("sound-note"));
  const auto show = [note] {
    note->setText(SoundState::the().words());
    note->setVisible(!note->text().isEmpty());
  };
  connect(&SoundState::the(), &SoundState::changed, note, show);
  form.addRow(tr("Sound:"), sound);
  form.addRow(tr("&Volume:"), volume);
  form.addRow(QString(), note);
  show();
}

}  // namespace felt::desktop
