#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QWidget>
#include <memory>

#include "desktop/devices/device_care.h"
#include "desktop/devices/device_settings.h"
#include "desktop/devices/test_pad.h"
#include "desktop/engine/studio.h"

namespace felt::desktop {

/// A page of Preferences: which device the pen is, how it is, and what is set for it. Real devices
/// come first, each with its state, and a row that helps with one that is not there; then the exact
/// pen and the simulated styluses. A simulated one is used when it is chosen; a real one when its
/// button is pressed, since its arm may have to move. Devices are looked for while it is seen.
class DevicePage : public QWidget {
  Q_OBJECT

 public:
  /// Without `care` a device is used without any questions: a window has one.
  explicit DevicePage(Studio& studio, DeviceCare* care = nullptr, QWidget* parent = nullptr);

  /// Lists again what there is.
  void refresh();
  /// The id of the row that is chosen, in use or not.
  [[nodiscard]] QString chosen() const;
  /// Chooses a row, as a click does. False: there is none.
  bool choose(const QString& id);
  /// Uses the chosen device.
  void use();
  /// Opens the help with setting up a device.
  void help();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Row {
    PenDeviceInfo info;
    bool is_real = false;
    bool is_here = true;
  };
  void make_form();
  void take_row();
  void tell();
  void tell_rows();
  void set_limit(double newton);
  void list_cues();
  [[nodiscard]] const Row* row_of(const QString& id) const;
  [[nodiscard]] QString state_of(const Row& row, int* sign) const;
  void add_row(const Row& row);

  Studio& studio_;
  DeviceCare* care_;
  QListWidget* list_;
  QLabel* words_;
  QPushButton* use_;
  QWidget* general_;  // for what mouse and tablet lead
  QDoubleSpinBox* limit_;
  DeviceSettings* settings_;
  QWidget* cue_row_;
  QComboBox* cue_;
  TestPad* pad_;
  std::vector<Row> rows_;
  std::unique_ptr<DriverWatch::Watching> watching_;
};

/// What a device can do, in a few words.
QString capabilities_in_words(const Capabilities& can);

}  // namespace felt::desktop
