#include "jobs/measured/paper.hpp"

#include <algorithm>
#include <filesystem>

#include "base/files/files.hpp"
#include "base/files/path_of.hpp"
#include "base/text/hash.hpp"
#include "jobs/measured/joined.hpp"

namespace plumbline::jobs {

std::uint64_t dataset_hash(const measure::Dataset& dataset, const std::string& path) {
  std::uint64_t hash = fnv1a(dataset.document.text);
  const std::filesystem::path folder = path_of(path).parent_path();
  for (const measure::Run& run : dataset.runs)
    hash = fnv1a(read_text((folder / path_of(run.file)).generic_string()), hash);
  return hash;
}

Paper paper_of(const std::string& path, const std::vector<std::string>& models, const std::vector<std::string>& with) {
  Paper paper;
  std::error_code none;
  const auto is_file = [&](const std::string& name) { return std::filesystem::is_regular_file(path_of(name), none); };
  if (!is_file(path) || !std::all_of(with.begin(), with.end(), is_file)) return paper;
  JoinedData data = read_joined(path, with, measure::Believe::the_table);
  measure::Dataset& dataset = data.dataset;
  paper.machine = dataset.machine;
  paper.protocol = dataset.protocol;
  paper.figures = circularity_table(dataset);
  for (const MeasuredFile& file : data.files) paper.files.push_back({"data", file.path, file.hash});
  for (std::size_t i = 0; i < with.size(); ++i) paper.further.emplace_back(with[i], data.protocols[i + 1]);
  for (const std::string& model : models) {
    if (is_file(model)) paper.files.push_back({"model", model, fnv1a(read_text(model))});
  }
  paper.runs = std::move(dataset.runs);
  return paper;
}

}  // namespace plumbline::jobs
