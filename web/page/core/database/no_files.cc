// SQLite without an operating system: all databases of the page are in memory
// (felt/store/database.h).

#include <sqlite3.h>

#include <cstring>

namespace {

int no_open(sqlite3_vfs*, const char*, sqlite3_file* file, int, int*) {
  file->pMethods = nullptr;
  return SQLITE_CANTOPEN;
}
int no_delete(sqlite3_vfs*, const char*, int) {
  return SQLITE_IOERR_DELETE_NOENT;
}
int no_access(sqlite3_vfs*, const char*, int, int* result) {
  *result = 0;
  return SQLITE_OK;
}
int full_name(sqlite3_vfs*, const char* name, int size, char* out) {
  sqlite3_snprintf(size, out, "%s", name);
  return SQLITE_OK;
}
int no_randomness(sqlite3_vfs*, int size, char* out) {
  std::memset(out, 0, static_cast<std::size_t>(size));
  return size;
}
int no_sleep(sqlite3_vfs*, int microseconds) {
  return microseconds;
}
int no_time(sqlite3_vfs*, double* julian_day) {
  *julian_day = 2440587.5;  // 1 January 1970
  return SQLITE_OK;
}

}  // namespace

extern "C" int sqlite3_os_init() {
  static sqlite3_vfs vfs;
  vfs.iVersion = 1;
  vfs.szOsFile = static_cast<int>(sizeof(sqlite3_file));
  vfs.mxPathname = 64;
  vfs.zName = "none";
  vfs.xOpen = no_open;
  vfs.xDelete = no_delete;
  vfs.xAccess = no_access;
  vfs.xFullPathname = full_name;
  vfs.xRandomness = no_randomness;
  vfs.xSleep = no_sleep;
  vfs.xCurrentTime = no_time;
  return sqlite3_vfs_register(&vfs, 1);
}

extern "C" int sqlite3_os_end() {
  return SQLITE_OK;
}
