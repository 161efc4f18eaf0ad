#include "cli/options/number_list.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "cli/command.hpp"

namespace plumbline::cli {

std::vector<double> numbers_between_commas(std::string_view text, const std::string& what) {
  std::vector<double> numbers;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string_view word = text.substr(at, end - at);
    const std::optional<double> number = parse_number(word);
    if (!number) throw UsageError(fmt::format("{}: \"{}\" is no number", what, word));
    numbers.push_back(*number);
    at = end + 1;
  }
  return numbers;
}

}  // namespace plumbline::cli
