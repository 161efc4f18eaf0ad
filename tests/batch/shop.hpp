// A folder of programs and what is asked for them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "batch/batch.hpp"
#include "support/scratch.hpp"

namespace plumbline::testing {

inline constexpr const char* kPart = "G21 G90 G94\nG0 X0 Y0 Z5 A0 B0 C0\nG1 Z0 F500\nG1 X20.5 Y10.25 A5 B-2.5 C1\nM2\n";

/// parts/a.nc, parts/inner/b.nc with other words, and notes.txt, which is no program.
struct Shop {
  Shop() {
    std::filesystem::create_directories(scratch.path("parts/inner"));
    scratch.file("parts/a.nc", kPart);
    scratch.file("parts/inner/b.nc", "G0 X0 Y0 Z0 A0 B0 C0\nG1 X7 F500\nM2\n");
    scratch.file("parts/notes.txt", "of the shop\n");
    scratch.file("parts/plumbline.toml", "plumbline = \"settings 1\"\nmodel = \"" +
                                             source_file("models/pm600-like.toml") +
                                             "\"\n[work_offset]\nG54 = [0, 0, -1008, 0, 0, 0]\n");
  }
  batch::Request request() const {
    batch::Request request;
    request.programs.folder = scratch.path("parts");
    request.programs.output = scratch.path("out");
    request.settings.file = scratch.path("parts/plumbline.toml");  // nobody's own
    return request;
  }
  /// The states of all items, in the order in which they are told.
  std::vector<jobs::BatchItem> run() const { return run(request()); }
  static std::vector<jobs::BatchItem> run(const batch::Request& request) {
    std::vector<jobs::BatchItem> items;
    batch::run(request, {[&](const jobs::BatchItem& item) { items.push_back(item); }, {}});
    return items;
  }

  Scratch scratch;
};

using State = jobs::BatchItem::State;

}  // namespace plumbline::testing
