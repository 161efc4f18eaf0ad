#include "jobs/measured/joined.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "base/files/files.hpp"
#include "base/text/hash.hpp"
#include "base/units.hpp"
#include "jobs/dataset_files.hpp"
#include "jobs/diagnose.hpp"
#include "report/measured/datasets_text.hpp"
#include "report/measured/diagnosis_text.hpp"

using namespace plumbline;
using namespace plumbline::testing;

namespace {

const std::string kHead = "plumbline = \"dataset 1\"\nmachine = \"pm600-like\"\n";

// A dataset of its own folder: its head, and a run of each of those names. Tables of different names differ.
std::string dataset(const Scratch& scratch, const std::string& folder, const std::string& head,
                    const std::vector<std::string>& names) {
  std::filesystem::create_directories(scratch.path(folder));
  std::string text = head;
  for (const std::string& name : names) {
    text = run_text(name, "ccw", text);
    std::string table = "angle_deg,radial_um\n";
    for (int i = 0; i < 12; ++i) table += fmt::format("{},{}\n", 30 * i, fnv1a(folder + name) % 97 + i % 5);
    scratch.file(folder + "/" + name + ".csv", table);
  }
  return scratch.file(folder + "/dataset.toml", text);
}

std::vector<std::string> ids_of(const jobs::JoinedData& joined) {
  std::vector<std::string> ids;
  for (const measure::Run& run : joined.dataset.runs) ids.push_back(run.id);
  return ids;
}

// Some runs of tests/blind/open-01, in a folder of their own.
std::string part_of_blind(const Scratch& scratch, const std::string& folder, std::size_t from, std::size_t to) {
  const std::filesystem::path whole = source_file("tests/blind/open-01/data");
  const std::string text = read_text((whole / "dataset.toml").generic_string());
  std::filesystem::create_directories(scratch.path(folder));
  const std::string mark = "\n[[run]]";
  std::string part = text.substr(0, text.find(mark));
  std::size_t number = 0;
  for (std::size_t at = text.find(mark); at != std::string::npos; ++number) {
    const std::size_t next = text.find(mark, at + 1);
    if (number >= from && number < to) part += text.substr(at, next - at);
    at = next;
  }
  for (const auto& entry : std::filesystem::directory_iterator(whole)) {
    std::filesystem::copy_file(entry.path(), std::filesystem::path(scratch.path(folder)) / entry.path().filename());
  }
  return scratch.file(folder + "/dataset.toml", part + "\n");
}

}  // namespace

TEST_CASE("two halves of a dataset say what the whole says") {
  const Scratch scratch;
  const std::string model = source_file("tests/blind/open-01/base.toml");
  jobs::DiagnoseJob whole{model, source_file("tests/blind/open-01/data/dataset.toml"), {}, 1};
  jobs::DiagnoseJob halves{model, part_of_blind(scratch, "first", 0, 13), {}, 1};
  halves.with = {part_of_blind(scratch, "second", 13, 26)};
  const jobs::DiagnoseResult of_whole = jobs::diagnose(whole);
  const jobs::DiagnoseResult of_halves = jobs::diagnose(halves);
  CHECK(report::diagnosis_json(of_halves.diagnosis, {}) == report::diagnosis_json(of_whole.diagnosis, {}));
  REQUIRE(of_halves.measured.size() == 2);
  CHECK(of_halves.measured[1].path == halves.with[0]);
  CHECK(of_halves.measured[1].count == 13);
  CHECK(of_halves.measured[0].hash != of_halves.measured[1].hash);
  CHECK(report::diagnosis_json(of_halves.diagnosis, of_halves.measured).find(to_hex(of_halves.measured[1].hash)) !=
        std::string::npos);
  // the other way round the runs come in another order, and the verdict stays
  std::swap(halves.dataset, halves.with[0]);
  const jobs::DiagnoseResult turned = jobs::diagnose(halves);
  CHECK(turned.diagnosis.verdict == of_whole.diagnosis.verdict);
  CHECK(turned.diagnosis.confidence_set == of_whole.diagnosis.confidence_set);
}

TEST_CASE("a run whose id is taken gets the number of its dataset") {
  const Scratch scratch;
  const std::string first = dataset(scratch, "first", kHead, {"01", "02"});
  const std::string second = dataset(scratch, "second", kHead, {"02", "03", "02@2"});
  const std::string third = dataset(scratch, "third", kHead, {"02", "04"});
  const jobs::JoinedData joined = jobs::read_joined(first, {second, third});
  CHECK(ids_of(joined) == std::vector<std::string>{"01", "02", "02@2@2", "03", "02@2", "02@3", "04"});
  CHECK(joined.files[0].renamed.empty());
  CHECK(report::renamed_text(joined.files) == "note: ids of " + second +
                                                  " that an earlier dataset has: 02 is 02@2@2\n" + "note: ids of " +
                                                  third + " that an earlier dataset has: 02 is 02@3\n");
  CHECK(ids_of(jobs::read_joined(first, {})) == std::vector<std::string>{"01", "02"});
}

TEST_CASE("datasets that contradict each other are refused where they do") {
  const Scratch scratch;
  const auto with = [&](const std::string& head) { return dataset(scratch, "second", head, {"03"}); };
  const std::string serial = "[protocol]\nserial = \"0042\"\ninstrument = \"QC20, 1234\"\n";
  const std::string sigmas = "[instrument]\nbar_sigma_um = 0.5\ntorque_sigma_Nm = 0.05\n";
  const std::string first = dataset(scratch, "first", kHead + serial + sigmas, {"01"});
  struct Case {
    std::string head, code, key;
    std::size_t line, line_there;
  };
  const std::vector<Case> cases{
      {"plumbline = \"dataset 1\"\nmachine = \"pm700\"\n", "dataset-other-machine", "machine", 2, 2},
      {kHead + "[protocol]\nserial = \"0043\"\n", "dataset-other-machine", "serial", 4, 4},
      {kHead + "[protocol]\ninstrument = \"QC20, 1235\"\n", "dataset-other-instrument", "instrument", 4, 5},
      {kHead + "[instrument]\nbar_sigma_um = 0.6\n", "dataset-other-instrument", "bar_sigma_um", 4, 7},
      {kHead + "[instrument]\ntorque_sigma_Nm = 0.06\n", "dataset-other-instrument", "torque_sigma_Nm", 4, 8}};
  for (const Case& bad : cases) {
    const std::string second = with(bad.head);
    const Diagnostic d = refusal_of([&] { jobs::read_joined(first, {second}); });
    CHECK(d.code == bad.code);
    CHECK(d.place.file == second);
    CHECK(d.place.line == bad.line);
    CHECK(d.place.column > 1);
    CHECK(d.message.starts_with(bad.key + " is "));
    CHECK(d.message.find(fmt::format("{}, line {}", first, bad.line_there)) != std::string::npos);
  }
  // what one of them does not say contradicts nothing, and what it says of the instrument holds for both
  const jobs::JoinedData joined = jobs::read_joined(with("plumbline = \"dataset 1\"\n"), {first});
  CHECK(joined.dataset.runs.size() == 2);
  CHECK(*joined.dataset.instrument.bar_sigma == Approx(0.5 * kUm));
  CHECK(*joined.dataset.instrument.torque_sigma == Approx(0.05));
  CHECK(joined.protocols[1].serial == "0042");
  // the third is held against the second, too
  const std::string third = dataset(scratch, "third", kHead + "[protocol]\nserial = \"0043\"\n", {"05"});
  CHECK(refusal_of([&] {
          jobs::read_joined(dataset(scratch, "plain", kHead, {"06"}), {first, third});
        }).code == "dataset-other-machine");
}

TEST_CASE("a dataset that is not there, or there twice, is refused") {
  const Scratch scratch;
  const std::string first = dataset(scratch, "first", kHead, {"01"});
  const Diagnostic missing = refusal_of([&] { jobs::read_joined(first, {scratch.path("none/dataset.toml")}); });
  CHECK(missing.code == "file-missing");
  CHECK(missing.place.file == scratch.path("none/dataset.toml"));
  const std::string copy = scratch.path("copy");
  std::filesystem::copy(scratch.path("first"), copy);
  for (const std::string& again : {first, copy + "/dataset.toml"}) {
    const Diagnostic twice = refusal_of([&] { jobs::read_joined(first, {again}); });
    CHECK(twice.code == "dataset-twice");
    CHECK(twice.place.file == again);
  }
}
