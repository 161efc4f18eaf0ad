#include "nc/rewrite/output/emit_codes.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/check.hpp"
#include "nc/language/block_words.hpp"

namespace plumbline::nc {
namespace {

bool is_path_control(Action action) {
  return action == Action::exact_path || action == Action::exact_stop || action == Action::continuous;
}

}  // namespace

void BlockCodes::add_after_motion(const Word& word) {
  PLUMBLINE_CHECK(after_count_ < after_.size());
  after_[after_count_++] = &word;
}

bool merges_points(const Step& step, const BlockCodes& codes) {
  return codes.path_control != nullptr && step.after->path_control == PathControl::continuous &&
         step.after->switches.naive_tolerance > 0;
}

void keep_each_point(BlockEditor& editor, const Block& block) {
  if (const Word* const word = find_word(block, 'Q')) {
    std::string text;
    append_word(text, 'Q', 0, 0, {editor.spelling().lower_case, false, editor.spelling().point, 0});
    return editor.replace(word->span, text);
  }
  const Word* const word = find_word(block, 'P');
  PLUMBLINE_CHECK(word != nullptr);
  editor.insert_after(word->span.end, "Q0");
}

CodeWriter::CodeWriter(const Dialect& dialect)
    : dialect_(dialect),
      motion_{text_of("motion_off"), text_of("rapid"), text_of("feed"), text_of("arc_cw"), text_of("arc_ccw"), {}, {}},
      feed_mode_{text_of("inverse_time"), text_of("per_minute"), text_of("per_revolution")},
      path_control_{text_of("exact_path"), text_of("exact_stop"), text_of("continuous")},
      dwell_(text_of("dwell")),
      distance_{text_of("absolute"), text_of("incremental")} {
  if (path_control_.front().empty()) path_control_.front() = path_control_.back();
  for (const CodeRow& row : dialect.g_codes) {
    if (row.action != Action::dwell) continue;
    dwell_letter_ = row.words.find('P') != std::string::npos ? 'P' : row.words.front();
  }
}

std::string CodeWriter::text_of(std::string_view meaning, std::optional<int> value) const {
  for (const auto* rows : {&dialect_.g_codes, &dialect_.m_codes}) {
    const char letter = rows == &dialect_.g_codes ? 'G' : 'M';
    for (const CodeRow& row : *rows) {
      if (row.meaning != meaning || (value && row.value != *value) || !row.written_as.empty()) continue;
      return row.code % 10 == 0 ? fmt::format("{}{}", letter, row.code / 10)
                                : fmt::format("{}{}.{}", letter, row.code / 10, row.code % 10);
    }
  }
  return {};
}

bool CodeWriter::is_motion(const Word& word) const {
  const CodeRow* row = word.letter != 'M' ? row_of(word) : nullptr;
  return row != nullptr && (row->group == kMotionGroup || row->action == Action::no_hole);
}

std::string_view CodeWriter::name_of(Action action) const {
  for (const CodeRow& row : dialect_.named_codes) {
    if (row.action == action) return row.name;
  }
  return {};
}

bool CodeWriter::is_call(const Word& word) const {
  const CodeRow* const row = row_of(word);
  return row != nullptr && row->action == Action::called_cycle;
}

const CodeRow* CodeWriter::row_of(const Word& word) const { return dialect_.row_of(word); }

BlockCodes CodeWriter::codes_of(const Block& block) const {
  BlockCodes codes;
  bool dwells = false;
  for (const Word& word : block.words) {
    if (word.letter == 'F') codes.feed = &word;
    const CodeRow* row = row_of(word);
    if (row == nullptr) continue;
    if (word.letter != 'M' && row->order != Order::after_motion) {
      const bool ends = row->action == Action::motion_off;
      const bool gives_way =
          ends && (codes.motion != nullptr || dialect_.behaviour.rapid_after_cycles);  // G80 beside G3
      if (row->group == kMotionGroup && !gives_way) codes.motion = &word;
      if (row->group == kFeedModeGroup) codes.feed_mode = &word;
      if (row->action == Action::modal_call) codes.modal_call = &word;
      if (is_path_control(row->action)) codes.path_control = &word;
      if (row->group != kMotionGroup && row->takes_axes) {
        codes.other_taker = codes.axis_taker;
        codes.axis_taker = &word;
      }
    } else if (row->order == Order::after_motion) {
      codes.add_after_motion(word);
    }
    if (row->action == Action::dwell && (row->word_mask & letter_bit('F')) != 0) dwells = true;
  }
  if (dwells) codes.feed = nullptr;                                                 // its F is a time
  if (codes.feed != nullptr && other_code_takes(block, 'F')) codes.feed = nullptr;  // the time of a dwell
  return codes;
}

bool CodeWriter::other_code_takes(const Block& block, char letter) const {
  for (const Word& word : block.words) {
    const CodeRow* row = row_of(word);
    if (row == nullptr || (word.letter != 'M' && row->group == kMotionGroup)) continue;
    if (row->words.find(letter) != std::string::npos) return true;
  }
  return false;
}

}  // namespace plumbline::nc
