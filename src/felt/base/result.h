#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace felt {

/// What kind of thing went wrong; the message says the rest.
enum class ErrorCode {
  kInvalidArgument,  ///< the caller's values make no sense together
  kInvalidData,      ///< a file or stream says something that it must not
  kLimitExceeded,    ///< well-formed, but larger than we accept
  kNotFound,         ///< no such file, tool, device
  kIo,               ///< the operating system refused or failed
  kUnsupported,      ///< known, and not done here
};

/// An error for a person: a code, and a message that names the place and the reason.
struct Error {
  ErrorCode code = ErrorCode::kInvalidData;
  std::string message;
};

/// A value, or the reason why there is none. The only error channel across the public API:
/// no function of the library throws, apart from `std::bad_alloc`.
template <class T>
using Result = tl::expected<T, Error>;

/// Makes the error side of a `Result`.
tl::unexpected<Error> fail(ErrorCode code, std::string message);
/// The same with ErrorCode::kInvalidData.
tl::unexpected<Error> invalid_data(std::string message);

/// Puts `where` in front of the message ("drawing.ndjson:12: " + "...").
Error with_context(Error error, const std::string& where);

}  // namespace felt
