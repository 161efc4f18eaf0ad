// The generator of each dialect.
#pragma once

#include <cstdint>
#include <memory>

#include "drawn/writer.hpp"

namespace plumbline::drawn {

std::unique_ptr<Writer> linuxcnc_writer(std::uint64_t seed, const Scene& scene);
std::unique_ptr<Writer> fanuc_writer(std::uint64_t seed, const Scene& scene);
std::unique_ptr<Writer> okuma_writer(std::uint64_t seed, const Scene& scene);
std::unique_ptr<Writer> siemens_writer(std::uint64_t seed, const Scene& scene);

}  // namespace plumbline::drawn
