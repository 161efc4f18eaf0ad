#include "nc/sequence/label_index.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "base/text/characters.hpp"
#include "nc/language/codes.hpp"
#include "nc/sequence/flow_block.hpp"
#include "nc/sequence/subprogram_file.hpp"
#include "nc/syntax/line_head.hpp"

namespace plumbline::nc {
namespace {

// What stands after the second % of a tape never reaches the control; %_N_ of a SINUMERIK begins another program.
bool ends_tape(std::string_view line, bool begun, const Dialect& dialect) {
  const std::size_t first = line.find_first_not_of(" \t");
  const bool percent = first != std::string_view::npos && line[first] == '%';
  return percent && begun && !dialect.syntax.archive_heads;
}

// What the lines of a tape begin with.
template <class Take>
void for_each_head(const InputFile& file, const Dialect& dialect, const Take& take, bool behind_end = false) {
  LineSource lines(file, dialect.syntax.goes_on);
  bool begun = false;
  bool ended = false;
  for (Line line; lines.next(line);) {
    ended = ended || ends_tape(line.text, begun, dialect);
    if (ended && !behind_end) return;
    const LineHead head = head_of(line.text, dialect);
    begun = begun || !head.empty;
    if (ended == behind_end) take(head, line);
  }
}

// The names that begin with N: those of labels, as a jump has them, among others.
void add_labels(std::string_view text, std::set<std::string>& labels) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = at;
    while (at < text.size() && is_of_name(text[at])) ++at;
    if (at > begin && upper(text[begin]) == 'N') labels.insert(canonical_label(text.substr(begin, at - begin)));
    if (at == begin) ++at;
  }
}

}  // namespace

LabelIndex::Index& LabelIndex::programs_of(std::size_t file) {
  const auto [at, is_new] = indices_.try_emplace(file);
  Index& index = at->second;
  if (!is_new) return index;
  for_each_head(files_.file(file), dialect_, [&](const LineHead& head, const Line& line) {
    ProgramHeads& programs = index.programs;
    if (!head.program.empty()) {
      programs.heads.push_back({head.program, line.place, head.is_main});
    } else if (!head.empty && programs.heads.empty() && !programs.words_before) {
      programs.words_before = line.place;
    }
  });
  return index;
}

const LabelIndex::Index& LabelIndex::labels_of(std::size_t file) {
  Index& index = programs_of(file);
  if (std::exchange(index.has_labels, true)) return index;
  for_each_head(files_.file(file), dialect_, [&](const LineHead& head, const Line& line) {
    if (!head.number.empty()) index.labels[head.number].push_back(line.place);
    if (!head.label.empty()) index.labels[head.label].push_back(line.place);
    const bool is_label = !head.number.empty() || !head.label.empty();
    if (head.zeros > 0 && dialect_.syntax.labels != Labels::numbers) index.zeros.emplace(line.place.line, head.zeros);
    if (is_label && head.behind_slash) index.behind_slash.insert(line.place.line);
    if (!dialect_.syntax.numbered_loops || head.word == FlowWord::none) return;
    index.loops.push_back({line.place.line, head.loop, head.word != FlowWord::end_while});
  });
  return index;
}

std::optional<std::size_t> LabelIndex::crossing(std::size_t line) {
  const Index& index = labels_of(files_.current());
  auto at = std::lower_bound(index.loops.begin(), index.loops.end(), line,
                             [](const LoopLine& loop, std::size_t wanted) { return loop.line < wanted; });
  std::vector<int> open;
  for (; at != index.loops.end(); ++at) {
    if (at->begins) {
      if (std::find(open.begin(), open.end(), at->number) != open.end()) return at->line;
      open.push_back(at->number);
      continue;
    }
    if (!open.empty() && open.back() != at->number) return at->line;
    if (!open.empty()) open.pop_back();
    if (open.empty()) break;
  }
  return std::nullopt;
}

const Nesting& LabelIndex::nesting(bool left_out) {
  const auto [at, is_new] = nestings_.try_emplace(files_.current());
  Nesting& nesting = at->second;
  if (!is_new) return nesting;
  for_each_head(files_.file(files_.current()), dialect_,
                [&](const LineHead& head, const Line& line) { nesting.add(head, line.place, left_out); });
  nesting.close();
  return nesting;
}

// Of the lines of the program around a line: its first, and the first behind it.
LabelIndex::LineRange LabelIndex::program_around(const Index& index, std::size_t line) {
  LineRange range;
  for (const ProgramHead& head : index.programs.heads) {
    if (head.place.line > line) {
      range.end = head.place.line;
      break;
    }
    range.first = head.place.line;
  }
  return range;
}

const LinePlace* LabelIndex::find_label(const std::string& label, std::size_t line, Direction direction) {
  const Index& index = labels_of(files_.current());
  const auto found = index.labels.find(label);
  if (found == index.labels.end()) return nullptr;
  const LineRange range = program_around(index, line);
  const LinePlace* before = nullptr;
  const LinePlace* nearest = nullptr;
  const LinePlace* after = nullptr;
  for (const LinePlace& place : found->second) {
    if (!range.contains(place.line)) continue;
    if (place.line <= line) {
      if (before == nullptr) before = &place;
      nearest = &place;
    } else if (after == nullptr) {
      after = &place;
    }
  }
  if (direction == Direction::forward) return after;
  if (direction == Direction::backward) return nearest;
  return after != nullptr ? after : before;
}

namespace {

// GOTO looks behind its line first, then before it: from which end was found in no source.
void check_before(const Block& block, const std::string& label, std::size_t line,
                  const std::vector<std::size_t>& lines) {
  if (lines.size() < 2 || lines.back() > line) return;
  refuse_flow(block, codes::kNotInterpreted,
              fmt::format("{} stands in the lines {} and {}, and which of them GOTO finds first was found in no source",
                          label, lines.front(), lines.back()),
              "write GOTOB, which goes to the nearest, or give each label a name of its own");
}

}  // namespace

// Labels that differ by zeros before their numbers count as one here.
void LabelIndex::check_once(const Block& block, const std::string& label, std::size_t line, Direction direction) {
  const bool has_directions = dialect_.syntax.statements == Statements::high_level;
  if (has_directions && direction != Direction::both) return;
  const Index& index = labels_of(files_.current());
  const auto found = index.labels.find(label);
  if (found == index.labels.end()) return;
  const LineRange range = program_around(index, line);
  std::vector<std::size_t> lines;
  for (const LinePlace& place : found->second) {
    if (range.contains(place.line)) lines.push_back(place.line);
  }
  if (has_directions) return check_before(block, label, line, lines);
  if (lines.size() < 2) return;
  refuse_flow(block, codes::kNotInterpreted,
              dialect_.syntax.statements == Statements::user_task
                  ? fmt::format("{} stands in line {} as well, and which of the two the control goes to, or whether "
                                "zeros before its number make it another label, was found in no source",
                                label, lines[1])
                  : fmt::format("{} stands in line {} as well, and which of the two the control goes to depends on "
                                "its parameters",
                                label, lines[1]),
              "give each label a name of its own");
}

std::size_t LabelIndex::zeros_at(std::size_t line) {
  const Index& index = labels_of(files_.current());
  const auto found = index.zeros.find(line);
  return found == index.zeros.end() ? 0 : found->second;
}

bool LabelIndex::is_behind_slash(std::size_t line) { return labels_of(files_.current()).behind_slash.contains(line); }

std::optional<FilePlace> LabelIndex::find_in_open_files(const std::string& name) {
  for (std::size_t file = 0; file < files_.size(); ++file) {
    for (const ProgramHead& head : programs_of(file).programs.heads) {
      if (head.name == name) return FilePlace{file, head.place};
    }
  }
  return std::nullopt;
}

std::optional<FilePlace> LabelIndex::find_program(const std::string& name) {
  if (const std::optional<FilePlace> found = find_in_open_files(name)) return found;
  const std::optional<std::size_t> file = files_.open_beside(name);
  if (!file) return std::nullopt;
  ProgramHeads& programs = programs_of(*file).programs;
  if (programs.heads.empty()) {
    programs.heads.push_back({name, {}, false});  // a file that names none holds the one of its name
  } else if (programs.words_before) {
    refuse(codes::kFlowOpen, "this stands before the first program of the file, and belongs to none",
           "put it behind the line that names the program, or take it out", shown(*file, *programs.words_before));
  }
  return find_in_open_files(name);
}

bool LabelIndex::begins_in(std::size_t file, const std::string& name) {
  const std::vector<ProgramHead>& heads = programs_of(file).programs.heads;
  return std::any_of(heads.begin(), heads.end(), [&](const ProgramHead& head) { return head.name == name; });
}

std::optional<LabelIndex::SameName> LabelIndex::find_same_name(const std::string& name, const FilePlace& found) {
  const auto same = [&](const std::string& which, std::size_t one, std::size_t other) {
    return SameName{which, files_.file(one).name(), files_.file(other).name()};
  };
  const bool is_new = called_.emplace(name, found.file).second;
  if (is_new) {
    const std::optional<std::size_t> beside = files_.beside(name);
    if (beside && *beside != found.file && (begins_in(*beside, name) || programs_of(*beside).programs.heads.empty()))
      return same(name, found.file, *beside);
    for (std::size_t file = 0; file < files_.size(); ++file) {
      if (file != found.file && begins_in(file, name)) return same(name, found.file, file);
    }
  }
  for (; files_looked_through_ < files_.size(); ++files_looked_through_) {
    for (const auto& [before, file] : called_) {
      if (file != files_looked_through_ && begins_in(files_looked_through_, before))
        return same(before, file, files_looked_through_);
    }
  }
  return std::nullopt;
}

std::string LabelIndex::name_with_other_zeros(const std::string& name) {
  if (dialect_.syntax.statements != Statements::user_task) return {};
  const std::string wanted = canonical_program(name);
  for (std::size_t file = 0; file < files_.size(); ++file) {
    for (const ProgramHead& head : programs_of(file).programs.heads) {
      if (head.name != name && canonical_program(head.name) == wanted) return head.name;
    }
  }
  return subprogram_file_with_other_zeros(files_.file(0).name(), name, dialect_);
}

std::optional<LinePlace> LabelIndex::behind_end(const std::string& name) {
  std::optional<LinePlace> found;
  for_each_head(
      files_.file(0), dialect_,
      [&](const LineHead& head, const Line& line) {
        if (!found && head.program == name) found = line.place;
      },
      true);
  return found;
}

bool LabelIndex::is_twice(const std::string& name) {
  for (std::size_t file = 0; file < files_.size(); ++file) {
    const std::vector<ProgramHead>& heads = programs_of(file).programs.heads;
    if (std::count_if(heads.begin(), heads.end(), [&](const ProgramHead& head) { return head.name == name; }) > 1) {
      return true;
    }
  }
  return false;
}

Place LabelIndex::shown(std::size_t file, const LinePlace& place) const {
  LineSource lines(files_.file(file), dialect_.syntax.goes_on);
  lines.seek(place);
  Line line;
  lines.next(line);
  return {files_.file(file).name(), place.line, 1, std::max<std::size_t>(line.text.size(), 1), std::string(line.text)};
}

// A line behind M2 that nothing leads to: no jump names its label, and no program of its own begins before it.
std::optional<LinePlace> LabelIndex::unreached(bool left_out) const {
  if (!unreached_but_by({}, left_out)) return std::nullopt;  // of most programs nothing stands there, whatever jumps
  Targets targets;
  std::size_t program = 0;
  for_each_head(files_.file(0), dialect_, [&](const LineHead& head, const Line& line) {
    if (!head.program.empty()) ++program;
    if (head.word == FlowWord::begin_if || head.word == FlowWord::go_to) add_labels(line.text, targets[program]);
  });
  return unreached_but_by(targets, left_out);
}

std::optional<LinePlace> LabelIndex::unreached_but_by(const Targets& targets, bool left_out) const {
  std::optional<LinePlace> found;
  bool ended = false;
  std::size_t program = 0;
  std::size_t first = 1;  // 0: text stands before the first name of a program
  for_each_head(files_.file(0), dialect_, [&](const LineHead& head, const Line& line) {
    const bool is_head = !line.text.empty() && line.text.front() == dialect_.syntax.goes_on;  // $NAME.MIN%
    if (!head.program.empty()) ++program;
    if (program == 0 && !is_head && !head.empty) first = 0;
    const auto of_program = targets.find(program);
    const bool is_target = of_program != targets.end() && of_program->second.contains(head.number);
    if (!head.program.empty() || is_target) ended = false;
    if (ended && !found && (is_head || !head.empty)) found = line.place;
    const bool returns = head.word == FlowWord::give_back && program <= first;  // to who calls the first program
    if (!(head.behind_slash && left_out) && (returns || holds_program_end(line.text))) ended = true;
  });
  return found;
}

std::optional<LinePlace> LabelIndex::other_main(const std::set<std::size_t>& begun) {
  const std::vector<ProgramHead>& heads = programs_of(0).programs.heads;
  const auto was_begun = [&](const ProgramHead& head) { return begun.contains(head.place.line); };
  if (std::all_of(heads.begin(), heads.end(), was_begun)) return std::nullopt;
  std::optional<LinePlace> other;
  std::optional<LinePlace> found;
  for_each_head(files_.file(0), dialect_, [&](const LineHead& head, const Line& line) {
    if (!head.program.empty()) {
      other = begun.contains(line.place.line) ? std::nullopt : std::optional(line.place);
    }
    if (other && !found && holds_program_end(line.text)) found = other;
  });
  return found;
}

}  // namespace plumbline::nc
