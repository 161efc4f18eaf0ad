#include "report/page/page.hpp"

#include <algorithm>
#include <cmath>
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

// The one character that could end the element which holds the data, or begin another one.
std::string data_text(const Page& page) {
  Json data{{"title", page.title},
            {"lead", page.lead},
            {"verdict", name_of(page.verdict)},
            {"made_by", "Made by plumbline " + std::string(version()) + "."},
            {"sections", page.sections}};
  const std::string text = data.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string escaped;
  escaped.reserve(text.size() + 1024);
  for (const char c : text) {
    if (c == '<') {
      escaped += "\\u003c";
    } else {
      escaped += c;
    }
  }
  return escaped + "\n";
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
  std::string text(embedded::page_begin);
  text += data_text(page);
  text += embedded::page_drawing;
  if (page.has_scene) text += embedded::page_space;
  text += embedded::page_end;
  return text;
}

void write_page(const Page& page, OutputFile& output) { output.write(page_text(page)); }

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
