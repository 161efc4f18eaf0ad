// What is read: a file, or a text that is in memory.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace plumbline {

/// The name by which standard input and output are asked for on the command line.
inline constexpr std::string_view kStandardStream = "-";

/// Where input comes from. A path of a file ("-": standard input) is one as it stands; copies share a text.
class Source {
 public:
  Source() = default;
  Source(std::string path) : name_(std::move(path)) {}  // NOLINT: nearly all that is read is a file
  Source(const char* path) : name_(path) {}             // NOLINT
  /// A text that is read as the file `name` would be: messages call it so, and what the text refers to is looked for
  /// beside that name.
  static Source held(std::string name, std::shared_ptr<const std::string> text) {
    Source source(std::move(name));
    source.text_ = std::move(text);
    return source;
  }
  static Source held(std::string name, std::string text) {
    return held(std::move(name), std::make_shared<const std::string>(std::move(text)));
  }

  /// As the user wrote it; "<stdin>" for standard input.
  std::string name() const { return is_standard_input() ? "<stdin>" : name_; }
  /// As it was given.
  const std::string& path() const { return name_; }
  bool is_held() const { return text_ != nullptr; }
  bool is_standard_input() const { return !is_held() && name_ == kStandardStream; }
  /// Nothing was named.
  bool empty() const { return name_.empty() && !is_held(); }
  /// Null: a file.
  const std::shared_ptr<const std::string>& text() const { return text_; }

 private:
  std::string name_;
  std::shared_ptr<const std::string> text_;
};

}  // namespace plumbline
