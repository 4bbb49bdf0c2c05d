#include "steady_file.h"

#include "felt/base/read_file.h"
#include "input.h"

namespace felt::cli {

Result<Shake> shake_of(const std::string& argument) {
  if (argument.find(',') != std::string::npos) {
    Result<Shake> shake = shake_from_text(argument);
    if (!shake) return fail(ErrorCode::kInvalidArgument, shake.error().message);
    return shake;
  }
  const Result<std::string> text = read_file(argument, kMaxShakeBytes);
  if (!text) return tl::unexpected(text.error());
  Result<Shake> shake = read_shake(*text);
  if (!shake) return tl::unexpected(with_context(shake.error(), input_name(argument)));
  return shake;
}

}  // namespace felt::cli
