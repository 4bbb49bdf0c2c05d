#include "felt/base/result.h"

namespace felt {

tl::unexpected<Error> fail(ErrorCode code, std::string message) {
  return tl::unexpected<Error>(Error{code, std::move(message)});
}

tl::unexpected<Error> invalid_data(std::string message) {
  return fail(ErrorCode::kInvalidData, std::move(message));
}

Error with_context(Error error, const std::string& where) {
  error.message = where + ": " + error.message;
  return error;
}

}  // namespace felt
