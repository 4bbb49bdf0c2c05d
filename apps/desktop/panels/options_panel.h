#pragma once

#include <QLabel>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "desktop/engine/studio.h"
#include "desktop/panels/option_row.h"

namespace felt::desktop {

/// Makes a widget that chooses an option's value by itself, as a child of this one.
using OptionPicker = std::function<QWidget*(QWidget* parent)>;

/// The options of the tool in hand, made from its table (OptionSpec): a row each, its help as the
/// tip. Rows that mean nothing with what is chosen are not shown; what is felt comes last, and what
/// few people set is folded behind "More". Writes SetOption events, and follows all that others
/// write. Options that have a picker, by "tool.option", get that in place of a row, with the
/// option's name above it.
class OptionsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit OptionsPanel(Studio& studio, QWidget* parent = nullptr,
                        std::map<std::string, OptionPicker> pickers = {});

  /// A row of the tool in hand by the option's id; null where there is none.
  [[nodiscard]] OptionRow* row(std::string_view id) const;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Page {
    QWidget* widget = nullptr;
    std::vector<OptionRow*> rows;
  };

  void show_tool();
  void hold_width();
  Page& page_of(const ToolInfo& info);
  bool add_picker(Page& page, QVBoxLayout* lines, const ToolInfo& tool, const OptionSpec& spec);
  QVBoxLayout* add_more(Page& page, QVBoxLayout* lines);
  void add_row(Page& page, QVBoxLayout* lines, const ToolInfo& tool, const OptionSpec& spec);
  /// Shows the value of an option, and the rows that it decides about.
  void follow(const QString& id);
  void show_values(const ToolInfo& info, Page& page);
  void show_matters(const std::string& tool, Page& page);
  void reset_tool();

  Studio& studio_;
  std::map<std::string, OptionPicker> pickers_;
  QLabel* picture_;
  QLabel* title_;
  QToolButton* reset_;
  QScrollArea* scroll_;
  QVBoxLayout* pages_box_;
  std::map<std::string, Page, std::less<>> pages_;  // by tool, each made when it is first in hand
  std::string shown_;
};

}  // namespace felt::desktop
