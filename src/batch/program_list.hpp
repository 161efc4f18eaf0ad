// Which programs a batch is about, and where their outputs go.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"

namespace plumbline::batch {

struct ProgramRequest {
  std::string folder;                 // whose programs are meant; of a list: outputs keep their places in it
  std::string list;                   // a file of names, "-": standard input; empty: all programs of the folder
  std::string output;                 // folder
  std::vector<std::string> endings;   // in small letters, without the point; empty: the usual ones
  std::set<std::string> leave_out{};  // programs of the folder that are not looked at
};

struct ProgramList {
  std::vector<std::string> programs;     // in the order of their names, those of a list in its order
  std::vector<std::string> passed_over;  // files of the folder that are no programs
  std::vector<std::string> folders;      // that were looked into
  std::vector<Diagnostic> shut;          // of folders in it that cannot be
  bool holds_outputs = false;            // the folder of the outputs is one of those in it
};

/// The endings of programs where nobody names others: those by which the dialects know theirs, nc, tap, cnc and eia. A
/// name such as O1234 without an ending is a program, too.
const std::vector<std::string>& usual_endings();

/// True if a file is taken for a program by its name.
bool is_program_name(const std::string& path, const std::vector<std::string>& endings);

/// A folder is looked through with all below it, but for hidden ones and the folder of the outputs. A list has a name
/// on each line, or between zero bytes. Refuses with batch-folder where the folder itself cannot be looked into, and as
/// InputFile does.
ProgramList list_programs(const ProgramRequest& request);

/// Absolute, without "." and "..": links are not followed.
std::string whole_path(const std::string& path);

/// The place of a program in the folder, which is the place of its output: "a/part.nc". Refuses with batch-outside a
/// program that does not lie in it.
std::string place_in_folder(const std::string& folder, const std::string& program);

}  // namespace plumbline::batch
