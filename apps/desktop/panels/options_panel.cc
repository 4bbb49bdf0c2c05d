#include "desktop/panels/options_panel.h"

#include <QEvent>
#include <QStyle>
#include <algorithm>
#include <string_view>
#include <utility>

#include "desktop/engine/first_options.h"
#include "desktop/engine/settings.h"
#include "desktop/engine/tool_texts.h"
#include "desktop/panels/tool_icons.h"

namespace felt::desktop {
namespace {

constexpr int kMarginPx = 10;
constexpr int kRowGapPx = 9;
constexpr int kPicturePx = 22;
constexpr std::string_view kStrength = "strength";  // id of the row of strength_option()

constexpr auto kMoreKey = "panels/more_options";

std::string id_of(const ToolInfo& tool, const OptionSpec& spec) {
  return std::string(tool.id) + "." + std::string(spec.id);
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
  reset_->setToolTip(tr("Resets all options of this tool to their defaults"));
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
  for (const auto& tool : studio_.session().tools()) page_of(tool->info()).widget->hide();
  hold_width();
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

/// Makes the panel just wide enough for the widest row of all tools. The width is the same for all
/// tools, because the panel does not scroll sideways, and because choosing a tool must not move the
/// panel's edge and the drawing beside it.
void OptionsPanel::hold_width() {
  int widest = 0;
  for (const auto& tool : studio_.session().tools()) {
    for (const OptionRow* row : page_of(tool->info()).rows) {
      widest = std::max(widest, row->minimumSizeHint().width());  // also if the row is folded
    }
    widest = std::max(widest, page_of(tool->info()).widget->minimumSizeHint().width());
  }
  const QMargins margins = pages_box_->contentsMargins();
  scroll_->setMinimumWidth(widest + margins.left() + margins.right() +
                           style()->pixelMetric(QStyle::PM_ScrollBarExtent));
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
  picture_->setPixmap(icon_of(info.id).pixmap(QSize(kPicturePx, kPicturePx), devicePixelRatioF()));
  title_->setText(translated(info.label));
  title_->setToolTip(translated(info.help));
}

OptionsPanel::Page& OptionsPanel::page_of(const ToolInfo& info) {
  const auto known = pages_.find(info.id);
  if (known != pages_.end()) return known->second;
  Page& page = pages_[std::string(info.id)];
  page.widget = new QWidget(scroll_->widget());
  auto* lines = new QVBoxLayout(page.widget);
  lines->setContentsMargins(0, 0, 0, 0);
  lines->setSpacing(kRowGapPx);
  const OptionSpec* strength = nullptr;
  std::vector<const OptionSpec*> folded;
  for (const OptionSpec& spec : info.options) {
    if (spec.id == kStrength) {
      strength = &spec;
    } else if (spec.is_seldom) {
      folded.push_back(&spec);
    } else if (!add_picker(page, lines, info, spec)) {
      add_row(page, lines, info, spec);
    }
  }
  if (strength) {
    lines->addSpacing(kRowGapPx / 2);
    lines->addWidget(heading(tr("Feel"), page.widget));
    add_row(page, lines, info, *strength);
  }
  if (!folded.empty()) {
    QVBoxLayout* more = add_more(page, lines);
    for (const OptionSpec* spec : folded) add_row(page, more, info, *spec);
  }
  int widest = 0;
  for (const OptionRow* row : page.rows) widest = std::max(widest, row->number_width());
  for (OptionRow* row : page.rows) row->set_number_width(widest);
  pages_box_->insertWidget(0, page.widget);
  show_values(info, page);
  return page;
}

bool OptionsPanel::add_picker(Page& page, QVBoxLayout* lines, const ToolInfo& tool,
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

/// Adds a heading that folds and unfolds the rows below it. All tools share the state of this
/// heading, which is stored in the settings.
QVBoxLayout* OptionsPanel::add_more(Page& page, QVBoxLayout* lines) {
  auto* button = new QToolButton(page.widget);
  button->setObjectName(QStringLiteral("more"));
  button->setText(tr("More"));
  button->setToolTip(tr("Options that are rarely needed"));
  button->setCheckable(true);
  button->setAutoRaise(true);
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  auto* box = new QWidget(page.widget);
  auto* rows = new QVBoxLayout(box);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(kRowGapPx);
  const auto show = [button, box] {
    const bool on = Settings::the().flag(QLatin1String(kMoreKey), false);
    button->setChecked(on);
    button->setArrowType(on ? Qt::DownArrow : Qt::RightArrow);
    box->setVisible(on);
  };
  show();
  connect(button, &QToolButton::toggled, this,
          [](bool on) { Settings::the().set(QLatin1String(kMoreKey), on); });
  connect(&Settings::the(), &Settings::changed, box, [show](const QString& key) {
    if (key == QLatin1String(kMoreKey)) show();
  });
  lines->addWidget(button);
  lines->addWidget(box);
  return rows;
}

void OptionsPanel::add_row(Page& page, QVBoxLayout* lines, const ToolInfo& tool,
                           const OptionSpec& spec) {
  auto* row = new OptionRow(as_at_first(tool.kind, spec), page.widget);
  lines->addWidget(row);
  page.rows.push_back(row);
  connect(row, &OptionRow::chosen, this, [this, id = id_of(tool, spec)](const OptionValue& value) {
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
    if (text.substr(tool.size() + 1) == row->spec().id) row->show_value(*value);
  }
  if (std::holds_alternative<std::string>(*value)) show_matters(tool, page->second);
}

void OptionsPanel::show_values(const ToolInfo& info, Page& page) {
  for (OptionRow* row : page.rows) {
    const Result<OptionValue> value = studio_.session().option(id_of(info, row->spec()));
    if (value) row->show_value(*value);
  }
  show_matters(std::string(info.id), page);
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
  const bool is_font = event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange;
  if (is_font && !shown_.empty()) hold_width();
  if (event->type() == QEvent::PaletteChange && !shown_.empty()) show_tool();
}

void OptionsPanel::reset_tool() {
  const ToolInfo& info = studio_.session().tool().info();
  for (const OptionSpec& row : info.options) {
    const OptionSpec spec = as_at_first(info.kind, row);
    const std::string id = id_of(info, spec);
    const Result<OptionValue> now = studio_.session().option(id);
    if (now && *now != default_value(spec)) studio_.apply(SetOption{id, default_value(spec)});
  }
}

}  // namespace felt::desktop
