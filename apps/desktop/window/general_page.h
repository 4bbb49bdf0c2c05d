#pragma once

#include <QFormLayout>
#include <QWidget>

namespace felt::desktop {

/// The page "General" of the preferences: theme, language, behaviour at the start, sound.
class GeneralPage : public QWidget {
  Q_OBJECT

 public:
  explicit GeneralPage(QWidget* parent = nullptr);

 private:
  void add_sound(QFormLayout& form);
};

}  // namespace felt::desktop
