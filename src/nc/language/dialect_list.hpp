// The tables that are compiled in: CMakeLists.txt beside this lists them.
#pragma once

#include <span>
#include <string_view>

namespace plumbline::nc {

struct EmbeddedTable {
  std::string_view name;           // of the dialect
  const std::string_view* packed;  // grammar/<name>.toml: packed_table.hpp
};

/// At least one.
std::span<const EmbeddedTable> embedded_tables();

}  // namespace plumbline::nc
