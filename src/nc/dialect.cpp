#include "nc/dialect.hpp"

#include <array>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "nc/codes.hpp"
#include "nc/dialect_table.hpp"

namespace plumbline::embedded {
extern const std::string_view linuxcnc_toml;
}

namespace plumbline::nc {
namespace {

const CodeRow* row_of(const std::vector<CodeRow>& rows, const std::vector<std::int16_t>& places, int code) {
  if (code < 0 || static_cast<std::size_t>(code) >= places.size()) return nullptr;
  const std::int16_t at = places[static_cast<std::size_t>(code)];
  return at < 0 ? nullptr : &rows[static_cast<std::size_t>(at)];
}

}  // namespace

const CodeRow* Dialect::g_code(int times_ten) const { return row_of(g_codes, g_index, times_ten); }
const CodeRow* Dialect::m_code(int times_ten) const { return row_of(m_codes, m_index, times_ten); }

std::span<const std::string_view> dialect_names() {
  static constexpr std::array<std::string_view, 1> kNames{"linuxcnc"};
  return kNames;
}

const Dialect& dialect(std::string_view name) {
  if (name == "linuxcnc") {
    static const Dialect linuxcnc = read_dialect("grammar/linuxcnc.toml", embedded::linuxcnc_toml);
    return linuxcnc;
  }
  refuse(codes::kUnknownDialect, fmt::format("no dialect is named '{}'", name),
         fmt::format("there are: {}", fmt::join(dialect_names(), ", ")));
}

}  // namespace plumbline::nc
