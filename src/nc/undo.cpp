#include "nc/undo.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/hash.hpp"

namespace plumbline::nc {
namespace {

constexpr std::string_view kHeader = "plumbline undo 1\n";
constexpr std::string_view kReplaced = "replaced ";
constexpr std::string_view kEnd = "end ";
constexpr std::size_t kChunk = std::size_t{1} << 16U;
constexpr std::size_t kLongestLine = 128;  // of the undo file's own lines

[[noreturn]] void refuse_undo(const InputFile& undo, std::string_view code, std::string message) {
  Place place;
  place.file = undo.name();
  refuse(code, std::move(message), "use the .undo file that was written with this very program, unchanged since",
         place);
}

// Calls take(bytes) for [from, to) of a file, piece by piece; false if the file ends before.
template <class Take>
bool for_bytes(const InputFile& file, std::uint64_t from, std::uint64_t to, Take&& take) {
  std::array<char, kChunk> chunk;
  while (from < to) {
    const std::size_t got = file.read(from, chunk.data(), std::min<std::uint64_t>(chunk.size(), to - from));
    if (got == 0) return false;
    take(std::string_view(chunk.data(), got));
    from += got;
  }
  return true;
}

// Reads an undo file from its begin to its end.
class UndoReader {
 public:
  explicit UndoReader(const InputFile& file) : file_(file) {
    if (line() + "\n" != kHeader) refuse_format();
  }

  struct Entry {
    bool is_end = false;
    std::array<std::uint64_t, 4> numbers{};  // replaced: offset, size, original size. end: sizes, hashes
  };

  Entry next() {
    const std::string text = line();
    Entry entry;
    entry.is_end = text.starts_with(kEnd);
    if (!entry.is_end && !text.starts_with(kReplaced)) refuse_format();
    std::string_view rest = std::string_view(text).substr(entry.is_end ? kEnd.size() : kReplaced.size());
    const std::size_t count = entry.is_end ? 4 : 3;
    for (std::size_t i = 0; i < count; ++i) entry.numbers[i] = number(rest, entry.is_end && i >= 2 ? 16 : 10);
    if (!rest.empty()) refuse_format();
    return entry;
  }

  // The bytes behind the last entry go to `take`, the line end behind them is skipped.
  template <class Take>
  void bytes(std::uint64_t size, Take&& take) {
    if (size >= file_.size() || !for_bytes(file_, at_, at_ + size, take)) refuse_format();
    at_ += size + 1;
  }

  [[noreturn]] void refuse_format() const {
    refuse_undo(file_, "undo-format", "is no undo file of plumbline, or is cut short");
  }

 private:
  std::string line() {
    std::array<char, kLongestLine> text;
    const std::string_view read(text.data(), file_.read(at_, text.data(), text.size()));
    const std::size_t end = read.find('\n');
    if (end == std::string_view::npos) refuse_format();
    at_ += end + 1;
    return std::string(read.substr(0, end));
  }

  std::uint64_t number(std::string_view& rest, int base) const {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value, base);
    if (error != std::errc()) refuse_format();
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    if (rest.starts_with(' ')) rest.remove_prefix(1);
    return value;
  }

  const InputFile& file_;
  std::uint64_t at_ = 0;
};

}  // namespace

UndoLog::UndoLog(OutputFile& file) : file_(file) { file_.write(kHeader); }

void UndoLog::replaced(std::uint64_t offset, std::uint64_t size, std::string_view original) {
  if (all_) return;
  const bool touches = holds_ && offset == offset_ + size_ && original_.size() < kChunk;
  if (!touches) {
    flush();
    offset_ = offset;
    size_ = 0;
    original_.clear();
    holds_ = true;
  }
  size_ += size;
  original_ += original;
}

void UndoLog::replaced_all() {
  file_.restart();
  file_.write(kHeader);
  original_.clear();
  holds_ = false;
  all_ = true;
}

void UndoLog::flush() {
  if (!holds_) return;
  file_.write(fmt::format("{}{} {} {}\n", kReplaced, offset_, size_, original_.size()));
  file_.write(original_);
  file_.write("\n");
  holds_ = false;
}

void UndoLog::finish(const InputFile& original, std::uint64_t output_size, std::uint64_t output_hash) {
  flush();
  if (all_) {
    file_.write(fmt::format("{}0 {} {}\n", kReplaced, output_size, original.size()));
    for_bytes(original, 0, original.size(), [&](std::string_view bytes) { file_.write(bytes); });
    file_.write("\n");
  }
  file_.write(fmt::format("{}{} {} {} {}\n", kEnd, original.size(), output_size, to_hex(hash_of(original)),
                          to_hex(output_hash)));
}

std::uint64_t hash_of(const InputFile& file) {
  std::uint64_t hash = fnv1a({});
  for_bytes(file, 0, file.size(), [&](std::string_view bytes) { hash = fnv1a(bytes, hash); });
  return hash;
}

void restore(const InputFile& rewritten, const InputFile& undo, OutputFile& out) {
  UndoReader reader(undo);
  std::uint64_t at = 0;
  std::uint64_t hash = fnv1a({});
  const auto emit = [&](std::string_view bytes) {
    hash = fnv1a(bytes, hash);
    out.write(bytes);
  };
  const auto keep = [&](std::uint64_t to) {
    if (to < at || !for_bytes(rewritten, at, to, emit)) {
      refuse_undo(undo, "undo-mismatch", fmt::format("does not fit {}", rewritten.name()));
    }
  };
  UndoReader::Entry entry = reader.next();
  for (; !entry.is_end; entry = reader.next()) {
    keep(entry.numbers[0]);
    at = entry.numbers[0] + entry.numbers[1];
    reader.bytes(entry.numbers[2], emit);
  }
  keep(rewritten.size());
  const auto [original_size, output_size, original_hash, output_hash] = entry.numbers;
  if (rewritten.size() != output_size || hash_of(rewritten) != output_hash || out.size() != original_size ||
      hash != original_hash) {
    refuse_undo(undo, "undo-mismatch", fmt::format("does not fit {}", rewritten.name()));
  }
}

}  // namespace plumbline::nc
