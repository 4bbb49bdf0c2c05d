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

/// A function that makes a widget as a child of `parent`. With this widget, the user sets the value
/// of an option.
using OptionPicker = std::function<QWidget*(QWidget* parent)>;

/// Shows the options of the current tool with a row for each OptionSpec of the tool. A row is
/// hidden while its option has no effect. The force level comes last; rarely used options are
/// folded under "More". When the user changes a value, the panel applies a SetOption event; it also
/// shows changes by other code. If `pickers` has an entry for an option, with the key
/// "tool.option", the panel shows that widget below the option's name instead of a row.
class OptionsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit OptionsPanel(Studio& studio, QWidget* parent = nullptr,
                        std::map<std::string, OptionPicker> pickers = {});

  /// Returns the row of an option of the current tool by the option's id, or null.
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
  /// Shows the value of an option, and shows or hides the rows that depend on it.
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
  std::map<std::string, Page, std::less<>> pages_;  // the pages by tool id; a page is made when its
                                                    // tool is first used
  std::string shown_;
};

}  // namespace felt::desktop
