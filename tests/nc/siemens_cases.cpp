#include "nc/siemens_cases.hpp"

#include <catch2/catch.hpp>

namespace plumbline::nc::tests {

void check_siemens(const std::string& start, std::string (*told)(const std::vector<Motion>& motions),
                   const std::string& expected, const std::vector<std::string>& rests) {
  ProgramSettings settings = empty_tables();
  settings.work_offsets[0] = WorkOffset{};
  for (const std::string& rest : rests) {
    INFO(rest);
    const ProgramFile program(start + rest);
    if (const std::optional<Diagnostic> refused = refusal_of_file(program.path(), settings, "siemens")) {
      CHECK_FALSE(refused->help.empty());
      CHECK(refused->code == expected);
    } else {
      CHECK(told(motions_of_file(program.path(), settings, "siemens")) == expected);
    }
  }
}

}  // namespace plumbline::nc::tests
