#include "batch/program_list.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/files/files.hpp"
#include "base/files/path_of.hpp"
#include "base/text/characters.hpp"
#include "nc/language/dialect.hpp"

namespace plumbline::batch {
namespace {

namespace fs = std::filesystem;

std::string small(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = lower(c);
  return out;
}

std::vector<std::string> make_usual_endings() {
  std::vector<std::string> endings{"nc", "tap", "cnc", "eia"};
  for (const std::string_view name : nc::dialect_names()) {
    const nc::DialectMarks& marks = nc::marks_of_dialect(name);
    for (const std::string& ending : marks.file_endings) endings.push_back(small(ending));
    for (const std::string& ending : marks.weak_file_endings) endings.push_back(small(ending));
  }
  for (std::string& ending : endings) ending.erase(0, ending.find_first_not_of('.'));
  std::sort(endings.begin(), endings.end());
  endings.erase(std::unique(endings.begin(), endings.end()), endings.end());
  return endings;
}

Diagnostic shut_folder(const fs::path& folder, const std::error_code& error) {
  return {"batch-folder",
          fmt::format("cannot be looked into: {}", error.message()),
          "name a folder of programs that may be read",
          {folder.generic_string(), 0},
          Severity::error};
}

// As Fanuc controls call the files of their memory.
bool is_numbered(std::string_view name) {
  return name.size() > 1 && (name[0] == 'O' || name[0] == 'o') && std::all_of(name.begin() + 1, name.end(), is_digit);
}

class Walk {
 public:
  Walk(const ProgramRequest& request, ProgramList& list) : request_(request), list_(list) {
    std::error_code none;
    output_ = fs::weakly_canonical(path_of(request.output), none);
  }

  void look_into(const fs::path& folder) {
    list_.folders.push_back(folder.generic_string());
    std::vector<fs::path> folders;
    std::vector<std::string> found;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
      const std::string name = entry->path().filename().generic_string();
      std::error_code broken;  // a link that leads nowhere is neither
      if (entry->is_directory(broken)) {
        if (name[0] == '.') continue;
        if (is_output(entry->path())) {
          list_.holds_outputs = true;
          continue;
        }
        // A link to a folder may lead round in circles.
        if (entry->is_symlink(broken)) {
          list_.passed_over.push_back(entry->path().generic_string());
        } else {
          folders.push_back(entry->path());
        }
      } else if (entry->is_regular_file(broken)) {
        const std::string path = entry->path().generic_string();
        if (request_.leave_out.contains(path)) continue;
        (is_program_name(name, request_.endings) ? found : list_.passed_over).push_back(path);
      } else if (is_program_name(name, request_.endings)) {  // a link that leads nowhere, a pipe
        list_.passed_over.push_back(entry->path().generic_string());
      }
    }
    if (error) {
      list_.folders.pop_back();
      if (list_.folders.empty()) throw Refusal(shut_folder(folder, error));
      list_.shut.push_back(shut_folder(folder, error));
      return;
    }
    std::sort(found.begin(), found.end());
    list_.programs.insert(list_.programs.end(), found.begin(), found.end());
    std::sort(folders.begin(), folders.end());
    for (const fs::path& inner : folders) look_into(inner);
  }

 private:
  bool is_output(const fs::path& folder) const {
    std::error_code none;
    return fs::weakly_canonical(folder, none) == output_;
  }

  const ProgramRequest& request_;
  ProgramList& list_;
  fs::path output_;
};

std::vector<std::string> names_in(std::string_view text) {
  text.remove_prefix(byte_order_mark_size(text));
  const char end = text.find('\0') == std::string::npos ? '\n' : '\0';
  std::vector<std::string> names;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t stop = std::min(text.find(end, at), text.size());
    std::string name(text.substr(at, stop - at));
    if (end == '\n' && name.ends_with('\r')) name.pop_back();
    if (!name.empty()) names.push_back(std::move(name));
    at = stop + 1;
  }
  return names;
}

}  // namespace

const std::vector<std::string>& usual_endings() {
  static const std::vector<std::string> endings = make_usual_endings();
  return endings;
}

bool is_program_name(const std::string& path, const std::vector<std::string>& endings) {
  const fs::path file = path_of(path).filename();
  const std::string name = file.generic_string();
  if (name.empty() || name[0] == '.') return false;
  std::string ending = small(file.extension().generic_string());
  if (ending.empty()) return is_numbered(name);
  ending.erase(0, 1);
  const std::vector<std::string>& known = endings.empty() ? usual_endings() : endings;
  return std::find(known.begin(), known.end(), ending) != known.end();
}

ProgramList list_programs(const ProgramRequest& request) {
  ProgramList list;
  if (!request.list.empty()) {
    list.programs = names_in(read_text(request.list));
    return list;
  }
  Walk(request, list).look_into(path_of(request.folder));
  std::sort(list.passed_over.begin(), list.passed_over.end());
  return list;
}

std::string whole_path(const std::string& path) {
  return fs::absolute(path_of(path)).lexically_normal().generic_string();
}

std::string place_in_folder(const std::string& folder, const std::string& program) {
  fs::path root = path_of(whole_path(folder));
  if (!root.has_filename()) root = root.parent_path();
  const fs::path place = path_of(whole_path(program)).lexically_relative(root);
  if (place.empty() || *place.begin() == ".." || place == ".") {
    refuse("batch-outside", fmt::format("does not lie in {}", root.generic_string()),
           "name the folder that holds all programs of the list: outputs have the same places in the folder of -o",
           {program, 0});
  }
  return place.generic_string();
}

}  // namespace plumbline::batch
