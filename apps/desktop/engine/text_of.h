#pragma once

#include <QString>
#include <string_view>

namespace felt::desktop {

inline QString text_of(std::string_view utf8) {
  return QString::fromUtf8(utf8.data(), qsizetype(utf8.size()));
}

}  // namespace felt::desktop
