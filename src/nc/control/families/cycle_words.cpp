// The words of a canned cycle, and what it inherits from the one before.
#include "nc/control/families/cycle_words.hpp"

#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "nc/control/families/cycle_codes.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

class CycleWords {
 public:
  CycleWords(Execution& run, bool goes_on)
      : run_(run),
        cycle_(run.control.cycle),
        code_(run.motion->value),
        goes_on_(goes_on),
        as_fanuc_(run.dialect.behaviour.fanuc_cycles) {}

  void take_unit();
  void take_words();

 private:
  void take_words_of_osp(bool is_new);
  void check_pecks_of_osp() const;
  void check_worked_out_dwell(const Word& word) const;
  void check_restated() const;
  double inherited(char letter, double before, double value, bool needed) const;

  Execution& run_;
  Cycle& cycle_;
  int code_;
  bool goes_on_;
  bool as_fanuc_;
};

double CycleWords::inherited(const char letter, double before, double value, bool needed) const {
  if (run_.words.has(letter)) return value;
  if (needed && !goes_on_) run_.need(letter, fmt::format("G{}", code_));
  return before;
}

// What a cycle inherits is kept as numbers: after G20 the R of 5 mm is one of 5 inches [LinuxCNC, measured].
void CycleWords::take_unit() {
  const double unit = run_.control.length_unit();
  const double ratio = unit / std::exchange(cycle_.unit_mm, unit);
  if (ratio == 1 || !(goes_on_ || cycle_.begun)) return;
  if (as_fanuc_) {
    run_.refuse(run_.motion_code(), codes::kNotInterpreted,
                "what the cycle inherits after a change of units depends on the control",
                "write G80 before the change (G20, G21), and the cycle anew");
  }
  for (double* value : {&cycle_.start, &cycle_.r, &cycle_.bottom, &cycle_.peck}) *value *= ratio;
  for (double& value : cycle_.ijk) value *= ratio;
}

void CycleWords::take_words() {
  const auto length = [&](char letter) {
    const Word* const word = run_.words.find(letter);
    return word == nullptr ? 0 : run_.length(*word);
  };
  const auto number = [&](char letter) {
    const Word* const word = run_.words.find(letter);
    return word == nullptr ? 0 : word->value;
  };
  const bool of_osp = run_.dialect.behaviour.return_levels;
  if (of_osp && goes_on_ && run_.motion_word != nullptr) check_restated();
  cycle_.r = inherited('R', cycle_.r, length('R'), true);
  const char normal = letter(axes_of(run_.control.modal.plane).third);
  cycle_.bottom = inherited(normal, cycle_.bottom, length(normal), true);
  const bool is_new = of_osp ? run_.motion_word != nullptr : as_fanuc_ && !goes_on_;
  if (is_new && !of_osp) cycle_.stays = false;
  if (is_new) cycle_.dwell_s = 0;  // G80 and G0 end what was kept [Haas 96-8000, p. 185]
  const bool dwells = code_ == kDrillDwell || code_ == kBoreStop || code_ == kBoreByHand || code_ == kBoreDwell;
  cycle_.dwell_s = inherited('P', cycle_.dwell_s, number('P'), dwells && !as_fanuc_);
  if (const Word* const word = run_.words.find('P'); word != nullptr && !(of_osp && word->point)) {
    cycle_.dwell_s *= run_.dialect.behaviour.dwell_p_s;
  }
  const bool pecks = code_ == kChipBreaking || code_ == kPeck;
  const char peck = of_osp && run_.words.has('I') ? 'I' : 'Q';
  cycle_.peck = inherited(peck, cycle_.peck, length(peck), pecks);
  for (std::size_t i = 0; i < 3; ++i) {
    cycle_.ijk[i] = inherited(kCentreLetters[i], cycle_.ijk[i], length(kCentreLetters[i]), code_ == kBackBore);
  }
  const bool waits = of_osp || !(pecks || code_ == kDrill || code_ == kBore || (as_fanuc_ && code_ == kBoreStop));
  if (const Word* const word = run_.words.find('P')) {
    // Posts for an OSP write seconds with a point or milliseconds, as the machine is set: it stays as it is written.
    if (!of_osp) check_milliseconds(run_, *word, waits);
    if (of_osp) check_worked_out_dwell(*word);
    cycle_.dwell_pointed = word->point;
  }
  // The manual has no P in these [U part 2, p. 53], a Haas waits at the bottom [H], and it keeps the P of a cycle
  // before: the hole stays a cycle.
  cycle_.stays = cycle_.stays || (as_fanuc_ && !of_osp && !waits && cycle_.dwell_s != 0);
  if (of_osp) take_words_of_osp(is_new);
  if (cycle_.dwell_s < 0) {
    run_.refuse(*run_.words.find('P'), codes::kNegative, "the time to wait is negative", "write P0 or more");
  }
  if (pecks && cycle_.peck <= 0) {
    const Word* const word = run_.words.find(peck);
    if (word != nullptr && cycle_.peck < 0) {
      run_.refuse(*word, codes::kNotInterpreted,
                  of_osp ? "what a peck below 0 is taken for was found in no source"
                         : "the manual says that a depth below 0 is ignored, which leaves open how deep the pecks go",
                  fmt::format("write {} greater than 0", peck));
    }
    run_.refuse(word != nullptr ? *word : run_.motion_code(), codes::kOutOfRange, "a peck has no depth",
                fmt::format("write {} greater than 0", peck));
  }
}

// P=VC1 worth 0.4: a literal with a point is seconds, and what is worked out has no point that says so.
void CycleWords::check_worked_out_dwell(const Word& word) const {
  if (word.expression == kLiteral || word.value == std::round(word.value)) return;
  run_.refuse(
      word, codes::kNotWhole,
      fmt::format("{} is worth {:g}: whether P that is worked out counts seconds or milliseconds, no source says",
                  run_.text_of(word), word.value),
      "write the number itself, P0.4 or P400, or make the value whole");
}

// Posts write Q, or I and J together [P onCyclePoint, chip-breaking].
void CycleWords::check_pecks_of_osp() const {
  const Word* const step = run_.words.find('I');
  const Word* const depth = run_.words.find('J');
  const Word* const one = step != nullptr ? step : depth;
  if (one == nullptr || (step != nullptr && depth != nullptr && !run_.words.has('Q'))) return;
  run_.refuse(*one, codes::kNotInterpreted,
              "what a peck by I or J without the other, or with Q beside it, does was found in no source",
              "write Q for the depth of each peck, or I for it and J for the depth after which the tool comes up");
}

// G82 X7: what it takes over from the cycle before was found in no source. X and Y alone drill the same again.
void CycleWords::check_restated() const {
  const auto is_missing = [&](char letter) {
    return (run_.motion->word_mask & letter_bit(letter)) != 0 && !run_.words.has(letter);
  };
  const char normal = letter(axes_of(run_.control.modal.plane).third);
  std::string missing;
  const auto note = [&](bool is_kept, std::string_view name) {
    if (is_kept) missing += fmt::format("{}{}", missing.empty() ? "" : ", ", name);
  };
  note(!run_.words.has(normal), {&normal, 1});
  note(is_missing('R'), "R");
  note(is_missing('Q') && is_missing('I'), "Q");
  note(cycle_.dwell_s > 0 && is_missing('P'), "P");
  note(cycle_.peck_to_r > 0 && is_missing('J'), "J");
  note(cycle_.feed_out > 0 && is_missing(kFeedOutLetter), "FA");
  if (missing.empty()) return;
  run_.refuse(run_.motion_code(), codes::kNotInterpreted,
              fmt::format("{} goes on from another cycle without {}: whether it takes that over was found in no source",
                          run_.text_of(run_.motion_code()), missing),
              "state all words of the cycle again, or write X and Y without its code");
}

// With J the tool goes up to R whenever that depth has come together (setting); FA is the feed out of the hole.
void CycleWords::take_words_of_osp(bool is_new) {
  if (is_new) {
    cycle_.stays = false;
    cycle_.peck_to_r = cycle_.feed_out = 0;
  }
  cycle_.stays = cycle_.stays || (run_.words.letters() & run_.motion->stays_mask) != 0;
  check_pecks_of_osp();
  if (run_.words.has('Q') && cycle_.peck_to_r > 0) {
    run_.refuse(*run_.words.find('Q'), codes::kNotInterpreted,
                "what Q does in a cycle whose pecks I and J of a block before say was found in no source",
                "write the code of the cycle and all of its words into this block");
  }
  if (const Word* const depth = run_.words.find('J')) {
    cycle_.peck_to_r = run_.length(*depth);
    if (cycle_.peck_to_r <= 0) {
      run_.refuse(*depth, cycle_.peck_to_r < 0 ? codes::kNotInterpreted : codes::kOutOfRange,
                  "after what depth the tool comes up to R was found in no source for a J of 0 or below",
                  "write J greater than 0, or Q alone for the depth of each peck");
    }
  }
  const Word* const feed = run_.words.find(kFeedOutLetter);
  if (feed == nullptr) return;
  cycle_.feed_out = feed->value;
  if (cycle_.feed_out > 0) return;
  run_.refuse(*feed, codes::kNegative, "the feed out of the hole is none", "write a feed greater than 0");
}

}  // namespace

void take_cycle_words(Execution& run, bool goes_on) {
  CycleWords words(run, goes_on);
  words.take_unit();
  words.take_words();
}

}  // namespace plumbline::nc
