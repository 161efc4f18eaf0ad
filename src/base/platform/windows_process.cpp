#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include <fcntl.h>
#include <io.h>
#include <windows.h>
// After windows.h, which it needs.
#include <shellapi.h>

#include "base/platform/platform.hpp"
#include "base/platform/windows_text.hpp"

namespace plumbline::platform {
namespace {

constexpr UINT kEndedByControlC = 0xC000013A;  // STATUS_CONTROL_C_EXIT

std::atomic<void (*)(int)> ending = nullptr;
UINT page_before = 0;  // how the console shows bytes, before and after

struct Known {
  DWORD error;
  int number;
};
constexpr std::array kKnown{
    Known{ERROR_FILE_NOT_FOUND, ENOENT},
    Known{ERROR_PATH_NOT_FOUND, ENOENT},
    Known{ERROR_INVALID_DRIVE, ENOENT},
    Known{ERROR_BAD_NETPATH, ENOENT},
    Known{ERROR_BAD_NET_NAME, ENOENT},
    Known{ERROR_INVALID_NAME, ENOENT},
    Known{ERROR_BAD_PATHNAME, ENOENT},
    Known{ERROR_FILENAME_EXCED_RANGE, ENAMETOOLONG},
    Known{ERROR_ACCESS_DENIED, EACCES},
    Known{ERROR_SHARING_VIOLATION, EACCES},
    Known{ERROR_LOCK_VIOLATION, EACCES},
    Known{ERROR_WRITE_PROTECT, EROFS},
    Known{ERROR_ALREADY_EXISTS, EEXIST},
    Known{ERROR_FILE_EXISTS, EEXIST},
    Known{ERROR_DISK_FULL, ENOSPC},
    Known{ERROR_HANDLE_DISK_FULL, ENOSPC},
    Known{ERROR_NOT_ENOUGH_MEMORY, ENOMEM},
    Known{ERROR_OUTOFMEMORY, ENOMEM},
    Known{ERROR_TOO_MANY_OPEN_FILES, EMFILE},
    Known{ERROR_INVALID_HANDLE, EBADF},
    Known{ERROR_DIR_NOT_EMPTY, ENOTEMPTY},
    Known{ERROR_DIRECTORY, ENOTDIR},
    Known{ERROR_NOT_SAME_DEVICE, EXDEV},
    Known{ERROR_BROKEN_PIPE, EPIPE},
    Known{ERROR_NO_DATA, EPIPE},
    Known{ERROR_NOT_SUPPORTED, ENOTSUP},
    Known{ERROR_INVALID_FUNCTION, ENOTSUP},
};

HANDLE stream_of(int descriptor) {
  return GetStdHandle(descriptor == kStandardInput    ? STD_INPUT_HANDLE
                      : descriptor == kStandardOutput ? STD_OUTPUT_HANDLE
                                                      : STD_ERROR_HANDLE);
}

// Runs on a thread of its own.
BOOL WINAPI at_control(DWORD event) {
  void (*const end)(int) = ending.load();
  if (end == nullptr) return FALSE;
  end(event == CTRL_C_EVENT || event == CTRL_BREAK_EVENT ? SIGINT : SIGTERM);
  Sleep(INFINITE);  // whoever waits ends the process; where this returns, Windows would
  return TRUE;
}

void give_back_console() {
  if (page_before != 0) SetConsoleOutputCP(page_before);
}

}  // namespace

std::wstring wide(std::string_view text) {
  if (text.empty()) return {};
  const int length = static_cast<int>(text.size());
  const int size = MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, text.data(), length, nullptr, 0);
  std::wstring result(static_cast<std::size_t>(size), L'\0');
  if (size == 0) errno = EILSEQ;
  MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, text.data(), length, result.data(), size);
  return result;
}

std::string narrow(std::wstring_view text) {
  if (text.empty()) return {};
  const int length = static_cast<int>(text.size());
  const int size = WideCharToMultiByte(CP_UTF8, 0, text.data(), length, nullptr, 0, nullptr, nullptr);
  std::string result(static_cast<std::size_t>(size), '\0');
  WideCharToMultiByte(CP_UTF8, 0, text.data(), length, result.data(), size, nullptr, nullptr);
  return result;
}

void tell_error() {
  const DWORD error = GetLastError();
  errno = EIO;
  for (const Known& known : kKnown) {
    if (known.error == error) errno = known.number;
  }
}

void prepare_standard_streams() {
  for (const int stream : {kStandardInput, kStandardOutput, kStandardError}) {
    if (_get_osfhandle(stream) < 0) {
      _wfreopen(L"NUL", stream == kStandardInput ? L"wb" : L"rb",  // what is done with it fails, as with none
                stream == kStandardInput    ? stdin
                : stream == kStandardOutput ? stdout
                                            : stderr);
    }
    _setmode(stream, _O_BINARY);
  }
  if (!is_terminal(kStandardOutput) && !is_terminal(kStandardError)) return;
  page_before = GetConsoleOutputCP();
  SetConsoleOutputCP(CP_UTF8);
  std::atexit(give_back_console);
}

unsigned processors() {
  DWORD_PTR allowed = 0;
  DWORD_PTR all = 0;
  const bool told = GetProcessAffinityMask(GetCurrentProcess(), &allowed, &all) != 0;
  // Zero: threads of several groups of 64.
  if (told && allowed != 0) return static_cast<unsigned>(std::popcount(static_cast<std::uint64_t>(allowed)));
  return std::max(1U, std::thread::hardware_concurrency());
}

std::vector<std::string> arguments_of(int count, const char* const* arguments) {
  int wide_count = 0;
  wchar_t** const wide_arguments = CommandLineToArgvW(GetCommandLineW(), &wide_count);
  if (wide_arguments == nullptr) return {arguments, arguments + count};
  std::vector<std::string> result;
  for (int i = 0; i < wide_count; ++i) result.push_back(narrow(wide_arguments[i]));
  LocalFree(wide_arguments);
  return result;
}

std::optional<std::string> environment(const char* name) {
  const std::wstring wide_name = wide(name);
  std::wstring value;
  while (true) {
    SetLastError(ERROR_SUCCESS);
    const DWORD size = GetEnvironmentVariableW(wide_name.c_str(), value.data(), static_cast<DWORD>(value.size()));
    if (size == 0 && GetLastError() != ERROR_SUCCESS) return std::nullopt;
    if (size <= value.size()) {
      value.resize(size);
      return narrow(value);
    }
    value.resize(size);
  }
}

std::string settings_folder() {
  const std::string stated = environment("XDG_CONFIG_HOME").value_or("");
  return stated.empty() ? environment("APPDATA").value_or("") : stated;
}

bool is_terminal(int descriptor) {
  DWORD mode = 0;
  return GetConsoleMode(stream_of(descriptor), &mode) != 0;
}

std::size_t terminal_columns(int descriptor) {
  CONSOLE_SCREEN_BUFFER_INFO screen{};
  if (GetConsoleScreenBufferInfo(stream_of(descriptor), &screen) == 0) return 0;
  return static_cast<std::size_t>(screen.srWindow.Right - screen.srWindow.Left + 1);
}

bool shows_colours(int descriptor) {
  DWORD mode = 0;
  return GetConsoleMode(stream_of(descriptor), &mode) != 0 &&
         SetConsoleMode(stream_of(descriptor), mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING) != 0;
}

void call_at_end(void (*end)(int signal)) {
  ending = end;
  SetConsoleCtrlHandler(at_control, TRUE);
}

void end_by(int /*signal*/) {
  give_back_console();
  TerminateProcess(GetCurrentProcess(), kEndedByControlC);
  std::abort();
}

void wait_for_end() { Sleep(INFINITE); }

}  // namespace plumbline::platform
