#include "base/files/files_beside.hpp"

#include <thread>

#include <catch2/catch.hpp>

using namespace plumbline;
using Sought = FilesBeside::Sought;

TEST_CASE("files beside a program are noted for it alone, on any thread, each once") {
  FilesBeside::note("a", "before", "x");
  const FilesBeside a("a");
  const FilesBeside b("b");
  std::jthread([] {
    FilesBeside::note("a", "1000", "O1000.nc");
    FilesBeside::note("a", "1000", "O1000.nc");
  }).join();
  FilesBeside::note("b", "2000", "");
  FilesBeside::note("c", "3000", "O3000.nc");
  CHECK(a.files() == std::vector<Sought>{{"1000", "O1000.nc"}});
  CHECK(b.files() == std::vector<Sought>{{"2000", ""}});
}
