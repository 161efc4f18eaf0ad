#include "nc/sequence/flow.hpp"

#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "nc/control/expression.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"
#include "nc/sequence/subprogram_file.hpp"

namespace plumbline::nc {
namespace {

constexpr std::size_t kCallLevels = 9;  // [LinuxCNC, measured]

[[noreturn]] void refuse_flow(const Block& block, std::string_view code, std::string message, std::string help) {
  Span span = block.flow.span;
  if (block.flow.word == FlowWord::none && !block.words.empty()) span = block.words.front().span;
  refuse_at(block, span, code, std::move(message), std::move(help));
}

}  // namespace

FlowControl::FlowControl(const InputFile& program, const Dialect& dialect, Interpreter& interpreter)
    : dialect_(dialect), interpreter_(interpreter) {
  files_.push_back(std::make_unique<File>(File{nullptr, &program, LineSource(program)}));
}

bool FlowControl::next(Line& line) {
  if (files_[file_]->lines.next(line)) return true;
  end_of_text();
  if (!called()) return false;
  Place place;
  place.file = file();
  refuse(codes::kFlowOpen, fmt::format("the file ends inside subprogram {}", calls_.back().name),
         "end it with O<name> ENDSUB, or with M99 if M98 calls it", std::move(place));
}

void FlowControl::end_of_text() {
  if (!skipping()) return;
  refuse(codes::kFlowOpen, fmt::format("the file ends before {} was found", skip_what_),
         "add it, or put the subprogram into a file of its name beside the program; the control reads nothing behind "
         "the % that ends a program, and no % around a file that a program with % calls",
         skip_from_);
}

std::string FlowControl::label_of(const Block& block) {
  const Flow& flow = block.flow;
  if (flow.label == kLiteral) return std::string(interpreter_.control().parameters.plain(block.at(flow.name)));
  return std::to_string(
      whole_number(block, flow.span, interpreter_.value_of(block, flow.label, flow.span), "the label of an O word"));
}

// The label of a line that is left out may depend on what only the subprogram around it sets: it is no other one's
// then.
std::string FlowControl::label_of_skipped(const Block& block) {
  try {
    return label_of(block);
  } catch (const Refusal& refusal) {
    if (refusal.diagnostic().code != codes::kParameterUnset) throw;
    return {};
  }
}

// Loops and branches of a subprogram have labels of their own.
std::string FlowControl::scoped(const std::string& label) const {
  return calls_.empty() ? label + '#' : calls_.back().name + '#' + label;
}

bool FlowControl::take(const Block& block) {
  const FlowWord word = block.flow.word;
  const bool ends = word == FlowWord::end_sub && !skipping() && called();  // of any label [LinuxCNC, measured]
  std::string label = ends ? calls_.back().name : skipping() ? label_of_skipped(block) : label_of(block);
  const bool is_subprogram = word == FlowWord::program || word == FlowWord::sub || word == FlowWord::end_sub ||
                             word == FlowWord::call || word == FlowWord::give_back;
  if (!is_subprogram) label = scoped(label);
  if (skipping() && label != skip_) return false;
  if (seeks_subprogram_ && word != FlowWord::sub && word != FlowWord::program) return false;
  if (!defining_.empty() && word != FlowWord::end_sub) return false;
  switch (word) {
    case FlowWord::program:
    case FlowWord::sub:
      return define(block, label);
    case FlowWord::end_sub:
    case FlowWord::give_back:
      give_back(block);
      return true;
    case FlowWord::call:
      enter(block, {label, file_, files_[file_]->lines.place()});
      return true;
    default:
      used_ = true;
      steer(block, label);
      return true;
  }
}

// Met on the way: a definition, passed over; looked for: the begin of the call.
bool FlowControl::define(const Block& block, const std::string& label) {
  const bool by_number = block.flow.word == FlowWord::program;
  if (called() && (seeks_subprogram_ || by_number) && by_number != calls_.back().by_number) {
    refuse_flow(block, codes::kFlowLabel,
                by_number ? "this program begins with O and a number, and O CALL calls it"
                          : "this subprogram begins with SUB, and M98 calls it",
                "M98 calls programs that begin with O100 and end with M99, O100 CALL those between SUB and ENDSUB");
  }
  if (by_number && !seeks_subprogram_) return true;
  used_ = true;
  if (seeks_subprogram_ || !called()) {
    const Target here{block.flow.word, file_, place_of_line(block)};
    if (!targets_.try_emplace(label, here).second) {
      refuse_flow(block, codes::kFlowLabel, "this subprogram was called or defined before",
                  "define it once, before the first move or behind the end of the program (M2)");
    }
  }
  skip_.clear();
  if (!std::exchange(seeks_subprogram_, false) && !called()) {
    skip_to(block, label, "the ENDSUB of this subprogram");
    defining_ = label;
  }
  return true;
}

void FlowControl::enter(const Block& block, Call call) {
  used_ = true;
  if (calls_.size() >= kCallLevels) {
    refuse_flow(block, codes::kCallDepth, fmt::format("subprograms call each other more than {} deep", kCallLevels),
                "the control takes no more; does a subprogram call itself without an end?");
  }
  std::vector<double> arguments;
  for (const std::uint32_t code : block.flow.values) {
    arguments.push_back(interpreter_.value_of(block, code, block.flow.span));
  }
  if (arguments.size() > static_cast<std::size_t>(kLocalParameters)) {
    refuse_flow(block, codes::kFlowControl, "a call takes 30 arguments at most", "set global parameters instead");
  }
  skip_.clear();
  interpreter_.enter_subprogram(!call.by_number, arguments);
  call.line = block.line;
  calls_.push_back(std::move(call));
  go_to_subprogram(block, calls_.back().name);
  note_call();
}

void FlowControl::note_call() {
  const Call& call = calls_.back();
  entry_ = {FlowEntry::Kind::call, call.name, {}, call.line, call.pass};
  if (file_ != 0) entry_.file = file();
}

void FlowControl::go_to_subprogram(const Block& block, const std::string& name) {
  if (const auto at = targets_.find(name); at != targets_.end()) return go_to(at->second);
  const std::filesystem::path path = subprogram_file(files_.front()->file->name(), name, dialect_);
  skip_to(block, name, fmt::format("subprogram {}", name));
  seeks_subprogram_ = true;
  if (path.empty()) return;
  auto opened = std::make_unique<InputFile>(path.string());
  const InputFile& file = *opened;
  files_.push_back(std::make_unique<File>(File{std::move(opened), &file, LineSource(file)}));
  file_ = files_.size() - 1;
}

void FlowControl::call_program(const Block& block, const ProgramCall& call) {
  enter(block, {std::to_string(call.number), file_, files_[file_]->lines.place(), true, call.count - 1});
  if (call.count == 0) {
    seeks_subprogram_ = false;  // L0: the control stays here, and the next M99 returns to here [LinuxCNC, measured]
    skip_.clear();
    file_ = calls_.back().file;
    files_[file_]->lines.seek(calls_.back().place);
  }
}

bool FlowControl::end_program(const Block& block, const ProgramCall& /*call*/) {
  if (!called()) return false;
  if (!calls_.back().by_number) {
    refuse_flow(block, codes::kFlowLabel, "M99 inside a subprogram that began with SUB", "end it with ENDSUB");
  }
  if (calls_.back().remaining > 0) {
    --calls_.back().remaining;
    ++calls_.back().pass;
    go_to(targets_.at(calls_.back().name));
    note_call();
  } else {
    leave(block);
  }
  return true;
}

// ENDSUB and RETURN, with a value or without; either may bear any label [LinuxCNC, measured].
void FlowControl::give_back(const Block& block) {
  if (!defining_.empty()) {
    defining_.clear();
    skip_.clear();
    return;
  }
  if (!called() || calls_.back().by_number) {
    refuse_flow(block, codes::kFlowLabel, "no subprogram is being executed that this could end",
                "a subprogram that M98 calls ends with M99");
  }
  interpreter_.control().parameters.set("_value_returned", {block.flow.values.empty() ? 0.0 : 1.0, true});
  if (!block.flow.values.empty()) {
    const double value = interpreter_.value_of(block, block.flow.values.front(), block.flow.span);
    interpreter_.control().parameters.set("_value", {value, true});
  }
  leave(block);
}

void FlowControl::leave(const Block& block) {
  skip_.clear();
  interpreter_.leave_subprogram(block);
  file_ = calls_.back().file;
  files_[file_]->lines.seek(calls_.back().place);
  calls_.pop_back();
}

void FlowControl::go_to(const Target& target) {
  file_ = target.file;
  files_[file_]->lines.seek(target.place);
}

void FlowControl::skip_to(const Block& block, std::string label, std::string_view what) {
  skip_ = std::move(label);
  skip_what_ = what;
  skip_from_ = {};
  skip_from_.file = block.file;
  skip_from_.line = block.line;
  skip_from_.column = std::size_t{block.flow.span.begin} + 1;
  skip_from_.length = block.flow.span.end - block.flow.span.begin;
  skip_from_.text = block.text;
  if (block.flow.word != FlowWord::none || block.words.empty()) return;
  skip_from_.column = std::size_t{block.words.front().span.begin} + 1;
  skip_from_.length = block.words.front().span.end - block.words.front().span.begin;
}

bool FlowControl::condition(const Block& block) {
  return interpreter_.value_of(block, block.flow.values.front(), block.flow.span) != 0;
}

}  // namespace plumbline::nc
