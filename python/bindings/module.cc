#include "bindings.h"

namespace felt::python {
namespace {

/// Returns the class of feltline._types for an error.
const char* class_name(ErrorCode code) {
  switch (code) {
    case ErrorCode::kNotFound:
      return "NotFoundError";
    case ErrorCode::kIo:
      return "FileError";
    case ErrorCode::kInvalidArgument:
    case ErrorCode::kInvalidData:
    case ErrorCode::kLimitExceeded:
    case ErrorCode::kUnsupported:
      break;
  }
  return "DataError";
}

const char* code_name(ErrorCode code) {
  switch (code) {
    case ErrorCode::kInvalidArgument:
      return "invalid-argument";
    case ErrorCode::kInvalidData:
      return "invalid-data";
    case ErrorCode::kLimitExceeded:
      return "limit-exceeded";
    case ErrorCode::kNotFound:
      return "not-found";
    case ErrorCode::kIo:
      return "io";
    case ErrorCode::kUnsupported:
      break;
  }
  return "unsupported";
}

void raise(const Error& error) {
  const py::object type = py::module_::import("feltline._types").attr(class_name(error.code));
  // A message may quote bytes of a file that are not UTF-8.
  const auto text = py::reinterpret_steal<py::object>(PyUnicode_DecodeUTF8(
      error.message.data(), static_cast<py::ssize_t>(error.message.size()), "replace"));
  const py::object exception = type(text);
  exception.attr("code") = code_name(error.code);
  PyErr_SetObject(type.ptr(), exception.ptr());
}

}  // namespace
}  // namespace felt::python

PYBIND11_MODULE(_feltline, module) {
  using namespace felt::python;
  py::register_exception_translator([](std::exception_ptr pointer) {
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const FeltError& error) {
      raise(error.error);
    }
  });
  module.attr("__version__") = FELT_PYTHON_VERSION;
  bind_stroke(module);
  bind_drawing(module);
  bind_recording(module);
  bind_fit(module);
  bind_files(module);
  bind_trial(module);
}
