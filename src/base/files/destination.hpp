// Where output goes: to a file, or to who takes its bytes.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace plumbline {

/// A path of a file ("-": standard output) is one as it stands.
class Destination {
 public:
  using Taker = std::function<void(std::string_view bytes)>;

  Destination() = default;
  Destination(std::string path) : name_(std::move(path)) {}  // NOLINT: nearly all that is written is a file
  Destination(const char* path) : name_(path) {}             // NOLINT
  /// `take` gets all that was written, piece by piece, when it is whole and right, and nothing before; what it throws
  /// is passed on. Messages call the output `name`.
  static Destination taken(std::string name, Taker take) {
    Destination destination(std::move(name));
    destination.take_ = std::move(take);
    return destination;
  }

  const std::string& name() const { return name_; }
  bool is_taken() const { return static_cast<bool>(take_); }
  const Taker& taker() const { return take_; }
  bool empty() const { return name_.empty() && !is_taken(); }

 private:
  std::string name_;
  Taker take_;
};

}  // namespace plumbline
