#pragma once

#include <QPushButton>
#include <QTimer>
#include <optional>
#include <utility>

#include "desktop/engine/message_bar.h"
#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Says that new ink can hardly be seen on the page, and offers a visible colour: one click uses
/// it. Appears a moment after the colour or the page has changed, and disappears when the ink is
/// visible again. After the user has closed it, it stays closed for this colour on this page.
class ColorNotice : public MessageBar {
  Q_OBJECT

 public:
  static constexpr int kDelayMs = 500;  ///< so that it does not flash while a colour is chosen

  explicit ColorNotice(Studio& studio, QWidget* parent = nullptr);

 private:
  void follow();
  void offer();
  void show_color(Rgba color);

  Studio& studio_;
  QPushButton* use_;
  QTimer delay_;
  Rgba offered_;
  std::optional<std::pair<Rgba, Rgba>> said_;  // the ink and the paper of the last message
};

}  // namespace felt::desktop
