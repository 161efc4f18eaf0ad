#include "compensate/written_steps.hpp"

#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "compensate/opened.hpp"

using namespace plumbline;

namespace {

// The text of what stands for each block, "steer" for one that steers after it.
std::vector<std::string> written(const std::string& text, nc::Form form) {
  const Opened opened(text);
  compensate::MoveReader reader = reader_of(opened);
  compensate::WrittenSteps steps(opened.dialect, opened.job.emit, form);
  std::vector<std::string> texts;
  while (const nc::Step* const step = reader.next()) {
    const compensate::WrittenSteps::OfBlock of = steps.of(*step);
    for (const nc::Step* const part : of.steps) texts.emplace_back(part->block->text);
    if (of.steering) texts.emplace_back("steer");
  }
  return texts;
}

}  // namespace

TEST_CASE("in the order of the text each block stands for itself") {
  const std::vector<std::string> texts = written("G21 G90\n#1=5\nG0 X#1\nM2\n", nc::Form::in_text_order);
  CHECK(texts == std::vector<std::string>{"G21 G90", "#1=5", "G0 X#1", "M2"});
}

TEST_CASE("unrolled, values stand in place of parameters, and lines that set them or steer are left out") {
  const std::vector<std::string> texts =
      written("G21 G90\n#1=5 (five)\n#1=6\nG0 X#1\no1 if [#1 GT 2] (more)\nG0 X2\no1 endif\nM2\n", nc::Form::unrolled);
  REQUIRE(texts.size() == 8);
  CHECK(texts[0] == "G21 G90");
  CHECK(texts[1].find("five") != std::string::npos);
  CHECK(texts[1].find('#') == std::string::npos);
  CHECK(texts[2] == "G0 X6");
  CHECK(texts[3] == "(more)");
  CHECK(texts[4] == "steer");
  CHECK(texts[5] == "G0 X2");
  CHECK(texts[6] == "steer");
  CHECK(texts[7] == "M2");
}

TEST_CASE("a cycle is its moves, one by one") {
  const Opened opened("G21 G90 G94 G98 G61\nG0 X0 Y0 Z20 A0 B0 C0\nG81 X10 Y5 Z-12 R2 F100\nM2\n");
  compensate::MoveReader reader = reader_of(opened);
  compensate::WrittenSteps steps(opened.dialect, opened.job.emit, nc::Form::in_text_order);
  const nc::Step* step = reader.next();
  while (step->cycle == nc::CycleForm::none) step = reader.next();
  std::vector<nc::MotionKind> kinds;
  for (const nc::Step* const part : steps.of_cycle(*step)) {
    CHECK(part->cycle == nc::CycleForm::none);
    if (!part->motions.empty()) kinds.push_back(part->motions.front().kind);
  }
  using enum nc::MotionKind;
  CHECK(kinds == std::vector<nc::MotionKind>{rapid, rapid, feed, rapid});
}
