// An open file by its number, and what is done with the number alone.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace plumbline {

/// An open file by its number, closed when this goes.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept;
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor();

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }
  /// Hands the number over to the caller, who closes it.
  int release() { return std::exchange(number_, -1); }
  /// Closes it now; false if the system could not keep what was written.
  bool close();

 private:
  int number_ = -1;
};

/// Writes all of it, interrupted or not; false with errno if that failed.
bool write_all(int descriptor, const char* bytes, std::size_t count);

/// Copies one open file to another, from where each stands to the end of the first; false with errno if that failed.
/// `look` sees each chunk first.
bool copy_all(int from, int to, const std::function<void(std::string_view)>& look = {});

/// What to do where a file could not be opened: `usual`, but of an `error` (errno) that says that too many are open.
std::string way_out(int error, std::string usual);

}  // namespace plumbline
