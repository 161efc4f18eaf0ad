#pragma once

#include <filesystem>
#include <string_view>

namespace plumbline {

/// The path that a name in UTF-8 means. A path made of `char` has letters of ASCII alone on Windows, for there GCC's
/// library reads them by the C locale.
inline std::filesystem::path path_of(std::string_view name) {
  return {std::u8string_view(reinterpret_cast<const char8_t*>(name.data()), name.size())};
}

}  // namespace plumbline
