#include "jobs/program/beginning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "base/diagnostic.hpp"
#include "base/text/characters.hpp"
#include "jobs/program/used_tools.hpp"
#include "nc/control/parameters/parameters.hpp"
#include "nc/language/dialect.hpp"
#include "nc/syntax/line_source.hpp"
#include "nc/syntax/parser.hpp"

namespace plumbline::jobs {
namespace {

constexpr int kTenths = 10;  // G92.1 is 921
constexpr int kRapid = 0;
constexpr double kBeyondCodes = 1e3;

int tenths(const nc::Word& word) { return static_cast<int>(std::lround(word.value * kTenths)); }

// Motion codes end what G0 said; others that take words of axes do not go to a place that the program states.
bool is_other_motion(int code) {
  constexpr std::array kMotions{10,  20,  30,  50,  51,  52,  330, 331, 382, 383, 384, 385,
                                730, 760, 810, 820, 830, 840, 850, 860, 870, 880, 890, 740};
  return std::find(kMotions.begin(), kMotions.end(), code) != kMotions.end();
}

bool takes_axes(int code) {
  constexpr std::array kCodes{40, 100, 280, 281, 300, 301, 431, 432, 520, 920, 921, 922, 923};
  return std::find(kCodes.begin(), kCodes.end(), code) != kCodes.end();
}

bool is_axis(char letter) { return std::string_view("XYZABCUVW").find(letter) != std::string_view::npos; }

class BeginningReader {
 public:
  // False: what stands behind the block is not the beginning any more.
  bool take(const nc::Block& block) {
    if (block.flow.word == nc::FlowWord::sub) ++inside_;
    if (block.flow.word == nc::FlowWord::end_sub) {
      --inside_;
      return true;
    }
    if (inside_ > 0) return true;
    if (block.flow.word != nc::FlowWord::none || block.block_delete || reads_control(block.text)) return false;
    return take_words(block);
  }

  compensate::Beginning result() const { return beginning_; }

 private:
  // A parameter of the control, #<_x> or #5420.
  static bool reads_control(std::string_view text) {
    for (std::size_t at = text.find('#'); at != std::string_view::npos; at = text.find('#', at + 1)) {
      const std::string_view name = text.substr(at + 1);
      if (name.starts_with("<_") || (name.size() > 1 && name[0] == '5' && is_digit(name[1]))) return true;
    }
    return false;
  }

  bool take_words(const nc::Block& block) {
    bool places = true;  // words of axes are places
    for (const nc::Word& word : block.words) {
      if (!nc::is_code(word)) continue;
      if (word.expression != nc::kLiteral || std::abs(word.value) >= kBeyondCodes || calls(word)) return false;
      if (word.letter != 'G') continue;
      take_code(tenths(word));
      places = places && !takes_axes(tenths(word));
    }
    AxisSet axes;
    bool has_axes = false;
    for (const nc::Word& word : block.words) {
      unit_open_ = unit_open_ && std::string_view("FDPQRIJK").find(word.letter) == std::string_view::npos;
      feed_mode_open_ = feed_mode_open_ && word.letter != 'F';
      if (!is_axis(word.letter)) continue;
      has_axes = true;
      if (const auto axis = axis_of(word.letter)) axes.insert(*axis);
    }
    if (places && rapid_ && absolute_) beginning_.reached = axes;
    return !has_axes;
  }

  // M98 and codes of the user run what is not read here.
  static bool calls(const nc::Word& word) {
    constexpr int kFirstOfUser = 100;
    return word.letter == 'M' && (word.value == 98 || word.value >= kFirstOfUser);
  }

  void take_code(int code) {
    if (code == 200 || code == 210) beginning_.states_unit = beginning_.states_unit || unit_open_;
    if (code == 900 || code == 910) beginning_.states_distance = true;
    if (code == 910) absolute_ = false;
    if (code == 900) absolute_ = true;
    if (code == 930 || code == 940 || code == 950) {
      beginning_.states_feed_mode = beginning_.states_feed_mode || feed_mode_open_;
    }
    if (code == kRapid) rapid_ = true;
    if (is_other_motion(code)) rapid_ = false;
  }

  compensate::Beginning beginning_;
  int inside_ = 0;              // subprograms
  bool unit_open_ = true;       // no length and no feed has been read yet
  bool feed_mode_open_ = true;  // no feed
  bool rapid_ = false;
  bool absolute_ = true;  // the guard compares what is not stated
};

// Of G92, for G92.3.
bool keeps_g92(const nc::ProgramSettings& settings) {
  for (const Axis axis : kAllAxes) {
    const auto found = settings.variables.find(nc::kG92InForce + 1 + static_cast<int>(index(axis)));
    if (found != settings.variables.end()) return true;
  }
  return false;
}

}  // namespace

compensate::Beginning beginning_of(const OpenedProgram& program) {
  const nc::Dialect& dialect = program.dialect;
  if (dialect.guard != nc::GuardLanguage::linuxcnc) return {};
  BeginningReader reader;
  nc::LineSource lines(program.file, dialect.syntax.goes_on);
  nc::Parser parser(dialect);
  nc::Block block;
  nc::Line line;
  while (lines.next(line) && line.whole && line.text.size() <= dialect.line_length) {
    block.file = program.file.name();
    block.text = line.text;
    block.line = line.place.line;
    block.offset = line.place.offset;
    try {
      parser.parse(block);
    } catch (const Refusal&) {
      break;  // executing the program will say so
    }
    if (!reader.take(block)) break;
  }
  compensate::Beginning beginning = reader.result();
  beginning.may_restore_g92 = keeps_g92(program.settings) && may_restore_g92(program.file);
  return beginning;
}

}  // namespace plumbline::jobs
