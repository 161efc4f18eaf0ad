// A program that is read ahead on another thread gives the steps that it gives when it is read block by block.
#include "nc/sequence/program_ahead.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "base/files/files.hpp"
#include "base/parallel.hpp"
#include "nc/control/state/control.hpp"
#include "nc/language/recognise.hpp"
#include "nc/programs.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;
namespace fs = std::filesystem;

namespace {

void append(std::string& out, const AxisWords& words) {
  for (const Axis axis : kAllAxes) out += fmt::format(" {}", words[axis]);
}

void append(std::string& out, const Modal& modal) {
  out += fmt::format(" modal {} {} {} {} {} {} {} {} {}", static_cast<int>(modal.motion),
                     static_cast<int>(modal.feed_mode), modal.inches, modal.incremental, modal.work_system, modal.feed,
                     modal.feed_rotary, modal.tool_in_spindle, modal.switches.speed);
}

// Whatever a step points to, and some of what it holds.
std::string text_of(const Step& step) {
  const Block& block = *step.block;
  std::string out = fmt::format("{}:{}+{} <{}> <{}>", block.file, block.line, block.offset, block.text, block.line_end);
  for (const Word& word : block.words) out += fmt::format(" {}{}", word.letter, word.value);
  out += fmt::format(" {} {} {}", block.comments.size(), block.settings.size(), block.code.size());
  for (const Motion& motion : step.motions) {
    out += fmt::format(" move {} {} {}", static_cast<int>(motion.kind), motion.line, motion.feed);
    append(out, motion.from);
    append(out, motion.to);
    append(out, motion.machine);
  }
  for (const Hole& hole : step.holes) out += fmt::format(" hole {} {} {}", hole.code, hole.r, hole.bottom);
  if (step.call != nullptr) {
    out += " call " + step.call->row->name;
    for (const CallArgument& argument : step.call->arguments) out += "," + argument.text;
  }
  if (step.flow)
    out += fmt::format(" flow {} {} {} {}", step.flow->name, step.flow->file, step.flow->line, step.flow->pass);
  append(out, *step.before);
  append(out, *step.after);
  append(out, step.frame->origin);
  append(out, step.frame->g92);
  append(out, step.frame->tool);
  append(out, step.position);
  return out;
}

struct Told {
  std::vector<std::string> steps;
  std::optional<std::string> refusal;
};

template <class Source>
Told told_by(const InputFile& file, const Dialect& dialect) {
  Told told;
  try {
    ProgramSettings settings = at_zero();
    settings.max_blocks = 5000;
    Source program(file, dialect, settings);
    while (const Step* const step = program.next()) {
      told.steps.push_back(text_of(*step) + fmt::format(" {} {}", program.jumped(), program.position_read()));
    }
  } catch (const Refusal& refusal) {
    told.refusal = to_text(refusal.diagnostic());
  }
  return told;
}

void check_alike(const std::string& path) {
  INFO(path);
  const InputFile file(path);
  const Dialect* language = nullptr;
  try {
    language = recognise(file).dialect;
  } catch (const Refusal&) {
    return;  // of two dialects
  }
  const Told at_once = told_by<Program>(file, *language);
  const Told ahead = told_by<ProgramAhead>(file, *language);
  CHECK(ahead.refusal == at_once.refusal);
  REQUIRE(ahead.steps.size() == at_once.steps.size());
  const auto differs = std::mismatch(ahead.steps.begin(), ahead.steps.end(), at_once.steps.begin());
  if (differs.first != ahead.steps.end()) FAIL_CHECK(*differs.first << "\nand not\n" << *differs.second);
}

}  // namespace

TEST_CASE("read ahead, programs of all dialects give the same steps and refusals") {
  for (const char* const name : {"programs", "fanuc", "okuma", "siemens", "bad"}) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder(name))) {
      if (entry.is_regular_file() && entry.path().extension() != ".trace") check_alike(entry.path().string());
    }
  }
}

TEST_CASE("read ahead, a program of many blocks, of long lines and with a refusal at its end") {
  std::string text = "G21 G90 G94 G0 X0 Y0 Z0 F100\n";
  for (int i = 0; i < 3000; ++i) {
    text += fmt::format("G1 X{}.5 Y{} {}\n", i % 100, i % 7, i % 500 == 0 ? "(" + std::string(200, 'x') + ")" : "");
  }
  check_alike(ProgramFile(text + "M2\n").path());
  check_alike(ProgramFile(text + "G1 X[1/0]\nM2\n").path());
}

TEST_CASE("the steps that come next can be looked at before they are taken") {
  std::string text = "G21 G90 G94 G0 X0 Y0 Z0 F100\n";
  for (int i = 0; i < 1000; ++i) text += fmt::format("G1 X{}\n", i);
  const ProgramFile program(text);
  const InputFile file(program.path());
  ProgramAhead ahead(file, dialect("linuxcnc"), at_zero());
  if (processors() > 1) CHECK(ahead.ahead(0) == nullptr);
  std::vector<std::string> expected;
  std::size_t seen = 0;
  while (const Step* const step = ahead.next()) {
    if (!expected.empty()) {
      CHECK(text_of(*step) == expected.front());
      ++seen;
    }
    expected.clear();
    for (std::size_t i = 0; i < 3; ++i) {
      if (const Step* const later = ahead.ahead(i)) expected.push_back(text_of(*later));
    }
  }
  CHECK((processors() == 1 || seen > 900));
}

TEST_CASE("a program that is read ahead may be left at any step") {
  std::string text = "G21 G90 G94 G0 X0 Y0 Z0 F100\no1 while [1]\nG1 X1\nG1 X2\no1 endwhile\nM2\n";
  const ProgramFile program(text);
  const InputFile file(program.path());
  for (const int steps : {0, 1, 100, 1000}) {
    ProgramAhead ahead(file, dialect("linuxcnc"), at_zero());
    for (int i = 0; i < steps; ++i) REQUIRE(ahead.next() != nullptr);
    CHECK(ahead.jumped() == (steps >= 100));
  }
}
