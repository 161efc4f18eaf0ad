#include "cli/application/version_text.hpp"

#include <string_view>

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <fmt/format.h>

#include "base/version.hpp"
#include "compensate/exact/pose_batch.hpp"

namespace plumbline::cli {

namespace {

#ifdef PLUMBLINE_X86_64_UNITS
constexpr std::string_view kUnits = ", x86-64-v2, x86-64-v3, x86-64-v4";
#else
constexpr std::string_view kUnits;
#endif

}  // namespace

std::string version_text() {
  const bool optimised =
#ifdef __OPTIMIZE__
      true;
#else
      false;
#endif
  const std::string eigen = fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
  const std::string formatting =
      fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100);
  return fmt::format(
      "plumbline {}\n"
      "compiler      " PLUMBLINE_COMPILER
      ", C++{}\n"
      "build         " PLUMBLINE_BUILD
      ", {}\n"
      "system        " PLUMBLINE_SYSTEM
      "\n"
      "instructions  any processor{}; here: {}\n"
      "libraries     Eigen {}, fmt {}, CLI11 " CLI11_VERSION,
      version(), __cplusplus / 100 % 100, optimised ? "optimised" : "not optimised", kUnits,
      compensate::exact::instruction_sets().back().name, eigen, formatting);
}

}  // namespace plumbline::cli
