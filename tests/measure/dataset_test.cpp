#include "measure/dataset.hpp"

#include <filesystem>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "measure/runs.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::measure;
using namespace plumbline::testing;

namespace {

struct Bad {
  std::string from, into;  // what replaces what in a good dataset
  std::string code;
  std::size_t line;
  std::string help;  // a part of it
};

std::string replaced(std::string text, const std::string& from, const std::string& into) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), into);
}

}  // namespace

TEST_CASE("a dataset is read in SI, what may be left out has its default") {
  const Scratch scratch;
  scratch.file("run.csv", table_text());
  const Dataset dataset = read_dataset(scratch.file("dataset.toml", dataset_text()));
  CHECK(dataset.machine == "pm600-like");
  REQUIRE(dataset.runs.size() == 1);
  const Run& run = dataset.runs.front();
  CHECK(run.id == "a");
  CHECK(run.centre_W == Vector3<double>(0, 0.1, -1.008));
  CHECK(run.radius == Approx(0.144));
  CHECK_FALSE(run.bar.has_value());
  CHECK(run.bar_length() == run.radius);
  CHECK(run.tilt[0] == Approx(-22 * kDeg));
  CHECK(run.feed == Approx(1.0 / 60));
  CHECK(run.start == 0);
  CHECK(run.payload_mass == 0);
  REQUIRE(run.samples() == 12);
  CHECK(run.angle[3] == Approx(90 * kDeg));
  CHECK(run.radial[3] == Approx(3.25e-6));
  CHECK_FALSE(run.has_torque());

  const Dataset other =
      parse_dataset(dataset_text("bar_mm = 150\nstart_s = 60\npayload_kg = 20\n"), "x", scratch.path(""));
  CHECK(other.runs[0].bar == 150 * kMm);
  CHECK(other.runs[0].start == 60);
  CHECK(other.runs[0].payload_mass == 20);
}

TEST_CASE("every flaw of a dataset is refused at its place with the way out") {
  const Scratch scratch;
  scratch.file("run.csv", table_text());
  const std::vector<Bad> cases{
      {"dataset 1", "machine 1", "dataset-marker", 1, "dataset 1"},
      {"plumbline =", "plumbing =", "dataset-marker", 1, "dataset 1"},
      {"machine =", "machines =", "dataset-unknown-key", 2, "did you mean `machine`"},
      {"radius_mm", "radius_nm", "dataset-unknown-key", 8, "did you mean `radius_mm`"},
      {"radius_mm = 144\n", "", "dataset-missing-key", 4, "add it"},
      {"radius_mm = 144", "radius_mm = 0.144", "dataset-out-of-range", 8, "if it was meant in m, write 144"},
      {"radius_mm = 144", "radius_mm = \"144\"", "dataset-wrong-type", 8, "radius"},
      {"radius_mm = 144", "radius_mm = nan", "dataset-out-of-range", 8, "1 to 2000 mm"},
      {"[0, 100, -1008]", "[0, 100]", "dataset-wrong-size", 7, "[x, y, z]"},
      {"[0, 100, -1008]", "[0, 100, -1008000]", "dataset-out-of-range", 7, "meant in um, write -1008"},
      {"\"ccw\"", "\"left\"", "dataset-direction", 10, R"("ccw" or "cw")"},
      {"feed_mm_min = 1000", "feed_mm_min = 0", "dataset-out-of-range", 11, "speed"},
      {"feed_mm_min = 1000", "feed_mm_min = 1000\nbar_mm = 100", "dataset-bar", 12, "distance of the two balls"},
      {"feed_mm_min = 1000", "feed_mm_min = 1000\npayload_kg = -1", "dataset-out-of-range", 12, "0 to 1000 kg"},
      {"run.csv", "none.csv", "dataset-file-missing", 6, "relative to the folder"},
      {"id = \"a\"", "id = \"\"", "dataset-out-of-range", 5, "name of the run"},
      {"[[run]]", "[run]", "dataset-wrong-type", 4, "double brackets"},
      {"[[run]]", "[[run", "toml-syntax", 4, ""},
  };
  for (const Bad& bad : cases) {
    INFO(bad.from << " -> " << bad.into);
    const std::string text = replaced(dataset_text(), bad.from, bad.into);
    const Diagnostic d = refusal_of([&] { parse_dataset(text, "dataset.toml", scratch.path("")); });
    INFO(to_text(d));
    CHECK(d.code == bad.code);
    CHECK(d.place.line == bad.line);
    CHECK(d.place.file == "dataset.toml");
    CHECK(d.help.find(bad.help) != std::string::npos);
  }
}

TEST_CASE("a table that is a folder, or packed, is refused as what it is") {
  const Scratch scratch;
  std::filesystem::create_directories(scratch.path("run.csv"));
  const auto refused = [&] {
    return refusal_of([&] { parse_dataset(dataset_text(), "dataset.toml", scratch.path("")); });
  };
  const Diagnostic folder = refused();
  CHECK(folder.code == "dataset-file-missing");
  CHECK(folder.message.ends_with("run.csv is a folder"));
  std::filesystem::remove(scratch.path("run.csv"));
  scratch.file("run.csv", "\x1F\x8B\x08 packed");
  const Diagnostic packed = refused();
  CHECK(packed.code == "file-not-text");
  CHECK(packed.message == "this is no text: it is packed with gzip");
  CHECK(packed.place.file == scratch.path("run.csv"));
}

TEST_CASE("a dataset without runs, and two runs of one id, are refused") {
  const Scratch scratch;
  scratch.file("run.csv", table_text());
  CHECK(refusal_of([&] { parse_dataset("plumbline = \"dataset 1\"\n", "d", ""); }).code == "dataset-no-runs");
  const std::string one = dataset_text();
  const Diagnostic d = refusal_of([&] { parse_dataset(one + one.substr(one.find("[[run]]")), "d", scratch.path("")); });
  CHECK(d.code == "dataset-same-id");
  CHECK(d.place.line == 13);
}

TEST_CASE("a dataset is written as it was read, and never over itself") {
  const Scratch scratch;
  const std::string text = "# my measurements\n" + dataset_text();
  scratch.file("run.csv", table_text());
  const Dataset dataset = read_dataset(scratch.file("dataset.toml", text));
  write_dataset(dataset, scratch.path("out"));
  CHECK(scratch.text("out/dataset.toml") == text);
  const Dataset again = read_dataset(scratch.path("out/dataset.toml"));
  CHECK(again.runs[0].radial == dataset.runs[0].radial);
  CHECK(again.runs[0].angle == dataset.runs[0].angle);
  CHECK(refusal_of([&] { write_dataset(dataset, scratch.path("")); }).code == "file-overwrites-input");

  Dataset outside = dataset;
  outside.runs[0].file = "../run.csv";
  CHECK(refusal_of([&] { write_dataset(outside, scratch.path("out")); }).code == "dataset-file-outside");
}

TEST_CASE("measured readings are written over no other dataset, nor over a table") {
  const Scratch scratch;
  scratch.file("run.csv", table_text());
  const Dataset dataset = read_dataset(scratch.file("dataset.toml", dataset_text()));
  std::filesystem::create_directories(scratch.path("measured"));
  std::filesystem::create_directories(scratch.path("table"));
  scratch.file("measured/dataset.toml", "# another one\n");
  scratch.file("table/run.csv", "measured\n");
  std::filesystem::create_directories(scratch.path("folder/run.csv"));
  for (const char* const folder : {"measured", "table", "folder"}) {
    INFO(folder);
    const Diagnostic d = refusal_of([&] { write_dataset(dataset, scratch.path(folder), Readings::measured); });
    CHECK(d.code == "dataset-folder-taken");
    CHECK(d.help.find("may have been measured") != std::string::npos);
  }
  CHECK(scratch.text("measured/dataset.toml") == "# another one\n");
  CHECK(scratch.text("table/run.csv") == "measured\n");
  CHECK_FALSE(scratch.has("table/dataset.toml"));
  write_dataset(dataset, scratch.path("free"), Readings::measured);
  write_dataset(dataset, scratch.path("free"), Readings::measured);  // the same once more
  scratch.file("free/run.csv", scratch.text("free/run.csv") + "# measured\n");
  CHECK(refusal_of([&] { write_dataset(dataset, scratch.path("free"), Readings::measured); }).code ==
        "dataset-folder-taken");
  write_dataset(dataset, scratch.path("free"));  // simulated: as it stood before
  CHECK(scratch.text("free/run.csv").find("# measured") == std::string::npos);
}

TEST_CASE("more runs than are judged together are refused before a table is read") {
  const Scratch scratch;
  const std::string text = dataset_text();
  const std::string run = text.substr(text.find("[[run]]"));
  std::string many = text;
  for (std::size_t i = 1; i <= kMostRuns; ++i) many.append("\n" + replaced(run, "\"a\"", fmt::format("\"a{}\"", i)));
  const Diagnostic d = refusal_of([&] { parse_dataset(many, "d", scratch.path("")); });
  CHECK(d.code == "dataset-too-many-runs");
  CHECK(d.message == "these are 201 runs");
  CHECK(refusal_of([] { check_run_count(kMostRuns, {}); }).code.empty());
}

TEST_CASE("a dataset reads no table outside of its folder") {
  const Scratch scratch;
  std::filesystem::create_directories(scratch.path("in/sub"));
  scratch.file("secret.csv", "name:password\n");
  scratch.file("in/sub/run.csv", table_text());
  for (const std::string& file : {std::string("../secret.csv"), scratch.path("secret.csv"), std::string("/etc/passwd"),
                                  std::string("sub/../../secret.csv"), std::string("../none.csv")}) {
    const std::string path = scratch.file("in/dataset.toml", replaced(dataset_text(), "run.csv", file));
    const Diagnostic d = refusal_of([&] { read_dataset(path); });
    INFO(to_text(d));
    CHECK(d.code == "dataset-file-outside");
    CHECK(d.place.file == path);
  }
  for (const char* const file : {"sub/run.csv", "./sub/run.csv", "sub/../sub/run.csv"}) {
    const std::string path = scratch.file("in/dataset.toml", replaced(dataset_text(), "run.csv", file));
    CHECK(read_dataset(path).runs.size() == 1);
  }
}

TEST_CASE("no table is written over another one, and nothing is written before that is clear") {
  const Scratch scratch;
  std::filesystem::create_directories(scratch.path("sub"));
  scratch.file("run.csv", table_text());
  scratch.file("sub/run.csv", table_text());
  std::string text = dataset_text();
  std::string second = replaced(text.substr(text.find("[[run]]")), "\"a\"", "\"b\"");
  const Dataset shared = read_dataset(scratch.file("shared.toml", text + second));
  CHECK(refusal_of([&] { write_dataset(shared, scratch.path("out")); }).code == "dataset-same-file");
  CHECK_FALSE(scratch.has("out"));
  const Dataset beside = read_dataset(scratch.file("beside.toml", text + replaced(second, "run.csv", "sub/run.csv")));
  const Diagnostic d = refusal_of([&] { write_dataset(beside, scratch.path("sub")); });
  CHECK(d.code == "file-overwrites-input");
  CHECK(d.message.find("run a") != std::string::npos);
  write_dataset(beside, scratch.path("out"));
  CHECK(scratch.has("out/sub/run.csv"));
}

TEST_CASE("a table that a plan wrote is no measurement; whatever else it holds is one") {
  const Scratch scratch;
  const std::string table = "angle_deg,radial_um\n0,1\n45,2\n90,3\n135,4\n180,5\n225,6\n270,7\n315,8\n";
  const auto run = [&](const std::string& id) {
    return fmt::format(
        "[[run]]\nid = \"{0}\"\nfile = \"{0}.csv\"\ncentre_mm = [0, 0, -1008]\nradius_mm = 144\ntilt_deg = "
        "[0, 0, 0]\ndirection = \"ccw\"\nfeed_mm_min = 1000\nplanned = \"{1}\"\n",
        id, measure::table_hash(table));
  };
  scratch.file("dataset.toml", "plumbline = \"dataset 1\"\n" + run("a") + run("b"));
  const auto refused = [&](const std::string& a, const std::string& b) {
    scratch.file("a.csv", a);
    scratch.file("b.csv", b);
    const measure::Dataset dataset = measure::read_dataset(scratch.path("dataset.toml"));
    return refusal_of([&] { measure::check_measured(dataset); });
  };
  std::string other = table;
  other.replace(other.find("90,3"), 4, "90,4");
  CHECK(refused(other, other).code.empty());
  CHECK(refused(table, table).code == "dataset-not-measured");
  CHECK(refused(table, table).message == "these readings are the plan's own: nothing was measured");
  CHECK(refused(other, table).message == "the readings of run b are the plan's own: nothing was measured");
}
