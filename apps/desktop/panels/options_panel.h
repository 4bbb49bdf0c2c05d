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

/// Makes a widget that sets an option's value itself, as a child of `parent`.
using OptionPicker = std::function<QWidget*(QWidget* parent)>;

/// The options of the current tool, made from its table (OptionSpec): a row for each, with its help
/// as the tool tip. Rows without effect for the present choices are hidden; the force level comes
/// last, and rarely used options are folded under "More". Applies SetOption events, and follows
/// changes from elsewhere. An option with a picker, keyed by "tool.option", gets that instead of a
/// row, with the option's name above it.
class OptionsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit OptionsPanel(Studio& studio, QWidget* parent = nullptr,
                        std::map<std::string, OptionPicker> pickers = {});

  /// Returns a row of the current tool by the option's id, or null.
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
  std::map<std::string, Page, std::less<>> pages_;  // by tool; each is made when its tool is first
                                                    // used
  std::string shown_;
};

}  // namespace felt::desktop
