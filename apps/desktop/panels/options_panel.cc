#include "desktop/panels/options_panel.h"

#include <QEvent>
#include <QStyle>
#include <algorithm>
#include <utility>

#include "desktop/engine/first_options.h"
#include "desktop/panels/tool_icons.h"
#include "desktop/panels/tool_texts.h"

namespace felt::desktop {
namespace {

constexpr int kMarginPx = 10;
constexpr int kRowGapPx = 9;
constexpr int kPicturePx = 22;
constexpr std::string_view kStrength = "strength";  // the row of strength_option()

std::string id_of(const std::string& tool, const OptionSpec& spec) {
  return tool + "." + std::string(spec.id);
}

QLabel* heading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  return label;
}

}  // namespace

OptionsPanel::OptionsPanel(Studio& studio, QWidget* parent,
                           std::map<std::string, OptionPicker> pickers)
    : QWidget(parent),
      studio_(studio),
      pickers_(std::move(pickers)),
      picture_(new QLabel(this)),
      title_(heading({}, this)),
      reset_(new QToolButton(this)),
      scroll_(new QScrollArea(this)) {
  auto* lines = new QVBoxLayout(this);
  lines->setContentsMargins(0, 0, 0, 0);
  lines->setSpacing(0);
  auto* head = new QHBoxLayout;
  head->setContentsMargins(kMarginPx, kMarginPx / 2, kMarginPx, kMarginPx / 2);
  head->addWidget(picture_);
  head->addWidget(title_, 1);
  reset_->setIcon(icon_of("reset"));
  reset_->setAutoRaise(true);
  reset_->setObjectName(QStringLiteral("reset_tool"));
  reset_->setToolTip(tr("All options of this tool back to what they were at first"));
  reset_->setAccessibleName(tr("Reset the tool"));
  connect(reset_, &QToolButton::clicked, this, &OptionsPanel::reset_tool);
  head->addWidget(reset_);
  lines->addLayout(head);
  auto* content = new QWidget(scroll_);
  pages_box_ = new QVBoxLayout(content);
  pages_box_->setContentsMargins(kMarginPx, 2, kMarginPx, kMarginPx);
  pages_box_->addStretch(1);
  scroll_->setWidget(content);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setAccessibleName(tr("Options of the tool"));
  scroll_->setFocusPolicy(Qt::NoFocus);
  lines->addWidget(scroll_, 1);
  connect(&studio, &Studio::tool_changed, this, &OptionsPanel::show_tool);
  connect(&studio, &Studio::option_changed, this, &OptionsPanel::follow);
  connect(&studio, &Studio::opened, this, [this] {
    for (const auto& tool : studio_.session().tools()) {
      const auto page = pages_.find(tool->info().id);
      if (page != pages_.end()) show_values(tool->info(), page->second);
    }
    show_tool();
  });
  show_tool();
}

OptionRow* OptionsPanel::row(std::string_view id) const {
  const auto page = pages_.find(shown_);
  if (page == pages_.end()) return nullptr;
  for (OptionRow* row : page->second.rows) {
    if (row->spec().id == id) return row;
  }
  return nullptr;
}

void OptionsPanel::show_tool() {
  const ToolInfo& info = studio_.session().tool().info();
  Page& now = page_of(info);
  if (shown_ != info.id) {
    const auto before = pages_.find(shown_);
    if (before != pages_.end()) before->second.widget->hide();
    shown_ = info.id;
  }
  now.widget->show();
  // As narrow as the rows can be, not narrower: there is no scrolling sideways.
  scroll_->setMinimumWidth(scroll_->widget()->minimumSizeHint().width() +
                           style()->pixelMetric(QStyle::PM_ScrollBarExtent));
  picture_->setPixmap(icon_of(info.id).pixmap(QSize(kPicturePx, kPicturePx), devicePixelRatioF()));
  title_->setText(translated(info.label));
  title_->setToolTip(translated(info.help));
}

OptionsPanel::Page& OptionsPanel::page_of(const ToolInfo& info) {
  const auto known = pages_.find(info.id);
  if (known != pages_.end()) return known->second;
  const std::string tool(info.id);
  Page& page = pages_[tool];
  page.widget = new QWidget(scroll_->widget());
  auto* lines = new QVBoxLayout(page.widget);
  lines->setContentsMargins(0, 0, 0, 0);
  lines->setSpacing(kRowGapPx);
  const OptionSpec* strength = nullptr;
  for (const OptionSpec& spec : info.options) {
    if (spec.id == kStrength) {
      strength = &spec;
    } else if (!add_picker(page, lines, tool, spec)) {
      add_row(page, lines, tool, spec);
    }
  }
  if (strength) {
    lines->addSpacing(kRowGapPx / 2);
    lines->addWidget(heading(tr("Feel"), page.widget));
    add_row(page, lines, tool, *strength);
  }
  int widest = 0;
  for (const OptionRow* row : page.rows) widest = std::max(widest, row->number_width());
  for (OptionRow* row : page.rows) row->set_number_width(widest);
  pages_box_->insertWidget(0, page.widget);
  show_values(info, page);
  return page;
}

bool OptionsPanel::add_picker(Page& page, QVBoxLayout* lines, const std::string& tool,
                              const OptionSpec& spec) {
  const auto picker = pickers_.find(id_of(tool, spec));
  if (picker == pickers_.end()) return false;
  auto* name = new QLabel(translated(spec.label), page.widget);
  name->setToolTip(translated(spec.help));
  QWidget* widget = picker->second(page.widget);
  name->setBuddy(widget);
  lines->addWidget(name);
  lines->addWidget(widget);
  return true;
}

void OptionsPanel::add_row(Page& page, QVBoxLayout* lines, const std::string& tool,
                           const OptionSpec& spec) {
  auto* row = new OptionRow(as_at_first(tool, spec), page.widget);
  lines->addWidget(row);
  page.rows.push_back(row);
  connect(row, &OptionRow::chosen, this, [this, row, tool](const OptionValue& value) {
    const std::string id = id_of(tool, row->spec());
    const Result<OptionValue> now = studio_.session().option(id);
    if (now && *now == value) return;
    studio_.apply(SetOption{id, value});
  });
}

void OptionsPanel::follow(const QString& id) {
  const std::string text = id.toStdString();
  const std::string tool = text.substr(0, text.find('.'));
  const auto page = pages_.find(tool);
  if (page == pages_.end()) return;
  const Result<OptionValue> value = studio_.session().option(text);
  if (!value) return;
  for (OptionRow* row : page->second.rows) {
    if (id_of(tool, row->spec()) == text) row->show_value(*value);
  }
  if (std::holds_alternative<std::string>(*value)) show_matters(tool, page->second);
}

void OptionsPanel::show_values(const ToolInfo& info, Page& page) {
  const std::string tool(info.id);
  for (OptionRow* row : page.rows) {
    const Result<OptionValue> value = studio_.session().option(id_of(tool, row->spec()));
    if (value) row->show_value(*value);
  }
  show_matters(tool, page);
}

void OptionsPanel::show_matters(const std::string& tool, Page& page) {
  for (OptionRow* row : page.rows) {
    const std::string_view decider = decider_of(row->spec());
    if (decider.empty()) continue;
    const Result<OptionValue> value = studio_.session().option(tool + "." + std::string(decider));
    const auto* choice = value ? std::get_if<std::string>(&*value) : nullptr;
    row->setVisible(!choice || matters_with(row->spec(), *choice));
  }
}

void OptionsPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && !shown_.empty()) show_tool();
}

void OptionsPanel::reset_tool() {
  const ToolInfo& info = studio_.session().tool().info();
  const std::string tool(info.id);
  for (const OptionSpec& row : info.options) {
    const OptionSpec spec = as_at_first(tool, row);
    const std::string id = id_of(tool, spec);
    const Result<OptionValue> now = studio_.session().option(id);
    if (now && *now != default_value(spec)) studio_.apply(SetOption{id, default_value(spec)});
  }
}

}  // namespace felt::desktop
