#include "report/depfile.hpp"

namespace plumbline::report {
namespace {

// As compilers write them for make: GCC's -MD. Backslashes double before what is escaped by one.
std::string escaped(const std::string& name) {
  std::string text;
  std::size_t backslashes = 0;
  for (const char c : name) {
    if (c == ' ' || c == '\t' || c == '#' || c == ':') {
      text.append(backslashes + 1, '\\');
    } else if (c == '$') {
      text += '$';
    }
    text += c;
    backslashes = c == '\\' ? backslashes + 1 : 0;
  }
  return text;
}

}  // namespace

std::string depfile_text(const std::string& target, const std::vector<std::string>& files) {
  std::string rule = escaped(target) + ":";
  std::string others;
  for (const std::string& file : files) {
    if (file.empty() || file.find_first_of("\r\n") != std::string::npos) continue;
    const std::string name = escaped(file);
    rule += " \\\n  " + name;
    others += name + ":\n";
  }
  return rule + "\n" + others;
}

}  // namespace plumbline::report
