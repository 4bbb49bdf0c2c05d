#include "desktop/files/error_words.h"

#include <QCoreApplication>

namespace felt::desktop {
namespace {

const char* words_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::kNotFound:
      return QT_TRANSLATE_NOOP("ErrorWords", "The file or folder does not exist.");
    case ErrorCode::kIo:
      return QT_TRANSLATE_NOOP(
          "ErrorWords",
          "The file cannot be read or written. It may be protected, or the disk may be full.");
    case ErrorCode::kLimitExceeded:
      return QT_TRANSLATE_NOOP("ErrorWords", "The drawing is too large for Feltline.");
    case ErrorCode::kUnsupported:
      return QT_TRANSLATE_NOOP("ErrorWords", "Feltline cannot read this kind of file.");
    case ErrorCode::kInvalidData:
    case ErrorCode::kInvalidArgument:
      break;
  }
  return QT_TRANSLATE_NOOP("ErrorWords",
                           "The file is damaged, or is not a drawing that Feltline can read.");
}

}  // namespace

QString error_words(const Error& error) {
  return QCoreApplication::translate("ErrorWords", words_of(error.code));
}

}  // namespace felt::desktop
