// Reading NC: parsing alone, with execution, and with every block written again, on simultaneous moves of six axes.
#include <cstdio>
#include <filesystem>
#include <random>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "base/files/files.hpp"
#include "nc/rewrite/emit.hpp"
#include "nc/sequence/program.hpp"
#include "nc/syntax/line_source.hpp"
#include "nc/syntax/parser.hpp"

using namespace plumbline;

namespace {

constexpr int kBlocks = 1'000'000;

// A program of kBlocks blocks `N.. G1 X Y Z A B C`, written once.
const std::string& program_file() {
  static const std::string path = [] {
    std::string name = (std::filesystem::temp_directory_path() / "plumbline-nc-bench.ngc").string();
    std::mt19937 random(20240501);
    std::uniform_real_distribution<double> step(-0.5, 0.5);
    double at[6] = {};
    std::string text = "G21 G90 G94\nG0 X0 Y0 Z0 A0 B0 C0\nG1 F1000\n";
    for (int i = 0; i < kBlocks; ++i) {
      for (double& value : at) value += step(random);
      fmt::format_to(std::back_inserter(text), "N{} G1 X{:.4f} Y{:.4f} Z{:.4f} A{:.5f} B{:.5f} C{:.5f}\n", 10 * i,
                     at[0], at[1], at[2], at[3], at[4], at[5]);
    }
    write_text(name, text + "M2\n");
    return name;
  }();
  return path;
}

void count_bytes(benchmark::State& state, const InputFile& file) {
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(file.size()));
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * kBlocks);
}

void parse(benchmark::State& state) {
  const InputFile file(program_file());
  for ([[maybe_unused]] auto _ : state) {
    nc::LineSource lines(file);
    nc::Parser parser(nc::dialect("linuxcnc"));
    nc::Block block;
    nc::Line line;
    std::size_t words = 0;
    while (lines.next(line)) {
      block.text = line.text;
      block.offset = line.place.offset;
      parser.parse(block);
      words += block.words.size();
    }
    benchmark::DoNotOptimize(words);
  }
  count_bytes(state, file);
}

void parse_and_interpret(benchmark::State& state) {
  const InputFile file(program_file());
  nc::ProgramSettings settings;
  settings.as_with_empty_tables = true;
  for ([[maybe_unused]] auto _ : state) {
    nc::Program program(file, nc::dialect("linuxcnc"), settings);
    std::size_t motions = 0;
    while (const nc::Step* step = program.next()) motions += step->motions.size();
    benchmark::DoNotOptimize(motions);
  }
  count_bytes(state, file);
}

// The first feed is corrected, so that all blocks after it are written one by one.
void parse_interpret_and_emit(benchmark::State& state) {
  const InputFile file(program_file());
  const nc::Dialect& dialect = nc::dialect("linuxcnc");
  nc::ProgramSettings settings;
  settings.as_with_empty_tables = true;
  std::uint64_t written = 0;
  for ([[maybe_unused]] auto _ : state) {
    nc::Program program(file, dialect, settings);
    OutputFile out(program_file() + ".out");  // its bytes are written, but never take that name
    nc::Emitter emitter(file, dialect, {}, out);
    while (const nc::Step* step = program.next()) {
      if (!emitter.changed() && !step->motions.empty() && step->motions.front().kind == nc::MotionKind::feed) {
        const nc::CorrectedPoint corrected{step->motions.front().to, {{0.01}}, 1};
        emitter.move(*step, std::span(&corrected, 1), AxisSet::all(), std::nullopt);
      } else {
        emitter.copy(*step);
      }
    }
    emitter.finish();
    written = out.size();
  }
  if (written < file.size()) state.SkipWithError("the program was not written");
  count_bytes(state, file);
}

// Each block gets six new numbers.
void parse_interpret_and_rewrite(benchmark::State& state) {
  const InputFile file(program_file());
  const nc::Dialect& dialect = nc::dialect("linuxcnc");
  nc::ProgramSettings settings;
  settings.as_with_empty_tables = true;
  const AxisWords shift{{0.012, -0.021, 0.033, 0.0043, -0.0051, 0.0064}};
  std::uint64_t changed = 0;
  for ([[maybe_unused]] auto _ : state) {
    nc::Program program(file, dialect, settings);
    OutputFile out(program_file() + ".out");  // its bytes are written, but never take that name
    nc::Emitter emitter(file, dialect, {}, out);
    changed = 0;
    while (const nc::Step* step = program.next()) {
      if (step->motions.size() == 1) {
        const nc::CorrectedPoint corrected{step->motions.front().to, shift, 1};
        changed += emitter.move(*step, std::span(&corrected, 1), AxisSet::all(), std::nullopt).changed ? 1 : 0;
      } else {
        emitter.copy(*step);
      }
    }
    emitter.finish();
  }
  if (changed < kBlocks) state.SkipWithError("some blocks were not changed");
  count_bytes(state, file);
}

BENCHMARK(parse)->Unit(benchmark::kMillisecond);
BENCHMARK(parse_and_interpret)->Unit(benchmark::kMillisecond);
BENCHMARK(parse_interpret_and_emit)->Unit(benchmark::kMillisecond);
BENCHMARK(parse_interpret_and_rewrite)->Unit(benchmark::kMillisecond);

}  // namespace
