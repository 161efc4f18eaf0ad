#include "base/text/encoding.hpp"

#include <fmt/format.h>

#include "base/diagnostic.hpp"

namespace plumbline {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kUnpack = "unpack it, and name the file that is in it";
constexpr std::string_view kSaveAs = "save it as plain text (ASCII or UTF-8)";

struct Signature {
  std::string_view begins;
  NotText kind;
};
constexpr Signature kSignatures[] = {
    {"\x1F\x8B"sv, {"packed with gzip", kUnpack}},
    {"PK\x03\x04"sv, {"a zip archive", kUnpack}},
    {"7z\xBC\xAF"sv, {"a 7-Zip archive", kUnpack}},
    {"\xFD"
     "7zXZ"sv,
     {"packed with xz", kUnpack}},
    {"BZh"sv, {"packed with bzip2", kUnpack}},
    {"\xFF\xFE"sv, {"text in UTF-16", kSaveAs}},
    {"\xFE\xFF"sv, {"text in UTF-16", kSaveAs}},
};

}  // namespace

std::optional<NotText> not_text(std::string_view begin) {
  for (const Signature& signature : kSignatures) {
    if (begin.starts_with(signature.begins)) return signature.kind;
  }
  return std::nullopt;
}

void refuse_not_text(std::string_view text, const std::string& file) {
  const std::optional<NotText> kind = not_text(text);
  if (kind)
    refuse("file-not-text", fmt::format("this is no text: it is {}", kind->is), std::string(kind->help), {file, 0});
}

}  // namespace plumbline
