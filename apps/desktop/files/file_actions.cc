#include "desktop/files/file_actions.h"

namespace felt::desktop {

FileActions::FileActions(Studio& studio, Actions&, QWidget* window)
    : QObject(window), studio_(studio), window_(window) {}

bool FileActions::open(const QString&) {
  return false;
}
bool FileActions::save() {
  return false;
}
bool FileActions::save_as() {
  return false;
}
bool FileActions::may_close() {
  return true;
}

}  // namespace felt::desktop
