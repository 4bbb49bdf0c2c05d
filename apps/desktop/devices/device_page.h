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

/// The page "Device" of the preferences: the pen device, its state and its settings. The list shows
/// real devices first, each with its state. The next row offers help for finding a device that is
/// not in the list. The tablet and the simulated styluses follow. A simulated stylus is used as
/// soon as its row is selected. A real device is used only when the user presses the button,
/// because its arm may have to move. The page searches for devices while it is visible.
class DevicePage : public QWidget {
  Q_OBJECT

 public:
  /// `care` opens the devices and may ask the user questions. The main window passes its
  /// DeviceCare. If `care` is null, devices are opened without questions.
  explicit DevicePage(Studio& studio, DeviceCare* care = nullptr, QWidget* parent = nullptr);

  /// Updates the list of devices.
  void refresh();
  /// Returns the id of the selected row, whether it is in use or not.
  [[nodiscard]] QString chosen() const;
  /// Selects the row with that id, as a click does. Returns false if no row has that id.
  bool choose(const QString& id);
  /// Uses the selected device.
  void use();
  /// Opens the help for setting up a device.
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
  void report();
  void report_rows();
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
  QWidget* general_;  // the settings for devices that mouse or tablet move
  QDoubleSpinBox* limit_;
  DeviceSettings* settings_;
  QWidget* cue_row_;
  QComboBox* cue_;
  TestPad* pad_;
  std::vector<Row> rows_;
  std::unique_ptr<DriverWatch::Watching> watching_;
};

/// Returns the capabilities of a device in a few words.
QString capabilities_in_words(const Capabilities& can);

}  // namespace felt::desktop
