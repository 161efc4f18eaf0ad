#include "identify/model_text.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/text/number_text.hpp"
#include "base/units.hpp"

namespace plumbline::identify {
namespace {

using physics::ParameterSpec;

constexpr double kRoundingShare = 0.01;  // of a standard error that rounding may take
constexpr int kJointDecimals = 5;        // mm
constexpr int kDigits = 9;               // where no standard error is known

struct Splice {
  TextSpan span;  // that is replaced; length 0: inserted
  std::string text;
};

std::string spliced(const std::string& text, std::vector<Splice> splices) {
  std::stable_sort(splices.begin(), splices.end(),
                   [](const Splice& a, const Splice& b) { return a.span.offset < b.span.offset; });
  std::string result;
  std::size_t at = 0;
  for (const Splice& splice : splices) {
    PLUMBLINE_CHECK(splice.span.offset >= at);
    result.append(text, at, splice.span.offset - at);
    result += splice.text;
    at = splice.span.offset + splice.span.length;
  }
  return result.append(text, at, std::string::npos);
}

// The numbers of one key of one instance: as they were and as they shall be, in the file's unit.
class Numbers {
 public:
  Numbers(const ParameterSpec& spec, const double* before, const double* after, const double* resolution)
      : spec_(spec), before_(before), after_(after), resolution_(resolution) {}

  bool changed() const { return before_ == nullptr || !std::equal(after_, after_ + spec_.size(), before_); }
  bool changed(int i) const { return before_ == nullptr || after_[i] != before_[i]; }
  bool all_alike() const {
    return std::all_of(after_, after_ + spec_.size(), [&](double x) { return x == *after_; });
  }

  std::string text(int i) const {
    double value = std::clamp(after_[i] / spec_.unit.si, spec_.lower, spec_.upper);
    if (!spec_.table.empty() && std::abs(value) < machine::key_spec(spec_.table, spec_.key).least_nonzero) value = 0;
    if (value == 0) return "0";
    const double error = resolution_ == nullptr ? 0 : resolution_[i] / spec_.unit.si * kRoundingShare;
    const double fineness = error > 0 && std::isfinite(error)
                                ? error
                                : std::pow(10.0, std::floor(std::log10(std::abs(value))) - kDigits + 1);
    const int decimals = static_cast<int>(std::ceil(-std::log10(fineness)));
    if (decimals > kMostDecimals) return fmt::format("{:.{}g}", value, kDigits);
    return to_decimal(value, std::max(decimals, 0));
  }

  /// "1", "[1, 2]", "[[1, 2, 3], ...]"
  std::string text() const {
    if (spec_.size() == 1) return text(0);
    std::string all;
    for (int i = 0; i < spec_.size(); ++i) {
      all += i == 0 ? "[" : ", ";
      if (spec_.each > 1 && i % spec_.each == 0) all += '[';
      all += text(i);
      if (spec_.each > 1 && i % spec_.each == spec_.each - 1) all += ']';
    }
    return all + ']';
  }

 private:
  const ParameterSpec& spec_;
  const double* before_;  // nothing: there were none
  const double* after_;
  const double* resolution_;
};

// Spans of the numbers of a value, nested arrays flattened.
void collect(const TomlValue& value, std::vector<TextSpan>& spans) {
  if (value.kind != TomlValue::Kind::array) spans.push_back(value.span);
  for (const TomlValue& item : value.items) collect(item, spans);
}

class Writer {
 public:
  Writer(const machine::MachineModel& machine, const ModelChanges& changes)
      : machine_(machine), changes_(changes), before_(machine) {}

  std::string run() {
    const auto& after = changes_.forces.instances();
    PLUMBLINE_CHECK(after.size() >= before_.instances().size());
    for (std::size_t i = 0; i < after.size(); ++i) instance(i);
    if (changes_.joints) {
      joints("base", changes_.joints->base_W);
      joints("platform", changes_.joints->platform_P);
    }
    if (!changes_.provenance.empty()) provenance();
    posterior();
    std::string text = spliced(document().text, std::move(splices_));
    if (!text.empty() && text.back() != '\n') text += '\n';
    if (!tables_.empty()) text += '\n' + tables_;
    if (!rows_.empty()) text += rows_;
    if (!changes_.notes.empty()) text += '\n';
    for (const std::string& note : changes_.notes) text += comment(note);
    return text;
  }

 private:
  const TomlDocument& document() const { return machine_.document; }

  // Each line of a note is a comment line of its own, else the model could not be read.
  static std::string comment(const std::string& note) {
    std::istringstream lines(note);
    std::string text;
    for (std::string line; std::getline(lines, line);) text += line.empty() ? "#\n" : "# " + line + '\n';
    return text.empty() ? "#\n" : text;
  }

  void instance(std::size_t i) {
    const physics::Instance& now = changes_.forces.instances()[i];
    const bool old = i < before_.instances().size();
    int first = now.first;
    std::string row;
    bool matters = false;
    for (const ParameterSpec& spec : physics::effect_infos()[now.effect].parameters) {
      const auto at = static_cast<std::size_t>(first);
      const double* const after = changes_.forces.parameters.data() + at;
      const Numbers numbers(spec, old ? before_.parameters.data() + at : nullptr, after,
                            changes_.resolution.empty() ? nullptr : changes_.resolution.data() + at);
      first += spec.size();
      if (!old) {
        const bool fresh =
            std::all_of(after, after + spec.size(), [&](double x) { return x == spec.initial * spec.unit.si; });
        matters = matters || !fresh;
        if (!fresh || !spec.optional) row += fmt::format("{} = {}\n", spec.key, numbers.text());
      } else if (numbers.changed()) {
        spec.table.empty() ? effect_key(i, spec, numbers) : model_key(spec, numbers);
      }
    }
    if (matters) rows_ += fmt::format("\n[[effect]]\nname = \"{}\"\n{}", physics::effect_infos()[now.effect].name, row);
  }

  void effect_key(std::size_t i, const ParameterSpec& spec, const Numbers& numbers) {
    const TomlValue& rows = document().root.find("effect")->value;
    const TomlValue& row = rows.items[i - physics::kBaseEffects];
    const TomlEntry* const entry = row.find(spec.key);
    if (entry == nullptr) {  // an optional key: a line of its own below the name
      const TextSpan name = row.find("name")->value.span;
      const std::size_t end = std::min(document().text.find('\n', name.offset), document().text.size());
      splices_.push_back({{end, 0}, fmt::format("\n{} = {}", spec.key, numbers.text())});
      return;
    }
    std::vector<TextSpan> spans;
    collect(entry->value, spans);
    PLUMBLINE_CHECK(spans.size() == static_cast<std::size_t>(spec.size()));
    splice_each(spans, numbers);
  }

  void model_key(const ParameterSpec& spec, const Numbers& numbers) {
    const machine::ModelValue& value = machine_.value(spec.table, spec.key);
    if (!value.given()) {
      add_key(spec, numbers);
    } else if (value.spans.size() > 1 && value.spans[0].offset == value.spans[1].offset) {
      splices_.push_back({value.span, numbers.all_alike() ? numbers.text(0) : numbers.text()});  // one for all six
    } else {
      splice_each(value.spans, numbers);
    }
    if (value.given()) no_longer_assumed(value.span);
  }

  // What new-model writes behind a number that it assumes would be untrue behind another one.
  void no_longer_assumed(TextSpan value) {
    constexpr std::string_view kAssumed = "# assumed: ";
    const std::string& text = document().text;
    const std::size_t begin = value.offset + value.length;
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::size_t comment = text.find_first_not_of(" \t", begin);
    if (comment >= end || text.compare(comment, kAssumed.size(), kAssumed) != 0) return;
    splices_.push_back({{comment + 2, 0}, "fitted; before, "});
  }

  void joints(std::string_view table, const machine::StrutVectors<double>& positions) {
    const machine::ModelValue& value = machine_.value(table, "joints_mm");
    PLUMBLINE_CHECK(value.spans.size() == static_cast<std::size_t>(positions.size()));
    for (std::size_t i = 0; i < value.spans.size(); ++i) {
      const double mm = positions(static_cast<Eigen::Index>(i % 3), static_cast<Eigen::Index>(i / 3)) / kMm;
      splices_.push_back({value.spans[i], to_decimal(mm, kJointDecimals)});
    }
  }

  void splice_each(const std::vector<TextSpan>& spans, const Numbers& numbers) {
    for (std::size_t i = 0; i < spans.size(); ++i) {
      const int k = static_cast<int>(i);
      if (numbers.changed(k)) splices_.push_back({spans[i], numbers.text(k)});
    }
  }

  // A key that the file left out: below its table's header, or in a table of its own.
  void add_key(const ParameterSpec& spec, const Numbers& numbers) {
    const std::string line = fmt::format("{} = {}", spec.key, numbers.text());
    const TomlEntry* table = document().root.find(spec.table);
    if (table == nullptr) {
      const std::string header = fmt::format("[{}]\n", spec.table);
      if (!tables_.starts_with(header) && tables_.find('\n' + header) == std::string::npos) tables_ += header;
      tables_ += line + '\n';
      return;
    }
    const std::string& text = document().text;
    const std::size_t header = table->value.span.offset;
    if (text[header] == '{') {
      splices_.push_back({{header + 1, 0}, line + (table->value.entries.empty() ? "" : ", ")});
      return;
    }
    const std::size_t end = text.find('\n', header);
    if (end == std::string::npos) {
      splices_.push_back({{text.size(), 0}, '\n' + line});
    } else {
      splices_.push_back({{end + 1, 0}, line + '\n'});
    }
  }

  // In the place of another one that the file names. Where there is none now, no table says that there is.
  void posterior() {
    const machine::ModelValue& file = machine_.value("posterior", "file");
    const machine::ModelValue& hash = machine_.value("posterior", "hash");
    if (changes_.posterior && file.given() && hash.given()) {
      splices_.push_back({file.span, fmt::format("\"{}\"", changes_.posterior->file)});
      splices_.push_back({hash.span, fmt::format("\"{}\"", changes_.posterior->hash)});
      return;
    }
    if (const TomlEntry* const table = document().root.find("posterior")) drop_lines(*table);
    if (!changes_.posterior) return;
    tables_ += fmt::format("{}[posterior]\nfile = \"{}\"\nhash = \"{}\"\n", tables_.empty() ? "" : "\n",
                           changes_.posterior->file, changes_.posterior->hash);
  }

  // Of a table and its keys, one of which may stand beside another.
  void drop_lines(const TomlEntry& table) {
    const std::string& text = document().text;
    std::set<std::size_t> dropped;
    const auto drop = [&](const TextSpan& span) {
      const std::size_t begin = text.rfind('\n', span.offset) + 1;  // npos + 1 is 0
      const std::size_t end = std::min(text.find('\n', span.offset), text.size() - 1) + 1;
      if (dropped.insert(begin).second) splices_.push_back({{begin, end - begin}, ""});
    };
    drop(table.key_span);
    for (const TomlEntry& entry : table.value.entries) drop(entry.key_span);
  }

  void provenance() {
    const machine::ModelValue& value = machine_.value("", "provenance");
    const std::string& text = document().text;
    std::string words = changes_.provenance;
    std::erase_if(words, [](char c) { return c == '"' || c == '\'' || c == '\\' || c == '\n'; });
    if (!value.given()) {
      const TextSpan name = machine_.value("", "name").span;
      const std::size_t end = std::min(text.find('\n', name.offset + name.length), text.size());
      splices_.push_back({{end, 0}, fmt::format("\nprovenance = \"{}\"", words)});
      return;
    }
    // before the closing quotes, of which there are one or three
    const std::size_t end = value.span.offset + value.span.length;
    const char quote = text[end - 1];
    const std::size_t quotes = value.span.length >= 6 && text[end - 2] == quote && text[end - 3] == quote ? 3 : 1;
    splices_.push_back({{end - quotes, 0}, (value.text.empty() ? "" : "; ") + words});
  }

  const machine::MachineModel& machine_;
  const ModelChanges& changes_;
  physics::ForceModel before_;
  std::vector<Splice> splices_;
  std::string tables_;  // to be added
  std::string rows_;
};

}  // namespace

std::string model_text(const machine::MachineModel& machine, const ModelChanges& changes) {
  return Writer(machine, changes).run();
}

}  // namespace plumbline::identify
