#include "nc/line_source.hpp"

#include <cstring>

namespace plumbline::nc {

LineSource::LineSource(const InputFile& file, std::size_t window) : file_(file), window_(window + 1) {}

// Moves what is left to the front and reads behind it; a NUL follows.
void LineSource::fill() {
  std::memmove(window_.data(), window_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  const std::size_t room = window_.size() - 1 - end_;
  end_ += file_.read(place_.offset + end_, window_.data() + end_, room);
  window_[end_] = '\0';
}

bool LineSource::next(Line& line) {
  const auto find_end = [&](std::size_t from) {
    return static_cast<const char*>(std::memchr(window_.data() + from, '\n', end_ - from));
  };
  const char* newline = find_end(begin_);
  if (newline == nullptr) {
    fill();
    if (end_ == 0) return false;
    newline = find_end(begin_);
  }
  const char* const text = window_.data() + begin_;
  const char* text_end = newline != nullptr ? newline : window_.data() + end_;
  const char* const next = newline != nullptr ? newline + 1 : text_end;
  const bool ends_here = newline != nullptr || end_ < window_.size() - 1;
  if (newline != nullptr && text_end != text && text_end[-1] == '\r') --text_end;
  line.text = {text, static_cast<std::size_t>(text_end - text)};
  line.line_end = {text_end, static_cast<std::size_t>(next - text_end)};
  line.place = place_;
  line.whole = ends_here && !middle_;
  middle_ = !ends_here;
  begin_ = static_cast<std::size_t>(next - window_.data());
  place_.offset += static_cast<std::uint64_t>(next - text);
  if (newline != nullptr) ++place_.line;
  return true;
}

void LineSource::seek(LinePlace place) {
  const std::uint64_t window = place_.offset - begin_;  // the offset of its first byte
  const bool inside = !middle_ && place.offset >= window && place.offset <= window + end_;
  begin_ = inside ? static_cast<std::size_t>(place.offset - window) : 0;
  if (!inside) end_ = 0;
  place_ = place;
  middle_ = false;
}

}  // namespace plumbline::nc
