#include "cli/options/test_dialect.hpp"

#include <vector>

#include "nc/language/dialect.hpp"

namespace plumbline::cli {

void add_test_dialect(CLI::App& command, std::string& dialect) {
  std::vector<std::string> names;
  std::string list;
  for (const std::string_view name : nc::dialect_names()) {
    names.emplace_back(name);
    list += (list.empty() ? "" : "|") + names.back();
  }
  command.add_option("--dialect", dialect, "the language of the NC programs of circular tests")
      ->type_name(list)
      ->check(CLI::IsMember(names).description(""))
      ->capture_default_str();
}

}  // namespace plumbline::cli
