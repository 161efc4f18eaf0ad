// Where the programs and labels of a program's files stand, looked up once, when something jumps for the first time.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/diagnostic.hpp"
#include "nc/language/block.hpp"
#include "nc/language/dialect.hpp"
#include "nc/sequence/nesting.hpp"
#include "nc/sequence/program_files.hpp"

namespace plumbline::nc {

/// Where a program begins that says its name.
struct ProgramHead {
  std::string name;
  LinePlace place;
  bool is_main = false;  // by its name: %_N_NAME_MPF
};

/// Those of a file.
struct ProgramHeads {
  std::vector<ProgramHead> heads;
  std::optional<LinePlace> words_before;  // the first line with words, if it stands before all of them
};

class LabelIndex {
 public:
  /// Both must outlive it.
  LabelIndex(ProgramFiles& files, const Dialect& dialect) : files_(files), dialect_(dialect) {}

  /// The label in the program around this line of the file that is read; null: there is none. Both directions: from the
  /// line to the end of the program, then from its begin; backward: the nearest before the line. Holds while the index
  /// does.
  const LinePlace* find_label(const std::string& label, std::size_t line, Direction direction);
  /// Refuses, at the block that jumps, a label that stands twice in the same program, but where the way it is looked
  /// for is part of the language: GOTOF, GOTOB, and GOTO where one of its name stands behind the line.
  void check_once(const Block& block, const std::string& label, std::size_t line, Direction direction);
  /// How many zeros stand before the number of that line of the file that is read, where labels are texts.
  std::size_t zeros_at(std::size_t line);
  /// True if that line of the file that is read begins with /.
  bool is_behind_slash(std::size_t line);
  /// The program of that name: in the files that are open, else in one of its name beside the program. Refuses such a
  /// file if words stand before the first program of it.
  std::optional<FilePlace> find_program(const std::string& name);
  /// A name that programs of two files have.
  struct SameName {
    std::string name;
    std::string one, other;  // the files
  };
  /// Of the program called, found there: another file that is open, or one of its name beside the program, in which it
  /// begins as well; or a program called before that begins in a file opened since. Nothing: there is none.
  std::optional<SameName> find_same_name(const std::string& name, const FilePlace& found);
  /// Under user task 2: a program that is named so but for the zeros before its number, in the files that are open or
  /// beside the program; empty: there is none.
  std::string name_with_other_zeros(const std::string& name);
  /// Where the program of that name begins behind what ends the program's own file for the control: a second %.
  std::optional<LinePlace> behind_end(const std::string& name);
  /// True if a file holds several programs of that name.
  bool is_twice(const std::string& name);
  /// The loops and branches of the file that is read. `left_out`, the same in each call: lines behind / are.
  const Nesting& nesting(bool left_out);
  /// The first line that loops by number, begun in this line of the file that is read, must not hold: DO with the
  /// number of a loop around it, or the END of one around them, so that they cross. Nothing: there is none.
  std::optional<std::size_t> crossing(std::size_t line);
  /// Of the program's own file.
  const ProgramHeads& own_programs() { return programs_of(0).programs; }
  /// Whether a program of that name begins in the file.
  bool begins_in(std::size_t file, const std::string& name);
  /// That line of a file, by its number, as a diagnostic shows it.
  Place shown(std::size_t file, const LinePlace& place) const;
  /// The first program of the program's own file that ends as a main program does, and begins in none of these lines.
  std::optional<LinePlace> other_main(const std::set<std::size_t>& begun);
  /// The first line of the program's own file that stands behind M2 or M30, or behind the RTS of the first program,
  /// where no label and no program begins.
  /// `left_out`: lines behind / are.
  std::optional<LinePlace> unreached(bool left_out) const;

 private:
  struct LoopLine {
    std::size_t line = 0;
    int number = 0;
    bool begins = false;
  };
  struct Index {
    ProgramHeads programs;
    std::unordered_map<std::string, std::vector<LinePlace>> labels;
    std::vector<LoopLine> loops;                         // in the order of the text
    std::set<std::size_t> behind_slash;                  // lines with a label or a number
    std::unordered_map<std::size_t, std::size_t> zeros;  // of lines with any before their number
    bool has_labels = false;
  };
  struct LineRange {
    std::size_t first = 0, end = std::string::npos;
    bool contains(std::size_t line) const { return line >= first && line < end; }
  };
  static LineRange program_around(const Index& index, std::size_t line);
  Index& programs_of(std::size_t file);
  const Index& labels_of(std::size_t file);
  std::optional<FilePlace> find_in_open_files(const std::string& name);
  /// Labels, by which of the programs of the file jumps to them.
  using Targets = std::map<std::size_t, std::set<std::string>>;
  /// See unreached(): jumps lead to these labels alone.
  std::optional<LinePlace> unreached_but_by(const Targets& targets, bool left_out) const;

  ProgramFiles& files_;
  const Dialect& dialect_;
  std::unordered_map<std::size_t, Index> indices_;  // by the number of the file
  std::unordered_map<std::size_t, Nesting> nestings_;
  std::map<std::string, std::size_t> called_;  // names of programs, and the files in which they were found
  std::size_t files_looked_through_ = 0;       // for those
};

}  // namespace plumbline::nc
