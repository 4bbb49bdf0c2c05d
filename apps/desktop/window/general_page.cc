#include "desktop/window/general_page.h"

#include <QLabel>

#include "desktop/window/setting_rows.h"
#include "desktop/window/settings_keys.h"

namespace felt::desktop {

GeneralPage::GeneralPage(QWidget* parent) : QWidget(parent) {
  QComboBox* theme = setting_choice(window_keys::kTheme, QStringLiteral("system"),
                                    {{QStringLiteral("system"), tr("As the desktop")},
                                     {QStringLiteral("light"), tr("Light")},
                                     {QStringLiteral("dark"), tr("Dark")}},
                                    tr("Theme"), this);
  QComboBox* language = setting_choice(window_keys::kLanguage, QString(),
                                       {{QString(), tr("As the desktop")},
                                        {QStringLiteral("en"), QStringLiteral("English")},
                                        {QStringLiteral("de"), QStringLiteral("Deutsch")},
                                        {QStringLiteral("nl"), QStringLiteral("Nederlands")}},
                                       tr("Language"), this);
  auto* note = new QLabel(tr("Another language is used from the next start on."), this);
  note->setEnabled(true);
  note->setForegroundRole(QPalette::PlaceholderText);
  note->setWordWrap(true);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->setVerticalSpacing(12);
  form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
  form->addRow(tr("&Theme:"), theme);
  form->addRow(tr("&Language:"), language);
  form->addRow(QString(), note);
  form->addRow(tr("At the start:"),
               setting_switch(window_keys::kReopenLast, false, tr("&Open the last drawing again"),
                              tr("Where no file is named"), this));
}

}  // namespace felt::desktop
