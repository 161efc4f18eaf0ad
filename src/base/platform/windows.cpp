#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <io.h>
#include <windows.h>

#include "base/platform/platform.hpp"
#include "base/platform/windows_text.hpp"

namespace plumbline::platform {
namespace {

constexpr DWORD kShareAll = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
constexpr std::int64_t kTicksPerSecond = 10'000'000;  // FILETIME counts 100 ns
constexpr unsigned kReadable = 0444;
constexpr unsigned kReadAndWritable = 0666;
constexpr DWORD kLargestPiece = 1U << 30U;

HANDLE handle_of(int descriptor) {
  const intptr_t handle = descriptor < 0 ? -1 : _get_osfhandle(descriptor);
  return handle < 0 ? INVALID_HANDLE_VALUE : reinterpret_cast<HANDLE>(handle);
}

bool told(BOOL done) {
  if (done == 0) tell_error();
  return done != 0;
}

struct Opening {
  DWORD access = 0;
  DWORD share = kShareAll;
  DWORD how = OPEN_EXISTING;
  DWORD flags = FILE_ATTRIBUTE_NORMAL;
};

HANDLE open_handle(const std::string& path, const Opening& opening) {
  const std::wstring name = wide(path);
  if (name.empty()) {
    if (path.empty()) errno = ENOENT;
    return INVALID_HANDLE_VALUE;
  }
  const HANDLE handle =
      CreateFileW(name.c_str(), opening.access, opening.share, nullptr, opening.how, opening.flags, nullptr);
  if (handle == INVALID_HANDLE_VALUE) tell_error();
  return handle;
}

// A number of the C library, which owns the handle from now on.
int number_of(HANDLE handle, int flags) {
  if (handle == INVALID_HANDLE_VALUE) return -1;
  const int number = _open_osfhandle(reinterpret_cast<intptr_t>(handle), flags | _O_BINARY | _O_NOINHERIT);
  if (number < 0) CloseHandle(handle);
  return number;
}

template <class Info>
bool asked(HANDLE handle, FILE_INFO_BY_HANDLE_CLASS what, Info& info) {
  return GetFileInformationByHandleEx(handle, what, &info, sizeof info) != 0;
}

// Which file it is: 128 bits, of which NTFS fills 64. FAT gives the older number alone.
bool identify_file(HANDLE handle, FileStatus& status) {
  if (FILE_ID_INFO id{}; asked(handle, FileIdInfo, id)) {
    std::array<std::uint64_t, 2> halves{};
    static_assert(sizeof halves == sizeof id.FileId);
    std::memcpy(halves.data(), &id.FileId, sizeof halves);
    status.device = id.VolumeSerialNumber;
    status.number = halves[0] ^ halves[1];
    return true;
  }
  BY_HANDLE_FILE_INFORMATION older{};
  if (!told(GetFileInformationByHandle(handle, &older))) return false;
  status.device = older.dwVolumeSerialNumber;
  status.number = (std::uint64_t{older.nFileIndexHigh} << 32U) | older.nFileIndexLow;
  return true;
}

std::optional<FileStatus> status_in(HANDLE handle) {
  FileStatus result;
  if (GetFileType(handle) != FILE_TYPE_DISK) return result;
  FILE_BASIC_INFO basic{};
  FILE_STANDARD_INFO standard{};
  if (!told(asked(handle, FileBasicInfo, basic) && asked(handle, FileStandardInfo, standard)) ||
      !identify_file(handle, result)) {
    return std::nullopt;
  }
  result.kind = standard.Directory != 0 ? FileKind::folder : FileKind::file;
  result.size = static_cast<std::uint64_t>(standard.EndOfFile.QuadPart);
  result.changed_s = basic.LastWriteTime.QuadPart / kTicksPerSecond;
  result.changed_ns = basic.LastWriteTime.QuadPart % kTicksPerSecond * 100;
  result.mode = (basic.FileAttributes & FILE_ATTRIBUTE_READONLY) != 0 ? kReadable : kReadAndWritable;
  return result;
}

// Who scans new files for viruses has them open for a moment.
template <class Call>
bool patiently(Call call) {
  constexpr int kMostPauses = 40;
  constexpr DWORD kPause_ms = 25;
  for (int pauses = 0;; ++pauses) {
    if (call() != 0) return true;
    const DWORD error = GetLastError();
    const bool passes =
        error == ERROR_SHARING_VIOLATION || error == ERROR_ACCESS_DENIED || error == ERROR_LOCK_VIOLATION;
    if (!passes || pauses >= kMostPauses) {
      tell_error();
      return false;
    }
    Sleep(kPause_ms);
  }
}

std::ptrdiff_t count_or_error(BOOL done, DWORD count) {
  if (done != 0) return static_cast<std::ptrdiff_t>(count);
  const DWORD error = GetLastError();
  if (error == ERROR_HANDLE_EOF || error == ERROR_BROKEN_PIPE) return 0;
  tell_error();
  return -1;
}

OVERLAPPED at(std::uint64_t offset) {
  OVERLAPPED place{};
  place.Offset = static_cast<DWORD>(offset);
  place.OffsetHigh = static_cast<DWORD>(offset >> 32U);
  return place;
}

DWORD piece_of(std::size_t count) { return count < kLargestPiece ? static_cast<DWORD>(count) : kLargestPiece; }

}  // namespace

const char* const kAllowWriting = "attrib -r";

std::optional<FileStatus> status_of(int descriptor) {
  const HANDLE handle = handle_of(descriptor);
  if (handle != INVALID_HANDLE_VALUE) return status_in(handle);
  errno = EBADF;
  return std::nullopt;
}

std::optional<FileStatus> status_of(const std::string& path) {
  const HANDLE handle = open_handle(path, {.access = FILE_READ_ATTRIBUTES, .flags = FILE_FLAG_BACKUP_SEMANTICS});
  if (handle == INVALID_HANDLE_VALUE) return std::nullopt;
  std::optional<FileStatus> status = status_in(handle);
  CloseHandle(handle);
  return status;
}

// A folder opens, too, so that it is told from a file that may not be read.
int open_to_read(const std::string& path) {
  return number_of(open_handle(path, {.access = GENERIC_READ, .flags = FILE_FLAG_BACKUP_SEMANTICS}), _O_RDONLY);
}

int open_to_append(const std::string& path) {
  return number_of(open_handle(path, {.access = GENERIC_WRITE}), _O_WRONLY);
}

// Open at all is held: remove_if_left() gets it alone.
int make_held_file(const std::string& path, unsigned /*mode*/) {
  const int made = number_of(open_handle(path, {.access = GENERIC_READ | GENERIC_WRITE, .how = CREATE_NEW}), _O_RDWR);
  if (made < 0 && errno == EEXIST) errno = EAGAIN;
  return made;
}

int make_unnamed_file(const std::string& folder) {
  static thread_local unsigned count = 0;
  const std::string path =
      fmt::format("{}\\plumbline-{}-{}-{}.tmp", folder, GetCurrentProcessId(), GetCurrentThreadId(), ++count);
  return number_of(open_handle(path, {.access = GENERIC_READ | GENERIC_WRITE,
                                      .how = CREATE_ALWAYS,
                                      .flags = FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE}),
                   _O_RDWR);
}

// Alone with it or not at all: whoever has it open is alive.
void remove_if_left(const std::string& path) {
  const HANDLE handle = open_handle(
      path, {.access = DELETE, .share = 0, .flags = FILE_FLAG_DELETE_ON_CLOSE | FILE_FLAG_OPEN_REPARSE_POINT});
  if (handle != INVALID_HANDLE_VALUE) CloseHandle(handle);
}

std::ptrdiff_t read(int descriptor, char* into, std::size_t count) {
  DWORD got = 0;
  const BOOL done = ReadFile(handle_of(descriptor), into, piece_of(count), &got, nullptr);
  return count_or_error(done, got);
}

std::ptrdiff_t write(int descriptor, const char* bytes, std::size_t count) {
  DWORD put = 0;
  if (told(WriteFile(handle_of(descriptor), bytes, piece_of(count), &put, nullptr))) return put;
  return -1;
}

std::ptrdiff_t read_at(int descriptor, char* into, std::size_t count, std::uint64_t offset) {
  DWORD got = 0;
  OVERLAPPED place = at(offset);
  const BOOL done = ReadFile(handle_of(descriptor), into, piece_of(count), &got, &place);
  return count_or_error(done, got);
}

// The place of the file is moved by read_at() of other threads: this asks for its end.
std::ptrdiff_t append(int descriptor, const char* bytes, std::size_t count) {
  DWORD put = 0;
  OVERLAPPED end = at(~std::uint64_t{0});
  if (told(WriteFile(handle_of(descriptor), bytes, piece_of(count), &put, &end))) return put;
  return -1;
}

bool rewind(int descriptor) {
  return told(SetFilePointerEx(handle_of(descriptor), LARGE_INTEGER{}, nullptr, FILE_BEGIN));
}

bool empty(int descriptor) { return rewind(descriptor) && told(SetEndOfFile(handle_of(descriptor))); }

bool sync(int descriptor) { return told(FlushFileBuffers(handle_of(descriptor))); }

bool close(int descriptor) { return _close(descriptor) == 0; }

bool rename(const std::string& from, const std::string& to) {
  const std::wstring old_name = wide(from);
  const std::wstring new_name = wide(to);
  return patiently([&] {
    return MoveFileExW(old_name.c_str(), new_name.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH);
  });
}

bool link(const std::string& path, const std::string& name) {
  return told(CreateHardLinkW(wide(name).c_str(), wide(path).c_str(), nullptr));
}

bool remove_file(const std::string& path) {
  const std::wstring name = wide(path);
  return patiently([&] { return DeleteFileW(name.c_str()); });
}

bool remove_name(const char* path) {
  const std::wstring name = wide(path);
  return DeleteFileW(name.c_str()) != 0 || told(RemoveDirectoryW(name.c_str()));
}

bool may_write(const std::string& path) {
  const DWORD attributes = GetFileAttributesW(wide(path).c_str());
  if (!told(attributes != INVALID_FILE_ATTRIBUTES)) return false;
  if ((attributes & FILE_ATTRIBUTE_DIRECTORY) != 0) return true;  // its attribute means something else
  const HANDLE handle = open_handle(path, {.access = GENERIC_WRITE});
  if (handle == INVALID_HANDLE_VALUE) return false;
  CloseHandle(handle);
  return true;
}

// A file's permissions are those of its folder, unless somebody gave it others.
void adopt(int /*descriptor*/, const FileStatus& /*replaced*/) {}

// Windows names no open files of another process.
LeftOpen left_open(int /*descriptor*/) { return LeftOpen::no; }

// Locked by named objects that are there as long as somebody has them open: one of who has the folder alone, one of
// those who share it, and a mutex for the moment in which both are looked at.
class OpenFolder {
 public:
  explicit OpenFolder(const FileStatus& status)
      : name_(wide(fmt::format("Global\\plumbline-{:x}-{:x}-", status.device, status.number))) {}
  OpenFolder(OpenFolder&&) = delete;
  OpenFolder& operator=(OpenFolder&&) = delete;
  OpenFolder(const OpenFolder&) = delete;
  OpenFolder& operator=(const OpenFolder&) = delete;
  ~OpenFolder() {
    if (held_ != nullptr) CloseHandle(held_);
  }

  bool try_lock(Lock kind) {
    const HANDLE moment = CreateMutexW(nullptr, FALSE, (name_ + L"moment").c_str());
    if (!told(moment != nullptr)) return false;
    WaitForSingleObject(moment, INFINITE);
    const bool taken = is_there(L"alone") || (kind == Lock::exclusive && is_there(L"shared"));
    if (!taken) {
      held_ = CreateEventW(nullptr, TRUE, FALSE, (name_ + (kind == Lock::shared ? L"shared" : L"alone")).c_str());
    }
    const bool done = !taken && told(held_ != nullptr);
    ReleaseMutex(moment);
    CloseHandle(moment);
    if (taken) errno = EWOULDBLOCK;
    return done;
  }

 private:
  bool is_there(const wchar_t* what) const {
    const HANDLE other = OpenEventW(SYNCHRONIZE, FALSE, (name_ + what).c_str());
    if (other == nullptr) return GetLastError() == ERROR_ACCESS_DENIED;  // another user's
    CloseHandle(other);
    return true;
  }

  std::wstring name_;
  HANDLE held_ = nullptr;
};

void CloseFolder::operator()(OpenFolder* folder) const { delete folder; }

FolderHandle open_folder(const std::string& folder) {
  const std::optional<FileStatus> status = status_of(folder);
  if (!status || status->kind != FileKind::folder) return nullptr;
  return FolderHandle(new OpenFolder(*status));
}

bool try_lock(OpenFolder& folder, Lock kind) { return folder.try_lock(kind); }

// Names are written through (rename()).
bool sync(const OpenFolder& /*folder*/) { return true; }

}  // namespace plumbline::platform
