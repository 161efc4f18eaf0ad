#include "nc/sequence/nesting.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace plumbline::nc {
namespace {

// The word that begins what this one begins, divides or ends; none: it does nothing of that.
FlowWord kind_of(FlowWord word) {
  switch (word) {
    case FlowWord::begin_if:
    case FlowWord::else_if:
    case FlowWord::otherwise:
    case FlowWord::end_if:
      return FlowWord::begin_if;
    case FlowWord::begin_do:
    case FlowWord::begin_while:
    case FlowWord::end_while:
      return FlowWord::begin_while;
    case FlowWord::begin_for:
    case FlowWord::end_for:
      return FlowWord::begin_for;
    case FlowWord::begin_loop:
    case FlowWord::end_loop:
      return FlowWord::begin_loop;
    case FlowWord::begin_repeat:
    case FlowWord::until:
      return FlowWord::begin_repeat;
    default:
      return FlowWord::none;
  }
}

}  // namespace

void Nesting::add(const LineHead& head, const LinePlace& place, bool left_out) {
  if (!head.program.empty()) close();
  const FlowWord kind = kind_of(head.word);
  if (kind == FlowWord::none) return;
  if (head.behind_slash) behind_slash_.push_back({place.line, kind});
  if (head.behind_slash && left_out) return;
  switch (head.word) {
    case FlowWord::else_if:
    case FlowWord::otherwise:
      return divide(head, place);
    case FlowWord::end_if:
    case FlowWord::end_while:
    case FlowWord::end_for:
    case FlowWord::end_loop:
    case FlowWord::until:
      return end(head, place, kind);
    default:
      return begin(head, place);
  }
}

void Nesting::begin(const LineHead& head, const LinePlace& place) {
  lines_.emplace_back(place.line, parts_.size());
  open_.push_back(parts_.size());
  parts_.push_back({kind_of(head.word), head.loop, place, {0, 0}, {0, 0}, {}, false});
}

void Nesting::divide(const LineHead& head, const LinePlace& place) {
  NestedPart* const branch = open_.empty() ? nullptr : &parts_[open_.back()];
  if (branch == nullptr || branch->word != FlowWord::begin_if) {
    return add_stray(place, "this divides a branch that was not begun by an IF around it");
  }
  lines_.emplace_back(place.line, open_.back());
  if (head.word == FlowWord::else_if) {
    branch->fault = fmt::format("line {} divides this branch by a word that the control does not have", place.line);
  } else if (branch->otherwise.line != 0) {
    branch->fault =
        fmt::format("this branch is divided in line {}, and again in line {}", branch->otherwise.line, place.line);
  } else {
    branch->otherwise = place;
  }
}

void Nesting::end(const LineHead& head, const LinePlace& place, FlowWord kind) {
  if (open_.empty()) return add_stray(place, "this ends what was not begun");
  NestedPart& part = parts_[open_.back()];
  if (part.word != kind || part.number != head.loop) {
    return add_stray(place,
                     fmt::format("this ends what was not begun, or crosses what line {} begins", part.begin.line));
  }
  lines_.emplace_back(place.line, open_.back());
  part.end = place;
  open_.pop_back();
}

void Nesting::add_stray(const LinePlace& place, std::string fault) {
  lines_.emplace_back(place.line, parts_.size());
  parts_.push_back({FlowWord::none, 0, place, {0, 0}, place, std::move(fault), false});
}

void Nesting::close() {
  for (const std::size_t part : open_) {
    parts_[part].fault = "what this line begins has no end of its own in this program";
    parts_[part].is_open = true;
  }
  open_.clear();
}

const NestedPart* Nesting::part_at(std::size_t line) const {
  const auto at = std::lower_bound(lines_.begin(), lines_.end(), std::pair{line, std::size_t{0}});
  return at == lines_.end() || at->first != line ? nullptr : &parts_[at->second];
}

bool NestedPart::is_entered(std::size_t from, std::size_t to) const {
  if (word == FlowWord::none || to <= begin.line || to > end.line) return false;
  if (!contains(from)) return true;
  if (otherwise.line == 0 || to == end.line) return false;
  return from < otherwise.line ? to > otherwise.line : to <= otherwise.line;
}

const NestedPart* Nesting::entered(std::size_t from, std::size_t to) const {
  const auto at =
      std::find_if(parts_.begin(), parts_.end(), [&](const NestedPart& part) { return part.is_entered(from, to); });
  return at == parts_.end() ? nullptr : &*at;
}

const NestedPart* Nesting::cut_by(std::size_t first, std::size_t last) const {
  const auto holds = [&](const LinePlace& place) { return place.line >= first && place.line <= last; };
  const auto at = std::find_if(parts_.begin(), parts_.end(), [&](const NestedPart& part) {
    if (part.word == FlowWord::none || (holds(part.begin) && holds(part.end))) return false;
    return holds(part.begin) || holds(part.otherwise) || holds(part.end);
  });
  return at == parts_.end() ? nullptr : &*at;
}

bool Nesting::has_slash_between(const LinePlace& from, const LinePlace& to, FlowWord kind) const {
  return std::any_of(behind_slash_.begin(), behind_slash_.end(), [&](const LineBehindSlash& one) {
    return one.kind == kind && one.line > from.line && one.line <= to.line;
  });
}

}  // namespace plumbline::nc
