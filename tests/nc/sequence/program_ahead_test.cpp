// A program that is read ahead on another thread gives the steps that it gives when it is read block by block.
#include "nc/sequence/program_ahead.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <stdexcept>
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

TEST_CASE("steps that are read ahead can be looked at before they are taken") {
  struct Looks : StepsAhead {
    void look(const KeptSteps& steps, std::size_t place) override {
      std::vector<std::string>& seen = places[place];
      seen.clear();
      for (std::size_t i = 0; i < steps.size(); ++i) seen.push_back(text_of(steps[i].step));
    }
    std::array<std::vector<std::string>, kPlaces> places;
  };
  std::string text = "G21 G90 G94 G0 X0 Y0 Z0 F100\n";
  for (int i = 0; i < 3000; ++i) text += fmt::format("G1 X{}\n", i);
  const ProgramFile program(text);
  const InputFile file(program.path());
  for (const unsigned processors : {1U, 2U}) {
    INFO(processors << " processors");
    const HeldProcessors held(processors);
    Looks looks;
    ProgramAhead ahead(file, dialect("linuxcnc"), at_zero(), &looks);
    std::uint64_t handed_over = 0;
    std::size_t at = 0;
    std::size_t seen = 0;
    while (const Step* const step = ahead.next()) {
      at = ahead.handed_over() == handed_over ? at + 1 : 0;
      handed_over = ahead.handed_over();
      const std::vector<std::string>& here = looks.places[ahead.place()];
      REQUIRE(at < here.size());
      CHECK(text_of(*step) == here[at]);
      ++seen;
    }
    CHECK(seen == 3001);
    CHECK(handed_over > StepsAhead::kPlaces);
  }
}

TEST_CASE("what goes wrong while steps are looked at comes after the steps before them") {
  struct Fails : StepsAhead {
    void look(const KeptSteps&, std::size_t) override { throw std::runtime_error("no room"); }
  };
  const ProgramFile program("G21 G90 G94 G0 X0\nG0 X1\n");
  const InputFile file(program.path());
  Fails fails;
  for (const unsigned processors : {1U, 2U}) {
    INFO(processors << " processors");
    const HeldProcessors held(processors);
    ProgramAhead ahead(file, dialect("linuxcnc"), at_zero(), &fails);
    CHECK(ahead.next() != nullptr);
    CHECK(ahead.next() != nullptr);
    CHECK_THROWS_WITH(ahead.next(), "no room");
  }
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
