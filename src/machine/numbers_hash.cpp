#include "machine/numbers_hash.hpp"

#include <cstring>
#include <string>
#include <vector>

#include "base/text/hash.hpp"

namespace plumbline::machine {
namespace {

std::uint64_t with_numbers(std::uint64_t hash, const std::vector<double>& numbers) {
  for (const double number : numbers) {
    std::string bytes(sizeof number, '\0');
    std::memcpy(bytes.data(), &number, sizeof number);
    hash = fnv1a(bytes, hash);
  }
  return hash;
}

// Tables that say what is known of a machine and what it may do, not how it is.
bool is_beside(std::string_view table) {
  return table == "limits" || table == "control" || table == "uncertainty" || table == "posterior";
}

}  // namespace

std::uint64_t numbers_hash(const MachineModel& model) {
  std::uint64_t hash = fnv1a(model.value("", "rotation").text);
  for (const ModelValue& value : model.values) {
    if (!is_beside(value.table) && !value.values.empty())
      hash = with_numbers(fnv1a(value.table + "." + value.key, hash), value.values);
  }
  for (const EffectRow& row : model.effects) {
    hash = fnv1a(row.name, hash);
    for (const EffectValue& value : row.values) hash = with_numbers(fnv1a(value.key, hash), value.values);
  }
  return hash;
}

}  // namespace plumbline::machine
