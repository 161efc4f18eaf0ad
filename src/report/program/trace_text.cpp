#include "report/program/trace_text.hpp"

#include <cmath>
#include <iterator>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "base/text/number_text.hpp"

namespace plumbline::report {
namespace {

using nc::FeedMode;
using nc::Motion;
using nc::MotionKind;
using nc::Plane;

constexpr std::size_t kChunk = std::size_t{1} << 16U;
constexpr double kLargestExact = 9e15;  // in units of the last decimal
constexpr int kDecimals = 9;

std::string_view name_of(MotionKind kind) {
  switch (kind) {
    case MotionKind::rapid:
      return "rapid";
    case MotionKind::feed:
      return "feed";
    case MotionKind::arc:
      return "arc";
    case MotionKind::probe:
      return "probe";
    case MotionKind::dwell:
      break;
  }
  return "dwell";
}

std::string_view name_of(FeedMode mode) {
  switch (mode) {
    case FeedMode::inverse_time:
      return "G93";
    case FeedMode::per_minute:
      return "G94";
    case FeedMode::per_revolution:
      break;
  }
  return "G95";
}

std::string_view name_of(Plane plane) {
  switch (plane) {
    case Plane::xy:
      return "G17";
    case Plane::zx:
      return "G18";
    case Plane::yz:
      break;
  }
  return "G19";
}

void append_number(std::string& out, double value) {
  int decimals = kDecimals;
  double scaled = std::abs(value) * 1e9;
  while (decimals > 0 && scaled > kLargestExact) {
    scaled /= 10;
    --decimals;
  }
  if (scaled > kLargestExact) {
    fmt::format_to(std::back_inserter(out), "{}", value);
  } else {
    append_decimal(out, value, decimals);
  }
}

void append_numbers(std::string& out, std::span<const double> values) {
  out += '[';
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) out += ", ";
    append_number(out, values[i]);
  }
  out += ']';
}

}  // namespace

void append_trace_line(std::string& out, const Motion& motion) {
  fmt::format_to(std::back_inserter(out), R"({{"line": {}, "motion": "{}", "to": )", motion.line, name_of(motion.kind));
  append_numbers(out, motion.to.values);
  out += ", \"machine\": ";
  append_numbers(out, motion.machine.values);
  out += ", \"feed\": ";
  append_number(out, motion.feed);
  fmt::format_to(std::back_inserter(out), R"(, "feed_mode": "{}")", name_of(motion.feed_mode));
  if (motion.unknown_strokes) out += ", \"strokes\": \"unknown\"";
  if (motion.kind == MotionKind::dwell) {
    out += ", \"seconds\": ";
    append_number(out, motion.dwell_s);
  }
  if (motion.kind == MotionKind::arc) {
    fmt::format_to(std::back_inserter(out), R"(, "plane": "{}", "centre": )", name_of(motion.arc.plane));
    append_numbers(out, motion.arc.centre_mm);
    fmt::format_to(std::back_inserter(out), ", \"turns\": {}", motion.arc.turns);
  }
  out += "}\n";
}

void TraceWriter::add(const Motion& motion) {
  append_trace_line(text_, motion);
  if (text_.size() >= kChunk) flush();
}

void TraceWriter::flush() {
  output_.write(text_);
  text_.clear();
}

}  // namespace plumbline::report
