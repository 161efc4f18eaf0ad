// What is asked of the operating system: all its calls stand behind this header, in posix.cpp and in windows.cpp.
// Where a call fails, errno says why. Names are UTF-8 everywhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::platform {

// Files ---------------------------------------------------------------------------------------------------------------

enum class FileKind { file, folder, pipe, other };  // pipe: or a socket

struct FileStatus {
  FileKind kind = FileKind::other;
  std::uint64_t device = 0;  // with the number: which file it is; 0 where the system does not tell it
  std::uint64_t number = 0;
  std::uint64_t size = 0;
  std::int64_t changed_s = 0;
  std::int64_t changed_ns = 0;
  unsigned mode = 0;  // of Windows: who may write alone
  unsigned owner = 0;
  unsigned group = 0;
};

inline bool is_same_file(const FileStatus& a, const FileStatus& b) {
  return a.number == b.number && (a.device == b.device || a.device == 0 || b.device == 0);
}

std::optional<FileStatus> status_of(int descriptor);
/// Links followed.
std::optional<FileStatus> status_of(const std::string& path);

/// An open file by its number, or -1. Children do not get it.
int open_to_read(const std::string& path);
/// For a device or a pipe that is there.
int open_to_append(const std::string& path);
/// A new file, open for reading and writing, held: others see in remove_if_left() that it is in use. EAGAIN: another
/// name might do.
int make_held_file(const std::string& path, unsigned mode);
/// A file without a name; -1 where the system or the folder knows none.
int make_unnamed_file(const std::string& folder);
/// Removes a file that make_held_file() made and that nobody holds: it was left by a process that was killed.
void remove_if_left(const std::string& path);

/// How many bytes there were, 0 at the end; -1 if that failed.
std::ptrdiff_t read(int descriptor, char* into, std::size_t count);
std::ptrdiff_t write(int descriptor, const char* bytes, std::size_t count);
/// May run while another thread appends.
std::ptrdiff_t read_at(int descriptor, char* into, std::size_t count, std::uint64_t offset);
/// At the end of a file that was made here.
std::ptrdiff_t append(int descriptor, const char* bytes, std::size_t count);
bool rewind(int descriptor);
/// Nothing is in it, and the next byte is its first.
bool empty(int descriptor);
/// What was written lasts.
bool sync(int descriptor);
bool close(int descriptor);

/// Takes the place of what stands there.
bool rename(const std::string& from, const std::string& to);
/// A second name.
bool link(const std::string& path, const std::string& name);
bool remove_file(const std::string& path);
/// A file, or a folder that is empty.
bool remove_name(const char* path);
bool may_write(const std::string& path);
/// Permissions and owner of what a new file replaces, as far as the user may give them.
void adopt(int descriptor, const FileStatus& replaced);
/// What the user calls that gives permission to write.
extern const char* const kAllowWriting;

/// An open file that the caller of this process left open for it.
enum class LeftOpen { no, for_reading, for_writing };
LeftOpen left_open(int descriptor);

/// An open folder that can be locked, for all who ask this way, until it goes or the process ends.
class OpenFolder;
struct CloseFolder {
  void operator()(OpenFolder* folder) const;
};
using FolderHandle = std::unique_ptr<OpenFolder, CloseFolder>;
/// Null if it cannot be opened.
FolderHandle open_folder(const std::string& folder);
enum class Lock { shared, exclusive };
/// False with errno EWOULDBLOCK if another has it, and with another one where there are no such locks.
bool try_lock(OpenFolder& folder, Lock kind);
/// Names given in the folder last.
bool sync(const OpenFolder& folder);

/// What happens to files of folders that are watched. Linux: inotify, which knows nothing of what other machines write
/// into a folder that they share.
enum class ChangeKind {
  begun,     // a file is new, or is being written to
  finished,  // one that was written to is closed, or it came here whole under this name
  gone,
  folder,  // a folder is new
  lost,    // some changes were: no watch and no name is told
};
struct Change {
  ChangeKind kind;
  int watch;
  std::string name;  // empty: the folder itself
};
/// An open file by its number, or -1 where there is no such thing or no more of them may be had.
int open_changes();
/// Watches a folder, without those in it: the number of the watch, or -1.
int watch_folder(int changes, const std::string& folder);
/// Waits for some; empty if nothing happens in that time.
std::vector<Change> wait_for_changes(int changes, int most_ms);

// The process ---------------------------------------------------------------------------------------------------------

inline constexpr int kStandardInput = 0;
inline constexpr int kStandardOutput = 1;
inline constexpr int kStandardError = 2;

/// The bytes of the three streams as they are, and none of them closed: the first file that is opened would take its
/// place.
void prepare_standard_streams();
/// On how many processors this process may run, at least 1: those that it was bound to, where it was.
unsigned processors();
/// As the user wrote them.
std::vector<std::string> arguments_of(int count, const char* const* arguments);
/// Of an environment variable; nothing if it is not set.
std::optional<std::string> environment(const char* name);
/// Where users keep their own settings, empty if nothing tells.
std::string settings_folder();

bool is_terminal(int descriptor);
/// 0 where it does not say.
std::size_t terminal_columns(int descriptor);
/// Of a terminal.
bool shows_colours(int descriptor);

/// From now on `end` is called with what ends the process from outside, at any moment, on any thread, and may do
/// what a signal handler may. What the parent had it ignore stays ignored.
void call_at_end(void (*end)(int signal));
/// As the process would have ended by itself.
[[noreturn]] void end_by(int signal);
/// Another thread is ending the process.
void wait_for_end();

}  // namespace plumbline::platform
