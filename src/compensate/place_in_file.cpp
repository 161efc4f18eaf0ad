#include "compensate/place_in_file.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "nc/language/refusal.hpp"

namespace plumbline::compensate {
namespace {

// The span that is underlined in the text of the block; nothing: it is that of another text.
std::optional<nc::Span> underlined(const Place& place, const nc::Block& block) {
  if (place.text != block.text || place.column == 0) return std::nullopt;
  const auto begin = static_cast<std::uint32_t>(place.column - 1);
  return nc::Span{begin, begin + static_cast<std::uint32_t>(place.length)};
}

// The word of the file that stands where the written one stands among those of its letter.
const nc::Word* same_word(nc::Span span, const nc::Block& written, const nc::Block& of_file) {
  const auto is_it = [&](const nc::Word& word) { return word.span.begin == span.begin && word.span.end == span.end; };
  const auto word = std::find_if(written.words.begin(), written.words.end(), is_it);
  if (word == written.words.end()) return nullptr;
  const auto has_letter = [&](const nc::Word& other) { return other.letter == word->letter; };
  const auto before = std::count_if(written.words.begin(), word, has_letter);
  auto found = std::find_if(of_file.words.begin(), of_file.words.end(), has_letter);
  for (std::ptrdiff_t i = 0; i < before && found != of_file.words.end(); ++i) {
    found = std::find_if(found + 1, of_file.words.end(), has_letter);
  }
  return found == of_file.words.end() ? nullptr : &*found;
}

nc::Span whole(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
  const std::size_t end = std::max(text.find_last_not_of(" \t\r\n") + 1, begin);
  return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

}  // namespace

void refuse_in_file(const Refusal& refusal, const nc::Block& written, const nc::Block& of_file) {
  const Diagnostic& said = refusal.diagnostic();
  const Place& place = said.place;
  if (place.file != of_file.file || place.line != of_file.line ||
      of_file.text.find(place.text) != std::string_view::npos)
    throw refusal;
  const std::optional<nc::Span> span = underlined(place, written);
  const nc::Word* const word = span ? same_word(*span, written, of_file) : nullptr;
  nc::refuse_at(of_file, word != nullptr ? word->span : whole(of_file.text), said.code, said.message, said.help);
}

}  // namespace plumbline::compensate
