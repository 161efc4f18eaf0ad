// Names and figures in two columns, as summaries print them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace plumbline::report {

class TextTable {
 public:
  /// A row; an empty name goes on with the one above.
  void add(std::string_view name, std::string_view figure) {
    text_ += "  ";
    text_ += name;
    text_.append(kNames - std::min(kNames, name.size()), ' ');
    text_ += figure;
    text_ += '\n';
  }
  const std::string& text() const { return text_; }

 private:
  static constexpr std::size_t kNames = 22;
  std::string text_;
};

/// "1 h 02 min 03.4 s", "12 min 03.4 s", "3.42 s".
std::string time_text(double seconds);

/// "1,234,567"
std::string count_text(std::uint64_t count);
/// "1 pose", "2,000 poses": the noun's plural ends in s.
std::string count_text(std::uint64_t count, std::string_view noun);

}  // namespace plumbline::report
