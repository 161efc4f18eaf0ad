#include "cli/report_file.hpp"

namespace plumbline::cli {

void add_report_option(CLI::App& command, std::string& path) {
  command
      .add_option("--report", path, "write a page with pictures, too: one file that any browser opens, offline as well")
      ->type_name("FILE.html");
}

ReportFile::ReportFile(const std::string& path) {
  if (!path.empty()) file_.emplace(path);
}

void ReportFile::add_to(OutputSet& set, const std::function<report::Page()>& make) {
  if (!file_) return;
  report::write_page(make(), *file_);
  set.add(*file_);
}

}  // namespace plumbline::cli
