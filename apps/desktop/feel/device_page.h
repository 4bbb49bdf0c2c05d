#pragma once

#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QWidget>

#include "desktop/engine/studio.h"
#include "desktop/feel/test_pad.h"

namespace felt::desktop {

/// A page of Preferences: which device the pen is, what it can do, the largest force that it may
/// show, where its drawing plane lies, and a pad to try it. Choices take effect at once.
class DevicePage : public QWidget {
  Q_OBJECT

 public:
  explicit DevicePage(Studio& studio, QWidget* parent = nullptr);

  /// Asks drivers again what there is.
  void refresh();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void choose(int row);
  void tell();
  void set_limit(double newton);
  void calibrate();

  Studio& studio_;
  QListWidget* list_;
  QLabel* words_;
  QDoubleSpinBox* limit_;
  QPushButton* calibrate_;
  QLabel* plane_;
  TestPad* pad_;
  std::vector<PenDeviceInfo> devices_;
};

/// What a device can do, in a few words.
QString capabilities_in_words(const Capabilities& can);

}  // namespace felt::desktop
