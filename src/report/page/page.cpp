#include "report/page/page.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string_view>

#include "base/version.hpp"

namespace plumbline::embedded {
extern const std::string_view page_begin;
extern const std::string_view page_drawing;
extern const std::string_view page_space;
extern const std::string_view page_end;
}  // namespace plumbline::embedded

namespace plumbline::report {
namespace {

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::good:
      return "good";
    case Verdict::warn:
      return "warn";
    case Verdict::bad:
      return "bad";
    default:
      return "";
  }
}

using Sink = std::function<void(std::string_view)>;

// `<` is the one character that could end the element which holds the data, or begin another one.
void write_escaped(std::string_view text, const Sink& sink) {
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<')) {
    sink(text.substr(0, at));
    sink("\\u003c");
    text.remove_prefix(at + 1);
  }
  sink(text);
}

void write_whole(const Json& json, const Sink& sink) {
  write_escaped(json.dump(-1, ' ', false, Json::error_handler_t::replace), sink);
}

// The same text as of Json::dump, member by member.
void write_json(const Json& json, const Sink& sink) {
  const bool flat = std::none_of(json.begin(), json.end(), [](const Json& part) { return part.is_structured(); });
  if (!json.is_structured() || flat) {
    write_whole(json, sink);
    return;
  }
  sink(json.is_object() ? "{" : "[");
  std::string_view between;
  for (const auto& [key, part] : json.items()) {
    sink(between);
    between = ",";
    if (json.is_object()) {
      write_whole(key, sink);
      sink(":");
    }
    write_json(part, sink);
  }
  sink(json.is_object() ? "}" : "]");
}

void write_data(const Page& page, const Sink& sink) {
  const Json head{{"title", page.title},
                  {"lead", page.lead},
                  {"verdict", name_of(page.verdict)},
                  {"made_by", "Made by plumbline " + std::string(version()) + "."}};
  sink("{");
  for (const auto& [key, value] : head.items()) {
    write_whole(key, sink);
    sink(":");
    write_whole(value, sink);
    sink(",");
  }
  sink("\"sections\":[");
  std::string_view between;
  for (const Json& section : page.sections) {
    sink(between);
    between = ",";
    write_json(section, sink);
  }
  sink("]}\n");
}

void write_parts(const Page& page, const Sink& sink) {
  sink(embedded::page_begin);
  write_data(page, sink);
  sink(embedded::page_drawing);
  if (page.has_scene) sink(embedded::page_space);
  sink(embedded::page_end);
}

constexpr std::string_view kBase64 = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::string base64(std::span<const std::uint8_t> bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t have = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < have ? bytes[i + k] : 0);
    for (std::size_t k = 0; k < 4; ++k) text += k <= have ? kBase64[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

}  // namespace

std::string page_text(const Page& page) {
  std::string text;
  write_parts(page, [&](std::string_view part) { text += part; });
  return text;
}

void write_page(const Page& page, OutputFile& output) {
  write_parts(page, [&](std::string_view part) { output.write(part); });
}

Json packed(std::span<const double> values, double quantum) {
  constexpr std::int32_t kMissing = std::numeric_limits<std::int32_t>::min();
  constexpr double kLargest = std::numeric_limits<std::int32_t>::max();
  std::vector<std::uint8_t> bytes;
  bytes.reserve(4 * values.size());
  for (const double value : values) {
    const double whole = std::round(value / quantum);
    const auto number =
        static_cast<std::uint32_t>(std::abs(whole) <= kLargest ? static_cast<std::int32_t>(whole) : kMissing);
    for (const int shift : {0, 8, 16, 24}) bytes.push_back(static_cast<std::uint8_t>(number >> shift));
  }
  return Json{{"quantum", quantum}, {"data", base64(bytes)}};
}

}  // namespace plumbline::report
