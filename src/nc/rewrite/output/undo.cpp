#include "nc/rewrite/output/undo.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/text/hash.hpp"

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

// What one program's part of an undo file says at its end.
struct Part {
  std::uint64_t begin = 0;  // in the undo file
  std::uint64_t end = 0;
  std::uint64_t original_size = 0, output_size = 0, original_hash = 0, output_hash = 0;
};

// A span of the output and, after `at` in the undo file, what it stands for.
struct Replaced {
  std::uint64_t offset = 0, size = 0, original_size = 0, at = 0;
};

// Reads an undo file from its begin to its end.
class UndoReader {
 public:
  explicit UndoReader(const InputFile& file, std::uint64_t begin = 0) : file_(file), at_(begin) {
    part_.begin = begin;
    if (line() + "\n" != kHeader) refuse_format();
  }

  // The next span of this part; nothing at its end. Spans come one after the other, and all that is written in the end
  // is as much as the part says: no file can make it more than the output and the undo file hold.
  std::optional<Replaced> next() {
    const std::string text = line();
    if (text.starts_with(kEnd)) {
      finish(std::string_view(text).substr(kEnd.size()));
      return std::nullopt;
    }
    if (!text.starts_with(kReplaced)) refuse_format();
    const auto numbers = numbers_of<3>(std::string_view(text).substr(kReplaced.size()), 3);
    const Replaced span{numbers[0], numbers[1], numbers[2], at_};
    const std::uint64_t remaining = file_.size() - std::min(at_, file_.size());
    if (span.offset < covered_ || span.size > kMost - span.offset || span.original_size >= remaining) refuse_format();
    written_ += span.offset - covered_ + span.original_size;
    covered_ = span.offset + span.size;
    at_ += span.original_size + 1;
    return span;
  }

  // Once next() gave nothing.
  const Part& part() const { return part_; }

  [[noreturn]] void refuse_format() const {
    refuse_undo(file_, "undo-format", "is no undo file of plumbline, or is cut short");
  }

 private:
  static constexpr std::uint64_t kMost = std::uint64_t{1} << 62U;  // bytes; no sum of a few overflows

  void finish(std::string_view text) {
    const auto numbers = numbers_of<4>(text, 2);
    part_ = {part_.begin, at_, numbers[0], numbers[1], numbers[2], numbers[3]};
    const bool holds = covered_ <= part_.output_size && part_.output_size <= kMost;
    if (!holds || written_ + (part_.output_size - covered_) != part_.original_size) refuse_format();
  }

  std::string line() {
    std::array<char, kLongestLine> text;
    const std::string_view read(text.data(), file_.read(at_, text.data(), text.size()));
    const std::size_t end = read.find('\n');
    if (end == std::string_view::npos) refuse_format();
    at_ += end + 1;
    return std::string(read.substr(0, end));
  }

  // Numbers between blanks, those after the first `decimals` hexadecimal.
  template <std::size_t kCount>
  std::array<std::uint64_t, kCount> numbers_of(std::string_view rest, std::size_t decimals) const {
    std::array<std::uint64_t, kCount> numbers{};
    for (std::size_t i = 0; i < kCount; ++i) {
      const auto [end, error] =
          std::from_chars(rest.data(), rest.data() + rest.size(), numbers[i], i < decimals ? 10 : 16);
      if (error != std::errc()) refuse_format();
      rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
      if (rest.starts_with(' ')) rest.remove_prefix(1);
    }
    if (!rest.empty()) refuse_format();
    return numbers;
  }

  const InputFile& file_;
  std::uint64_t at_ = 0;
  std::uint64_t covered_ = 0;  // of the output
  std::uint64_t written_ = 0;  // of the original, so far
  Part part_;
};

// The part that was written with this program, if any; all parts are looked through.
std::optional<Part> part_of(const InputFile& rewritten, const InputFile& undo) {
  std::optional<Part> found;
  std::optional<std::uint64_t> hash;
  for (std::uint64_t at = 0; at == 0 || at < undo.size();) {
    UndoReader reader(undo, at);
    while (reader.next()) {
    }
    const Part& part = reader.part();
    at = part.end;
    if (found || part.output_size != rewritten.size()) continue;
    if (!hash) hash = hash_of(rewritten);
    if (part.output_hash == *hash) found = part;
  }
  return found;
}

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

bool copy_undo(const InputFile& rewritten, const InputFile& undo, OutputFile& into) {
  const std::optional<Part> part = part_of(rewritten, undo);
  if (!part) return false;
  return for_bytes(undo, part->begin, part->end, [&](std::string_view bytes) { into.write(bytes); });
}

void restore(const InputFile& rewritten, const InputFile& undo, OutputFile& out) {
  const auto refuse_mismatch = [&] {
    refuse_undo(undo, "undo-mismatch", fmt::format("does not fit {}", rewritten.name()));
  };
  const std::optional<Part> part = part_of(rewritten, undo);
  if (!part) refuse_mismatch();
  std::uint64_t at = 0;
  std::uint64_t hash = fnv1a({});
  const auto emit = [&](std::string_view bytes) {
    hash = fnv1a(bytes, hash);
    out.write(bytes);
  };
  const auto copy = [&](const InputFile& file, std::uint64_t from, std::uint64_t to) {
    if (!for_bytes(file, from, to, emit)) refuse_mismatch();
  };
  UndoReader reader(undo, part->begin);
  while (const std::optional<Replaced> span = reader.next()) {
    copy(rewritten, at, span->offset);
    copy(undo, span->at, span->at + span->original_size);
    at = span->offset + span->size;
  }
  copy(rewritten, at, rewritten.size());
  if (out.size() != part->original_size || hash != part->original_hash) refuse_mismatch();
}

}  // namespace plumbline::nc
