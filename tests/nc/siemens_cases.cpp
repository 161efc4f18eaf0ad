#include "nc/siemens_cases.hpp"

#include <catch2/catch.hpp>

namespace plumbline::nc::tests {

std::string behind_definitions(const std::string& start, const std::string& rest) {
  std::size_t end = 0;
  while (rest.compare(end, 4, "DEF ") == 0) end = rest.find('\n', end) + 1;
  return rest.substr(0, end) + start + rest.substr(end);
}

void check_siemens(const std::string& start, std::string (*told)(const std::vector<Motion>& motions),
                   const std::string& expected, const std::vector<std::string>& rests) {
  ProgramSettings settings = empty_tables();
  settings.work_offsets[0] = WorkOffset{};
  for (const std::string& rest : rests) {
    INFO(rest);
    const ProgramFile program(behind_definitions(start, rest));
    if (const std::optional<Diagnostic> refused = refusal_of_file(program.path(), settings, "siemens")) {
      CHECK_FALSE(refused->help.empty());
      CHECK(refused->code == expected);
    } else {
      CHECK(told(motions_of_file(program.path(), settings, "siemens")) == expected);
    }
  }
}

}  // namespace plumbline::nc::tests
