// Saves pictures of the dialogs for visual review: FELT_LOOK=FOLDER desktop_files_test.
#include <gtest/gtest.h>

#include <QAccessible>
#include <QApplication>
#include <QPalette>
#include <QStyleFactory>

#include "desktop/files/export_dialog.h"
#include "desktop/files/page_dialog.h"
#include "desktop/files/recovery_dialog.h"
#include "desktop/files/testing/studio_fixture.h"

namespace felt::desktop::looks_test {
namespace {

QPalette dark() {
  QPalette palette;
  const QColor window(45, 45, 48), base(32, 32, 34), text(230, 230, 230);
  for (const auto role : {QPalette::Window, QPalette::Button}) palette.setColor(role, window);
  palette.setColor(QPalette::Base, base);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(role, text);
  }
  palette.setColor(QPalette::Mid, QColor(90, 90, 90));
  palette.setColor(QPalette::Disabled, QPalette::Text, QColor(120, 120, 120));
  palette.setColor(QPalette::Disabled, QPalette::ButtonText, QColor(120, 120, 120));
  palette.setColor(QPalette::Disabled, QPalette::WindowText, QColor(120, 120, 120));
  return palette;
}

/// Checks that every control has a text or an accessible name.
void check_names(const QDialog& dialog) {
  for (const QWidget* widget : dialog.findChildren<QWidget*>()) {
    if (widget->focusPolicy() == Qt::NoFocus || !widget->isVisibleTo(&dialog)) continue;
    QAccessibleInterface* spoken =
        QAccessible::queryAccessibleInterface(const_cast<QWidget*>(widget));
    if (!spoken || spoken->role() == QAccessible::Pane) continue;
    if (widget->inherits("QLineEdit") || widget->inherits("QScrollArea")) continue;
    EXPECT_FALSE(spoken->text(QAccessible::Name).isEmpty())
        << widget->metaObject()->className() << " in " << dialog.metaObject()->className();
  }
}

/// Returns three offers: with a file, without a file, and damaged.
std::vector<RecoveryOffer> offers_like(StudioFixture& fixture) {
  std::vector<RecoveryOffer> offers;
  const QDateTime now = QDateTime::currentDateTime();
  for (const char* name : {"Harbour.felt", "", "A much longer name of a drawing.felt"}) {
    const std::string folder =
        fixture.at(("store" + std::to_string(offers.size())).c_str()).toStdString();
    EXPECT_TRUE(make_private_folder(folder));
    RecoveryOffer offer{{folder, FolderLock::take(folder).value(), 0}, {}, {}};
    offer.recovered.drawing = fixture.files->drawing();
    offer.recovered.name = name;
    offer.recovered.changed_at_s = now.toSecsSinceEpoch();
    if (*name != 0) offer.recovered.path = "/home/" + offer.recovered.name;
    if (offers.empty()) offer.saved = SavedDrawing{{}, now.addDays(-2)};
    if (offers.size() == 2) offer.recovered.problems = {"3 changes could not be read"};
    offers.push_back(std::move(offer));
  }
  return offers;
}

TEST(Looks, EveryControlOfEveryDialogHasAName) {
  StudioFixture fixture;
  fixture.draw(1, 12);
  const QString folder = qEnvironmentVariable("FELT_LOOK");
  const QPalette light = QApplication::palette();
  if (!folder.isEmpty()) QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  for (const bool is_dark : {false, true}) {
    QApplication::setPalette(is_dark ? dark() : light);
    ExportDialog export_dialog(fixture.files->drawing(), {}, nullptr);
    PageDialog page_dialog(fixture.studio.page(), nullptr);
    std::vector<RecoveryOffer> offers = offers_like(fixture);
    RecoveryDialog recovery_dialog(std::move(offers), nullptr);
    for (QDialog* dialog :
         {static_cast<QDialog*>(&export_dialog), static_cast<QDialog*>(&page_dialog),
          static_cast<QDialog*>(&recovery_dialog)}) {
      dialog->ensurePolished();
      dialog->adjustSize();
      check_names(*dialog);
      if (folder.isEmpty()) continue;
      dialog->grab().save(
          folder + QLatin1Char('/') +
          QString::fromLatin1(dialog->metaObject()->className()).section(QStringLiteral("::"), -1) +
          QLatin1String(is_dark ? "-dark.png" : "-light.png"));
    }
  }
  QApplication::setPalette(light);
}

}  // namespace
}  // namespace felt::desktop::looks_test
