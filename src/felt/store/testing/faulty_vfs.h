#pragma once

#include <sqlite3.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <functional>
#include <mutex>
#include <string>

namespace felt::testing {

/// Kinds of calls that SQLite makes on a file.
enum class DiskCall { kOpen, kWrite, kSync };

/// A file system for tests: the real file system, with faults on request. Registered as "faulty"
/// once for the whole program.
class FaultyVfs {
 public:
  static FaultyVfs& the() {
    static FaultyVfs vfs;
    return vfs;
  }
  static constexpr const char* kName = "faulty";

  /// Called before each call to the file system. If `judge` returns SQLITE_OK, the call is carried
  /// out; otherwise the call returns this code. Runs on the caller's thread.
  std::function<int(DiskCall, const std::string& path)> judge;
  /// While a test holds this lock, the disk stalls.
  std::mutex stall;
  /// Number of calls so far, including those that `judge` refused.
  std::atomic<int> calls{0};

  void reset() {
    judge = {};
    calls = 0;
  }

 private:
  struct File {
    sqlite3_file base;
    std::string* path;
    sqlite3_file* real;  // the file in the real file system
  };

  FaultyVfs() {
    real_ = sqlite3_vfs_find(nullptr);
    vfs_ = *real_;
    vfs_.zName = kName;
    vfs_.pNext = nullptr;
    vfs_.szOsFile = static_cast<int>(sizeof(File)) + real_->szOsFile;
    vfs_.xOpen = &open;
    sqlite3_vfs_register(&vfs_, 0);
  }

  static int ask(DiskCall call, const std::string& path) {
    FaultyVfs& vfs = the();
    ++vfs.calls;
    const std::lock_guard disk(vfs.stall);
    return vfs.judge ? vfs.judge(call, path) : SQLITE_OK;
  }

  static File* of(sqlite3_file* file) { return reinterpret_cast<File*>(file); }
  static const sqlite3_io_methods* real(sqlite3_file* file) { return of(file)->real->pMethods; }

  static int open(sqlite3_vfs*, const char* name, sqlite3_file* file, int flags, int* out) {
    File* self = of(file);
    self->base.pMethods = nullptr;
    self->path = nullptr;
    self->real = reinterpret_cast<sqlite3_file*>(self + 1);
    const std::string path = name ? name : "";
    if (const int code = ask(DiskCall::kOpen, path); code != SQLITE_OK) return code;
    const int code = the().real_->xOpen(the().real_, name, self->real, flags, out);
    if (self->real->pMethods) {
      self->path = new std::string(path);
      self->base.pMethods = &methods();
    }
    return code;
  }

  static int close(sqlite3_file* f) {
    const int code = real(f)->xClose(of(f)->real);
    delete of(f)->path;
    of(f)->path = nullptr;
    return code;
  }
  static int write(sqlite3_file* f, const void* bytes, int count, sqlite3_int64 at) {
    const int code = ask(DiskCall::kWrite, *of(f)->path);
    if (code == SQLITE_OK) return real(f)->xWrite(of(f)->real, bytes, count, at);
    // A failing disk may have written half of the bytes.
    if (count > 1) real(f)->xWrite(of(f)->real, bytes, count / 2, at);
    return code;
  }
  static int sync(sqlite3_file* f, int flags) {
    const int code = ask(DiskCall::kSync, *of(f)->path);
    return code == SQLITE_OK ? real(f)->xSync(of(f)->real, flags) : code;
  }

  /// Returns methods of version 1, without shared memory and mapping, because an exclusive lock
  /// does not need them.
  static const sqlite3_io_methods& methods() {
    static const sqlite3_io_methods table = [] {
      sqlite3_io_methods m{};
      m.iVersion = 1;
      m.xClose = &close;
      m.xRead = [](sqlite3_file* f, void* out, int n, sqlite3_int64 at) {
        return real(f)->xRead(of(f)->real, out, n, at);
      };
      m.xWrite = &write;
      m.xTruncate = [](sqlite3_file* f, sqlite3_int64 n) {
        return real(f)->xTruncate(of(f)->real, n);
      };
      m.xSync = &sync;
      m.xFileSize = [](sqlite3_file* f, sqlite3_int64* n) {
        return real(f)->xFileSize(of(f)->real, n);
      };
      m.xLock = [](sqlite3_file* f, int n) { return real(f)->xLock(of(f)->real, n); };
      m.xUnlock = [](sqlite3_file* f, int n) { return real(f)->xUnlock(of(f)->real, n); };
      m.xCheckReservedLock = [](sqlite3_file* f, int* n) {
        return real(f)->xCheckReservedLock(of(f)->real, n);
      };
      m.xFileControl = [](sqlite3_file* f, int op, void* p) {
        return real(f)->xFileControl(of(f)->real, op, p);
      };
      m.xSectorSize = [](sqlite3_file* f) { return real(f)->xSectorSize(of(f)->real); };
      m.xDeviceCharacteristics = [](sqlite3_file* f) {
        return real(f)->xDeviceCharacteristics(of(f)->real);
      };
      return m;
    }();
    return table;
  }

  sqlite3_vfs* real_ = nullptr;
  sqlite3_vfs vfs_{};
};

}  // namespace felt::testing
