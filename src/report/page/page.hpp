// The one kind of page that reports are read on: a file that draws itself offline, from one block of JSON.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/files/output_file.hpp"

namespace plumbline::report {

using Json = nlohmann::ordered_json;

/// How the sentence at the top is marked.
enum class Verdict { none, good, warn, bad };

struct Page {
  std::string title;
  std::string lead;  // one sentence: what the reader came for
  Verdict verdict = Verdict::none;
  std::vector<Json> sections;  // of page/sections.hpp
  bool has_scene = false;      // three-dimensional: takes another library
};

/// Writes the whole file, piece by piece: no second copy of the data is made. Text may hold anything, bytes that are
/// not UTF-8 as well: it stays text.
void write_page(const Page& page, OutputFile& output);
/// The same as a string.
std::string page_text(const Page& page);

/// Numbers of a page that are many: {quantum, data}, whole multiples of `quantum` in base64, 32 bits each, little end
/// first. What is no number or too large is missing there.
Json packed(std::span<const double> values, double quantum);

}  // namespace plumbline::report
