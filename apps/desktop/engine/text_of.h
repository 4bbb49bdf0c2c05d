#pragma once

#include <QString>
#include <string_view>

#include "felt/base/result.h"

namespace felt::desktop {

/// Converts the library's texts (UTF-8) to Qt's.
inline QString text_of(std::string_view text) {
  return QString::fromUtf8(text.data(), qsizetype(text.size()));
}
inline QString text_of(const Error& error) {
  return text_of(error.message);
}

}  // namespace felt::desktop
