#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace felt {

/// The kind of an error; the message has the details.
enum class ErrorCode {
  kInvalidArgument,  ///< the caller's values are invalid, alone or together
  kInvalidData,      ///< the content of a file or stream is invalid
  kLimitExceeded,    ///< well-formed, but larger than we accept
  kNotFound,         ///< no such file, tool or device
  kIo,               ///< the operating system refused or failed
  kUnsupported,      ///< recognised, but not supported here
};

/// An error that can be shown to the user: a code, and a message with the location and the reason.
struct Error {
  ErrorCode code = ErrorCode::kInvalidData;
  std::string message;
};

/// A value, or an error that says why the value is missing. This is the only error channel of the
/// public API: no function of the library throws, apart from `std::bad_alloc`.
template <class T>
using Result = tl::expected<T, Error>;

/// Makes an error that a function can return as its `Result`.
tl::unexpected<Error> fail(ErrorCode code, std::string message);
/// Returns fail(ErrorCode::kInvalidData, message).
tl::unexpected<Error> invalid_data(std::string message);

/// Returns the error with `where` and ": " in front of its message, as in "drawing.ndjson:12: ...".
Error with_context(Error error, const std::string& where);

}  // namespace felt
