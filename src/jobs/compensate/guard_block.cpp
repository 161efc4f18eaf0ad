#include "jobs/compensate/guard_block.hpp"

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "jobs/compensate/guards.hpp"
#include "nc/language/comment_line.hpp"
#include "nc/language/guard_lines.hpp"
#include "nc/syntax/line_head.hpp"
#include "nc/syntax/line_source.hpp"

namespace plumbline::jobs {
namespace {

std::vector<std::string> lines_of_guard(const nc::ProgramSettings& program, const compensate::ProgramSurvey& survey) {
  const nc::Dialect& dialect = survey.dialect;
  switch (dialect.guard) {
    case nc::GuardLanguage::linuxcnc:
      return linuxcnc_guard(program, survey);
    case nc::GuardLanguage::macro_b:
      return fanuc_guard(program, survey.unnamed(), dialect);
    case nc::GuardLanguage::sinumerik:
      return siemens_guard(program, survey.unnamed(), dialect);
    case nc::GuardLanguage::none:
      break;
  }
  refuse("guard-dialect", fmt::format("which variables of {} hold its offsets was found in no source", dialect.name),
         "leave --guard out; the offsets stand in the comments at the start of the output");
}

}  // namespace

std::vector<std::string> guard_block(const nc::ProgramSettings& program, const compensate::ProgramSurvey& survey) {
  const nc::Dialect& dialect = survey.dialect;
  std::vector<std::string> lines = lines_of_guard(program, survey);
  lines.insert(lines.begin(), nc::comment_line(nc::kGuardBegins, dialect));
  lines.push_back(nc::comment_line(nc::kGuardEnds, dialect));
  return lines;
}

void refuse_guard_before_definitions(const InputFile& source, const nc::Dialect& dialect) {
  if (!dialect.syntax.declared) return;
  nc::LineSource lines(source);
  nc::Line line;
  bool begun = false;
  bool body = false;
  while (lines.next(line)) {
    const nc::LineHead head = nc::head_of(line.text, dialect);
    if (begun && !head.program.empty()) return;  // the guard stands in the first program of an archive
    begun = begun || !head.empty;
    const nc::FlowWord word = head.word;
    if (word != nc::FlowWord::define && word != nc::FlowWord::sub) {
      body = body || (!head.empty && head.program.empty());
      continue;
    }
    if (!body) continue;  // the guard stands behind it
    Place place;
    place.file = source.name();
    place.line = line.place.line;
    place.column = 1;
    place.text = line.text;
    place.length = line.text.size();
    refuse("guard-definitions",
           "definitions stand before all else of a program, and the guard would stand before this one",
           "put it before the first other block, use R parameters in place of DEF, or leave --guard out",
           std::move(place));
  }
}

}  // namespace plumbline::jobs
