#pragma once

#include <QEvent>
#include <QObject>
#include <QPointer>
#include <QPointingDevice>
#include <QTemporaryDir>
#include <QTimer>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "desktop/window/main_window.h"
#include "tests/drawing/gestures/dice.h"
#include "witness.h"

namespace felt::desktop {

struct MonkeyOptions {
  std::uint64_t events = 2000;
  std::uint64_t seed = 1;
  bool verbose = false;
  /// If one event needs more CPU time than this, it counts as a hang.
  double hang_ms = 200.0;
};

/// Sends random input to a window, with every key, button and pen, also when a user would not:
/// while a dialog is open, in the middle of a stroke, on widgets that nobody clicks. After each
/// event, the document must be the result of its edits. Sometimes everything is undone and redone,
/// and the drawing is saved and read back. The same seed gives the same input, as far as it does
/// not depend on the clock.
class Monkey : public QObject {
  Q_OBJECT

 public:
  Monkey(MainWindow& window, const MonkeyOptions& options);

  /// Starts sending input. Requires a running event loop; the loops of dialogs work too. Emits
  /// `finished` at the end.
  void start();
  /// Returns a description of the failure, or "" if none occurred.
  [[nodiscard]] const std::string& failure() const noexcept { return failure_; }
  [[nodiscard]] std::string report() const;

 Q_SIGNALS:
  void finished();

 private:
  using Act = void (Monkey::*)();
  /// A kind of input, and its relative frequency.
  struct Choice {
    double weight;
    Act act;
    const char* name;
  };

  const Choice& choose();
  void step();
  void check();
  void check_deeply();
  void fail(const std::string& why);

  // The kinds of input, defined in monkey_acts.cc.
  void stroke();
  void pen_event();
  void tablet_stroke();
  void press_key();
  void trigger_action();
  void click_widget();
  void wheel();
  void choose_tool();
  void set_option();
  void resize();
  void switch_device();
  void leave_and_enter();
  void wait();
  void close_dialog();

  [[nodiscard]] QPointF anywhere();
  [[nodiscard]] QWidget* any_widget();
  void mouse(QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons held);
  void tablet(QEvent::Type type, QPointF at, double pressure, bool eraser);

  MainWindow& window_;
  MonkeyOptions options_;
  gestures::Dice dice_;
  Witness witness_;
  QTemporaryDir folder_;
  QPointingDevice pen_, eraser_;
  std::uint64_t done_ = 0;
  int steps_in_dialog_ = 0;
  std::string doing_;
  std::string failure_;
  std::map<std::string, std::uint64_t> counts_;
  double worst_ms_ = 0.0;
  std::string worst_;
};

}  // namespace felt::desktop
