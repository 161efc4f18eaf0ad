// What a report says of itself, to be signed: machine, who measured with what, which files it rests on.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "jobs/circularity.hpp"
#include "measure/dataset.hpp"

namespace plumbline::jobs {

struct Paper {
  struct File {
    std::string what, name;
    std::uint64_t hash = 0;  // FNV-1a; of a dataset with the tables that it names
  };
  std::string machine;  // as the dataset calls it
  measure::Protocol protocol;
  std::vector<std::pair<std::string, measure::Protocol>> further;  // of datasets beside the first, by their names
  std::vector<File> files;
  std::vector<measure::Run> runs;
  CircularityTable figures;
};

/// Of a dataset, those that are joined `with` it, and the models that are laid beside them (empty names: none). What
/// was read from a pipe cannot be read again: without a model it is left out, without a dataset all is. Refuses as
/// their readers do.
Paper paper_of(const std::string& path, const std::vector<std::string>& models,
               const std::vector<std::string>& with = {});

/// FNV-1a of a dataset and the tables that it names.
std::uint64_t dataset_hash(const measure::Dataset& dataset, const std::string& path);

}  // namespace plumbline::jobs
