/// The first part of the AppImage: a static program that unpacks the squashfs image behind it, and
/// runs AppRun of that image. It needs neither FUSE nor root, and uses no library of the system.
///
/// The first start unpacks the image into `feltline-appimage/ID` in the cache folder of the user;
/// later starts use the unpacked files. ID is a hash of the image. A start that unpacks also
/// removes the files of other versions, unless they are in use. Without a cache folder, the image
/// is unpacked into a temporary folder, which is removed at the end.
#include <elf.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

extern "C" {
#include <squashfuse/squashfuse.h>
}

namespace {

namespace fs = std::filesystem;

constexpr const char* kHelp =
    "An AppImage: a program with all files that it needs. Its options, besides those of the "
    "program:\n"
    "  --appimage-extract          unpack the files into ./squashfs-root and exit\n"
    "  --appimage-extract-and-run  run the program (the same as without this option)\n"
    "  --appimage-offset           print where the squashfs image begins and exit\n"
    "  --appimage-version          print the version of this runtime and exit\n"
    "  --appimage-help             show this help and exit\n"
    "The program is the desktop program; `cli` as the first argument runs the command line "
    "program.\n";

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "AppImage: %s\n", what.c_str());
  std::exit(127);
}

/// Returns the path of this file. `argument` is the first argument of the program; it is used if
/// /proc is missing.
fs::path own_path(const char* argument) {
  std::error_code error;
  fs::path path = fs::read_symlink("/proc/self/exe", error);
  if (error) path = fs::absolute(argument, error);
  return path;
}

/// Returns the offset of the squashfs image, which begins where the program ends.
std::size_t image_offset(const fs::path& self) {
  Elf64_Ehdr header{};
  std::FILE* file = std::fopen(self.c_str(), "rb");
  const bool is_read = file && std::fread(&header, sizeof header, 1, file) == 1;
  if (file) std::fclose(file);
  if (!is_read) fail("cannot read " + self.string());
  return header.e_shoff + std::size_t(header.e_shnum) * header.e_shentsize;
}

bool write_file(sqfs& image, sqfs_inode& inode, const fs::path& path) {
  const int fd =
      ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, inode.base.mode & 0777);
  if (fd < 0) return false;
  std::vector<char> buffer(1 << 20);
  sqfs_off_t position = 0;
  bool is_good = true;
  while (is_good && position < sqfs_off_t(inode.xtra.reg.file_size)) {
    auto size = sqfs_off_t(buffer.size());
    is_good = sqfs_read_range(&image, &inode, position, &size, buffer.data()) == SQFS_OK &&
              size > 0 && ::write(fd, buffer.data(), std::size_t(size)) == size;
    position += size;
  }
  return ::close(fd) == 0 && is_good;
}

bool write_entry(sqfs& image, const sqfs_traverse& at, const fs::path& path) {
  sqfs_inode inode;
  if (sqfs_inode_get(&image, &inode, at.entry.inode) != SQFS_OK) return false;
  if (S_ISDIR(inode.base.mode)) return ::mkdir(path.c_str(), 0755) == 0;
  if (S_ISREG(inode.base.mode)) return write_file(image, inode, path);
  if (!S_ISLNK(inode.base.mode)) return false;
  std::vector<char> target(inode.xtra.symlink_size + 1);
  std::size_t size = target.size();
  return sqfs_readlink(&image, &inode, target.data(), &size) == SQFS_OK &&
         ::symlink(target.data(), path.c_str()) == 0;
}

/// Unpacks the image into the folder `root`, which must exist. Returns the path that could not be
/// written, or "".
std::string unpack(const fs::path& self, std::size_t offset, const fs::path& root) {
  sqfs image;
  if (sqfs_open_image(&image, self.c_str(), offset) != SQFS_OK) return self.string();
  sqfs_traverse at;
  sqfs_err error = sqfs_traverse_open(&at, &image, sqfs_inode_root(&image));
  std::string failed;
  while (error == SQFS_OK && failed.empty() && sqfs_traverse_next(&at, &error)) {
    if (at.dir_end) continue;
    const fs::path path = root / at.path;
    if (!write_entry(image, at, path)) failed = path.string();
  }
  sqfs_traverse_close(&at);
  sqfs_fd_close(image.fd);
  sqfs_destroy(&image);
  return error == SQFS_OK ? failed : self.string();
}

/// Opens the folder and locks it as one that is in use. The lock ends with the process, also after
/// exec.
void hold(const fs::path& folder) {
  const int fd = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY);
  if (fd >= 0) ::flock(fd, LOCK_SH);
}

/// Removes the files of versions other than `kept`, unless a process holds them.
void remove_others(const fs::path& cache, const fs::path& kept) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(cache, error)) {
    if (entry.path() == kept) continue;
    const int fd = ::open(entry.path().c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (fd < 0) continue;
    if (::flock(fd, LOCK_EX | LOCK_NB) == 0) fs::remove_all(entry.path(), error);
    ::close(fd);
  }
}

/// Returns the cache folder of all versions, or "" if it cannot be made.
fs::path cache_folder() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  const char* home = std::getenv("HOME");
  fs::path folder;
  if (cache && *cache == '/') {
    folder = cache;
  } else if (home && *home == '/') {
    folder = fs::path(home) / ".cache";
  } else {
    return {};
  }
  folder /= "feltline-appimage";
  std::error_code error;
  fs::create_directories(folder, error);
  return error || ::access(folder.c_str(), W_OK) != 0 ? fs::path() : folder;
}

/// Returns the folder of the unpacked files in the cache, or "" if they cannot be stored there.
/// They are unpacked under another name and then renamed, so that the folder is complete even if
/// two starts unpack at the same time.
fs::path cached(const fs::path& self, std::size_t offset) {
  const fs::path cache = cache_folder();
  if (cache.empty()) return {};
  fs::path folder = cache / FELT_APPIMAGE_ID;
  std::error_code error;
  if (fs::is_directory(folder, error)) return folder;
  std::string name = (cache / "new-XXXXXX").string();  // mkdtemp() replaces the X
  if (!::mkdtemp(name.data())) return {};
  const int fd = ::open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd >= 0) ::flock(fd, LOCK_SH);
  const bool is_complete = unpack(self, offset, name).empty();
  if (is_complete) fs::rename(name, folder, error);
  if (!is_complete || error) fs::remove_all(name, error);
  if (fd >= 0) ::close(fd);
  if (!fs::is_directory(folder, error)) return {};
  remove_others(cache, folder);
  return folder;
}

[[noreturn]] void run(const fs::path& folder, char** argv) {
  ::setenv("APPDIR", folder.c_str(), 1);
  const std::string program = (folder / "AppRun").string();
  argv[0] = const_cast<char*>(program.c_str());
  ::execv(program.c_str(), argv);
  fail("cannot run " + program + ": " + std::strerror(errno));
}

/// Unpacks into a temporary folder, runs the program as a child, and removes the folder.
int run_from_temporary(const fs::path& self, std::size_t offset, char** argv) {
  std::error_code error;
  // mkdtemp() replaces the X.
  std::string folder = (fs::temp_directory_path(error) / "feltline-XXXXXX").string();
  if (!::mkdtemp(folder.data())) fail("neither the cache nor a temporary folder can be written");
  const std::string failed = unpack(self, offset, folder);
  int status = 127 << 8;
  if (failed.empty()) {
    const pid_t child = ::fork();
    if (child == 0) run(folder, argv);
    if (child > 0) ::waitpid(child, &status, 0);
  }
  fs::remove_all(folder, error);
  if (!failed.empty()) fail("cannot write " + failed);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int extract(const fs::path& self, std::size_t offset) {
  const fs::path root = "squashfs-root";
  std::error_code error;
  if (!fs::create_directory(root, error)) fail("squashfs-root exists, or cannot be created");
  const std::string failed = unpack(self, offset, root);
  if (!failed.empty()) fail("cannot write " + failed);
  std::puts(root.c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const fs::path self = own_path(argv[0]);
  const std::size_t offset = image_offset(self);
  const std::string_view option = argc > 1 ? argv[1] : "";
  if (option == "--appimage-extract") return extract(self, offset);
  if (option == "--appimage-offset") return std::printf("%zu\n", offset) < 0;
  if (option == "--appimage-version") return std::puts("Feltline " FELT_VERSION) < 0;
  if (option == "--appimage-help") return std::fputs(kHelp, stdout) < 0;
  if (option == "--appimage-extract-and-run") {
    argv[1] = argv[0];
    ++argv;
  } else if (option.starts_with("--appimage-")) {
    fail("unknown option " + std::string(option) + " (--appimage-help)");
  }
  std::error_code error;
  ::setenv("APPIMAGE", self.c_str(), 1);
  ::setenv("ARGV0", argv[0], 1);
  ::setenv("OWD", fs::current_path(error).c_str(), 1);
  const fs::path folder = cached(self, offset);
  if (folder.empty()) return run_from_temporary(self, offset, argv);
  hold(folder);
  run(folder, argv);
}
