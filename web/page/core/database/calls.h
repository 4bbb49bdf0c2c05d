#pragma once

#include <cstdint>

namespace felt::page {

/// What the full module asks of the module with SQLite. Each call has a handle (0 if it needs none)
/// and bytes, and returns bytes, written with ByteWriter: first a status (u8), which is 0 or 1 + an
/// ErrorCode. An error is followed by its message; otherwise the comment says what follows.
enum class DatabaseCall : std::uint8_t {
  kCreate,      ///< an empty database: its handle (u32)
  kOpen,        ///< a file, the bytes: its handle (u32)
  kClose,       ///< nothing
  kCheckPages,  ///< nothing
  kRun,         ///< a statement without values, the bytes: nothing
  kPrepare,     ///< a statement, the bytes: its handle (u32)
  kFinalize,    ///< nothing
  /// Whether the statement is reset before (u8), then values with their parameters (u32): whether
  /// there is a row (u8), then its number of columns (u32) and their values.
  kStep,
  kBytes,  ///< the whole file
};

/// The type of a value (u8), before its content. The row of a statement also has what SQLite makes
/// of a text or blob as a whole number and as a real one.
enum class ValueType : std::uint8_t { kNull, kInteger, kReal, kText, kBlob };

}  // namespace felt::page
