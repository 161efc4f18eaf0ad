// Signals that end the process, and what it takes with it when they do.
#pragma once

#include <atomic>
#include <string>

namespace plumbline {

/// From now on SIGINT, SIGTERM, SIGHUP, SIGPIPE and SIGXFSZ remove the names that are kept below, and end the process
/// as they always do. What its parent had it ignore stays ignored. For programs to call; the libraries do not.
void remove_names_on_signals();

/// The name of a file, or of a folder that is empty then, that does not outlive the process: removed when this goes,
/// and by the signals above. It need not exist yet. A process that is killed otherwise leaves it.
class PassingName {
 public:
  explicit PassingName(std::string path);
  ~PassingName();
  PassingName(PassingName&& other) noexcept;
  PassingName& operator=(PassingName&& other) noexcept;
  PassingName(const PassingName&) = delete;
  PassingName& operator=(const PassingName&) = delete;

  const std::string& path() const { return path_; }
  /// It is another's now, or gone: nobody removes it.
  void let_go();

  struct Slot;

 private:
  void remove();
  std::string path_;
  Slot* slot_ = nullptr;
};

/// While one lives, the signals above wait: for the few renames of files that belong together.
class SignalsWait {
 public:
  SignalsWait();
  ~SignalsWait();
  SignalsWait(SignalsWait&&) = delete;
  SignalsWait& operator=(SignalsWait&&) = delete;
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;
};

}  // namespace plumbline
