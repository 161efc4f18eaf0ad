#include "nc/syntax/line_source.hpp"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace plumbline::nc {

LineSource::LineSource(const InputFile& file, char goes_on, std::size_t window)
    : file_(file),
      growing_(dynamic_cast<const GrowingText*>(&file)),
      goes_on_(goes_on),
      size_(window + 1),
      window_(std::make_unique_for_overwrite<char[]>(size_)) {}

// Moves what is left to the front and reads after it; a NUL follows.
void LineSource::fill() {
  std::memmove(window_.get(), window_.get() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  const std::size_t room = size_ - 1 - end_;
  end_ += file_.read(place_.offset + end_, window_.get() + end_, room);
  window_[end_] = '\0';
}

std::size_t longest_line(std::string_view text) {
  std::size_t longest = 0;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    longest = std::max(longest, end);
    text.remove_prefix(end + 1);
  }
  return std::max(longest, text.size());
}

// Whether the line at `next` of the window belongs to the one before. One that ends in % is the head of a program.
bool LineSource::goes_on(std::size_t next) {
  if (goes_on_ == '\0' || window_[begin_] == goes_on_ || window_[next] != goes_on_) return false;
  const std::size_t end = std::string_view(window_.get(), end_).find('\n', next);
  const std::string_view line(window_.get() + next, std::min(end, end_) - next);
  const std::size_t last = line.find_last_not_of(" \t\r");
  return line[last] != '%';
}

bool LineSource::next(Line& line) {
  const auto find_end = [&](std::size_t from) {
    return static_cast<const char*>(std::memchr(window_.get() + from, '\n', end_ - from));
  };
  const char* newline = find_end(begin_);
  if (newline == nullptr) {
    fill();
    if (end_ == 0) return false;
    newline = find_end(begin_);
  }
  std::size_t further = 0;
  const std::size_t enough = size_ / 2;
  while (newline != nullptr && goes_on_ != '\0') {
    std::size_t after = static_cast<std::size_t>(newline - window_.get()) + 1;
    const bool seen = after < end_ && (window_[after] != goes_on_ || find_end(after) != nullptr);
    if (after == end_ && growing_ != nullptr && growing_->ends_block(place_.offset + (after - begin_))) break;
    if (begin_ > 0 && !seen) {
      after -= begin_;
      fill();
      newline = window_.get() + after - 1;
    }
    if (!goes_on(after) || after - begin_ > enough) break;
    const char* const end_of_it = find_end(after);
    newline = end_of_it;
    ++further;
  }
  const char* const text = window_.get() + begin_;
  const char* text_end = newline != nullptr ? newline : window_.get() + end_;
  const char* const next = newline != nullptr ? newline + 1 : text_end;
  const bool ends_here = newline != nullptr || end_ < size_ - 1;
  if (newline != nullptr && text_end != text && text_end[-1] == '\r') --text_end;
  line.text = {text, static_cast<std::size_t>(text_end - text)};
  line.line_end = {text_end, static_cast<std::size_t>(next - text_end)};
  line.place = place_;
  line.whole = ends_here && !middle_;
  middle_ = !ends_here;
  of_long_line_ = ends_here ? 0 : of_long_line_ + line.text.size();
  if (of_long_line_ > kLongestLine) refuse_endless_line(file_.name());
  begin_ = static_cast<std::size_t>(next - window_.get());
  place_.offset += static_cast<std::uint64_t>(next - text);
  place_.line += further + (newline != nullptr ? 1 : 0);
  return true;
}

void LineSource::seek(LinePlace place) {
  const std::uint64_t window = place_.offset - begin_;  // the offset of its first byte
  const bool inside = !middle_ && place.offset >= window && place.offset <= window + end_;
  begin_ = inside ? static_cast<std::size_t>(place.offset - window) : 0;
  if (!inside) end_ = 0;
  place_ = place;
  middle_ = false;
  of_long_line_ = 0;
}

}  // namespace plumbline::nc
