#include "desktop/devices/doctor_dialog.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QEvent>
#include <QGuiApplication>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "desktop/engine/text_of.h"

namespace felt::desktop {
namespace {

constexpr QSize kFirstSize{720, 560};

/// Returns a sign as text, so that screen readers read it, too.
QString sign_of(FindingLevel level) {
  switch (level) {
    case FindingLevel::kOk:
      return QStringLiteral("✓");
    case FindingLevel::kAbsent:
      return QStringLiteral("–");
    case FindingLevel::kWarning:
      return QStringLiteral("!");
    case FindingLevel::kProblem:
      return QStringLiteral("✗");
  }
  return {};
}

/// Returns the rank for sorting drivers: first those with a problem, then working ones, then those
/// that found nothing.
int rank_of(const DriverFindings& driver) {
  int rank = 2;
  for (const Finding& finding : driver.findings) {
    if (finding.level == FindingLevel::kProblem || finding.level == FindingLevel::kWarning)
      return 0;
    if (finding.level == FindingLevel::kOk) rank = 1;
  }
  return rank;
}

/// Returns a step as a list item.
QString step_html(const QString& step) {
  return QStringLiteral("<li>%1</li>").arg(step.toHtmlEscaped());
}

QString finding_html(const Finding& finding) {
  const bool matters =
      finding.level == FindingLevel::kProblem || finding.level == FindingLevel::kWarning;
  const QString what = text_of(finding.what).toHtmlEscaped();
  QString html =
      QStringLiteral("<p style='margin-top:6px; margin-bottom:2px'>%1&nbsp; %2</p>")
          .arg(sign_of(finding.level), matters ? QStringLiteral("<b>%1</b>").arg(what) : what);
  if (!finding.details.empty()) {
    html += QStringLiteral(
                "<p style='margin-left:24px; margin-top:0px; margin-bottom:2px; "
                "white-space:pre-wrap'><code>%1</code></p>")
                .arg(text_of(finding.details).toHtmlEscaped());
  }
  if (finding.steps.empty()) return html;
  html += QStringLiteral("<ol style='margin-top:2px; margin-bottom:4px'>");
  for (const std::string& step : finding.steps) html += step_html(text_of(step));
  return html + QStringLiteral("</ol>");
}

}  // namespace

DoctorDialog::DoctorDialog(QWidget* parent) : QDialog(parent), text_(new QTextBrowser(this)) {
  setWindowTitle(tr("Setting up a haptic device"));
  resize(kFirstSize);
  auto* head =
      new QLabel(tr("A haptic device needs its maker's software and permission to use its port. "
                    "Feltline has checked this computer. Work from top to bottom. A line with a "
                    "dash is about a device that you may not own; ignore it then."),
                 this);
  head->setWordWrap(true);
  text_->setAccessibleName(tr("What was found"));
  text_->setOpenExternalLinks(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  again_ = buttons->addButton(tr("&Check again"), QDialogButtonBox::ActionRole);
  copy_ = buttons->addButton(tr("&Copy all"), QDialogButtonBox::ActionRole);
  copy_->setToolTip(tr("Copies the report as plain text, to ask for help"));
  connect(again_, &QPushButton::clicked, this, &DoctorDialog::look);
  connect(copy_, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(plain_text()); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* rows = new QVBoxLayout(this);
  rows->addWidget(head);
  rows->addWidget(text_, 1);
  rows->addWidget(buttons);
  look();
}

void DoctorDialog::look() {
  if (is_looking_) return;
  DriverWatch* watch = DriverWatch::the();
  if (!watch) return show_findings({});
  is_looking_ = true;
  again_->setEnabled(false);
  text_->setPlainText(tr("Checking…"));
  watch->diagnose(
      this, [this](std::vector<DriverFindings> findings) { show_findings(std::move(findings)); });
}

void DoctorDialog::show_findings(std::vector<DriverFindings> findings) {
  is_looking_ = false;
  again_->setEnabled(true);
  findings_ = std::move(findings);
  std::stable_sort(
      findings_.begin(), findings_.end(),
      [](const DriverFindings& a, const DriverFindings& b) { return rank_of(a) < rank_of(b); });
  draw();
}

void DoctorDialog::draw() {
  if (findings_.empty()) {
    text_->setPlainText(tr("This build of Feltline has no drivers."));
    return;
  }
  QString html;
  for (const DriverFindings& driver : findings_) {
    html += QStringLiteral("<h3 style='margin-top:12px; margin-bottom:2px'>%1</h3>")
                .arg(driver.label.toHtmlEscaped());
    for (const Finding& finding : driver.findings) html += finding_html(finding);
    if (driver.findings.empty()) {
      html += QStringLiteral("<p>%1</p>").arg(tr("Nothing to report.").toHtmlEscaped());
    }
  }
  text_->setHtml(html);
}

QString DoctorDialog::plain_text() const {
  QStringList lines;
  lines << QStringLiteral("Feltline " FELT_VERSION);
  for (const DriverFindings& driver : findings_) {
    lines << QString() << driver.label;
    for (const Finding& finding : driver.findings) {
      lines << QStringLiteral("  %1 %2").arg(sign_of(finding.level), text_of(finding.what));
      if (!finding.details.empty()) {
        lines
            << QStringLiteral("      ") +
                   text_of(finding.details).replace(QLatin1Char('\n'), QStringLiteral("\n      "));
      }
      int number = 0;
      for (const std::string& step : finding.steps) {
        lines << QStringLiteral("    %1. %2").arg(++number).arg(text_of(step));
      }
    }
  }
  return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

void DoctorDialog::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && !is_looking_) draw();
  QDialog::changeEvent(event);
}

}  // namespace felt::desktop
