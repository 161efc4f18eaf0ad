// The page that --report names.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "base/files/files.hpp"
#include "cli/command.hpp"
#include "report/page/page.hpp"

namespace plumbline::cli {

/// Adds the option --report FILE.html.
void add_report_option(CLI::App& command, std::string& path);

/// A page that appears with other files or not at all.
class ReportFile {
 public:
  /// Opens the file, so that one that cannot be written shows before the work; empty: no page is wanted.
  explicit ReportFile(const std::string& path);
  bool takes_standard_output() const { return file_ && file_->name() == kStandardStream; }
  /// `make` is called if a page is wanted.
  void add_to(OutputSet& set, const std::function<report::Page()>& make);

 private:
  std::optional<OutputFile> file_;
};

}  // namespace plumbline::cli
