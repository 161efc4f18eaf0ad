#include "jobs/program/program_text.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/text/characters.hpp"
#include "base/text/encoding.hpp"
#include "nc/language/dialect.hpp"

namespace plumbline::jobs {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kLook = 4096;        // bytes at the begin
constexpr std::size_t kControlShare = 20;  // no text: more than one in so many is a control character

struct Signature {
  std::string_view begins, is, help;
};
constexpr std::string_view kPost = "post it for ";  // and the dialects
constexpr std::string_view kOther = "name the NC program: a text of G and M codes";
constexpr Signature kSignatures[] = {
    {"%PDF"sv, "a PDF", kOther},
    {"\x7F"
     "ELF"sv,
     "a program for computers", kOther},
    {"plumbline ="sv, "a machine model, a dataset or a table of plumbline", kOther},
    {"plumbline="sv, "a machine model, a dataset or a table of plumbline", kOther},
    {R"({")"sv, "JSON", kOther},
    {"{\n"sv, "JSON", kOther},
    {"solid "sv, "a body in STL", "name the program that a CAM system made for it"},
    {"ISO-10303-21"sv, "a body in STEP", "name the program that a CAM system made for it"},
    {"<"sv, "XML or a web page", kOther},
    {"0 BEGIN PGM"sv, "a program in Heidenhain's plain text", kPost},
    {"BEGIN PGM"sv, "a program in Heidenhain's plain text", kPost},
};

[[noreturn]] void refuse_as(std::string_view code, const InputFile& program, std::string message,
                            std::string_view help) {
  refuse(code, std::move(message), std::string(help), Place{.file = program.name()});
}

[[noreturn]] void refuse_kind(const InputFile& program, std::string_view is, std::string_view help) {
  refuse_as("file-not-text", program, fmt::format("this is no NC program: it is {}", is), help);
}

bool is_control(char c) { return static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\f' && !is_blank(c); }

}  // namespace

void refuse_unless_program_text(const InputFile& program) {
  std::string begin(kLook, '\0');
  begin.resize(program.read(0, begin.data(), begin.size()));
  if (const std::optional<NotText> kind = not_text(begin)) refuse_kind(program, kind->is, kind->help);
  for (const Signature& kind : kSignatures) {
    if (!begin.starts_with(kind.begins)) continue;
    const std::string dialects = kind.help == kPost ? nc::dialect_list() : std::string();
    refuse_kind(program, kind.is, fmt::format("{}{}", kind.help, dialects));
  }
  const auto controls = static_cast<std::size_t>(std::count_if(begin.begin(), begin.end(), is_control));
  if (controls * kControlShare > begin.size()) {
    refuse_kind(program, "no text", kOther);
  }
  const std::string_view text = std::string_view(begin).substr(byte_order_mark_size(begin));
  const bool blank = std::all_of(text.begin(), text.end(), [](char c) { return c == '\n' || is_blank(c); });
  if (blank && program.size() <= kLook) {
    refuse_as("file-empty", program, "the file is empty",
              "name the program; if it should not be empty, fetch it again from where it came");
  }
}

}  // namespace plumbline::jobs
