#pragma once

#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QTimer>
#include <QWidget>
#include <vector>

#include "desktop/engine/studio.h"
#include "felt/tactile/tactile_check.h"
#include "felt/tools/overlay.h"

namespace felt::desktop {

/// Lists what a fingertip could not tell apart if the drawing were raised (check_tactile), and
/// marks it on the canvas. While the check is on, it follows every edit: it starts when the drawing
/// has not changed for kWaitMs, and runs on another thread.
class TactilePanel : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kWaitMs = 200;
  static constexpr std::size_t kMaxRows = 200;  ///< more faults are only counted

  explicit TactilePanel(Studio& studio, QWidget* parent = nullptr);

  /// Switches the check and its marks on or off.
  void set_on(bool on);
  /// Returns true if the list shows the present drawing.
  [[nodiscard]] bool is_up_to_date() const noexcept { return !waits_ && !runs_; }
  [[nodiscard]] const std::vector<TactileFault>& faults() const noexcept { return faults_; }

 Q_SIGNALS:
  /// The marks for the canvas changed: a ring for each fault, a label for the first of each
  /// rule.
  void marks_changed(const felt::Overlay& marks);
  /// The user chose a fault at this position.
  void wants_position(felt::Point at);

 private:
  void wait();
  void start();
  void take(Result<std::vector<TactileFault>> faults);
  void show_faults();

  Studio& studio_;
  QComboBox* print_;
  QLabel* summary_;
  QListWidget* list_;
  QTimer delay_;
  bool is_on_ = false;
  bool waits_ = false;  // the drawing changed since the last check began
  bool runs_ = false;
  std::vector<TactileFault> faults_;
};

/// Returns the name of a rule, such as "Gap".
QString tactile_rule_name(TactileRule rule);
/// Returns a fault in one line: the measure and the limit.
QString tactile_fault_text(const TactileFault& fault);

}  // namespace felt::desktop
