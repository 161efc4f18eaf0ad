#include "settings/resolved.hpp"

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <optional>

#include <catch2/catch.hpp>
#include <sys/stat.h>

#include "support/scratch.hpp"

using namespace plumbline;
using settings::ResolvedSettings;
using settings::SettingsRequest;
using testing::Scratch;

namespace {

// A variable of the environment for the time of a test.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    if (const char* const old = std::getenv(name)) old_ = old;
    setenv(name, value.c_str(), 1);
  }
  ~Variable() { old_ ? setenv(name_, old_->c_str(), 1) : unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> old_;
};

// Nobody's own settings, and a folder for a program.
struct Shop {
  Shop() {
    std::filesystem::create_directories(scratch.path("jobs/a"));
    std::filesystem::create_directories(scratch.path("own/plumbline"));
  }
  void write(std::string_view name, const std::string& text) const {
    scratch.file(name, "plumbline = \"settings 1\"\n" + text);
  }
  SettingsRequest request() const { return {scratch.path("jobs/a/part.ngc"), {}, {}, false, {}}; }
  ResolvedSettings resolved() const { return settings::resolve_settings(request()); }

  Scratch scratch;
  Variable own{"XDG_CONFIG_HOME", scratch.path("own")};
  Variable named{"PLUMBLINE_SETTINGS", ""};
};

settings::StatedOption given(std::string_view name, std::string text) {
  return {settings::find_option(name), std::move(text), {}};
}

}  // namespace

TEST_CASE("the nearer settings file counts more, the command line most") {
  const Shop shop;
  shop.write("own/plumbline/plumbline.toml", "step_length = 4\nstep_angle = 4\ntime_tolerance = 0.04\nat_time = 4\n");
  shop.write("named.toml", "step_length = 3\nstep_angle = 3\ntime_tolerance = 0.03\n");
  shop.write("plumbline.toml", "step_length = 2\nstep_angle = 2\n");
  shop.write("jobs/a/plumbline.toml", "step_length = 1\n");
  const Variable named("PLUMBLINE_SETTINGS", shop.scratch.path("named.toml"));
  const ResolvedSettings found = shop.resolved();
  CHECK(found.options.compensation.step.length_mm == 1);
  CHECK(found.options.compensation.step.angle_deg == 2);
  CHECK(found.options.emit.time_tolerance == 0.03);
  CHECK(found.options.compensation.time_s == 4);
  CHECK(found.options.paths.settings_files ==
        std::vector{shop.scratch.path("jobs/a/plumbline.toml"), shop.scratch.path("plumbline.toml"),
                    shop.scratch.path("named.toml"), shop.scratch.path("own/plumbline/plumbline.toml")});
  SettingsRequest request = shop.request();
  request.given = {given("step-length", "0.5")};
  CHECK(settings::resolve_settings(request).options.compensation.step.length_mm == 0.5);
  request.without_files = true;
  CHECK(settings::resolve_settings(request).options.compensation.step.angle_deg == 0.1);
}

TEST_CASE("a settings file that is named takes the place of those in the folders") {
  const Shop shop;
  shop.write("jobs/a/plumbline.toml", "step_length = 1\n");
  shop.write("other.toml", "step_angle = 2\n");
  SettingsRequest request = shop.request();
  request.file = shop.scratch.path("other.toml");
  const ResolvedSettings found = settings::resolve_settings(request);
  CHECK(found.options.compensation.step.angle_deg == 2);
  CHECK(found.options.paths.settings_files == std::vector{request.file});
  request.file = shop.scratch.path("missing.toml");
  CHECK(testing::refusal_of([&] { settings::resolve_settings(request); }).code == "file-missing");
}

TEST_CASE("a settings file that is found in two ways is read once; standard input has no folder") {
  const Shop shop;
  shop.write("jobs/a/plumbline.toml", "step_length = 1\n");
  const Variable named("PLUMBLINE_SETTINGS", shop.scratch.path("jobs/../jobs/a/plumbline.toml"));
  CHECK(shop.resolved().options.paths.settings_files.size() == 1);
  const Variable none("PLUMBLINE_SETTINGS", "");
  CHECK(settings::settings_files("-", "").empty());
}

TEST_CASE("a machine's options count before those of every machine in the same file") {
  const Shop shop;
  shop.write(
      "plumbline.toml",
      "machine = \"hex-3\"\nstep_length = 2\nstep_angle = 2\npass = \"M428\"\n[machines.hex-3]\nstep_length = 3\n"
      "pass = [\"M1\", \"M2\"]\n[machines.hex-4]\nstep_length = 4\n");
  shop.write("jobs/a/plumbline.toml", "step_angle = 1\n");
  const ResolvedSettings third = shop.resolved();
  CHECK(third.options.machine == "hex-3");
  CHECK(third.machine_place.line == 2);
  CHECK(third.options.machines == std::vector<std::string>{"hex-3", "hex-4"});
  CHECK(third.options.compensation.step.length_mm == 3);
  CHECK(third.options.compensation.step.angle_deg == 1);
  CHECK(third.options.program.passed_m_codes == std::set{1, 2});
  SettingsRequest request = shop.request();
  request.machine = "hex-4";
  const ResolvedSettings fourth = settings::resolve_settings(request);
  CHECK(fourth.options.compensation.step.length_mm == 4);
  CHECK(fourth.options.program.passed_m_codes == std::set{428});
  CHECK(fourth.machine_place.file.empty());
}

TEST_CASE("a machine may be described here and offset there") {
  const Shop shop;
  shop.write("own/plumbline/plumbline.toml",
             "[machines.hex-3]\nmodel = \"hex-3.toml\"\n[machines.hex-3.work_offset]\nG54 = [0,0,1,0,0,0]\nG55 = "
             "[0,0,2,0,0,0]\n");
  shop.write("jobs/a/plumbline.toml", "machine = \"hex-3\"\n[work_offset]\nG54 = [0,0,3,0,0,0]\n");
  SettingsRequest request = shop.request();
  request.given = {given("work-offset", "G56=0,0,4,0,0,0")};
  const ResolvedSettings found = settings::resolve_settings(request);
  CHECK(found.options.paths.model.path() == shop.scratch.path("own/plumbline/hex-3.toml"));
  const auto z = [&](std::size_t system) { return found.options.program.work_offsets[system]->origin[Axis::Z]; };
  CHECK(z(0) == 3);
  CHECK(z(1) == 2);
  CHECK(z(2) == 4);
}

TEST_CASE("what a stronger setting contradicts is left out") {
  const Shop shop;
  shop.write("plumbline.toml", "step_length = 2\nfirst_order = true\n");
  shop.write("jobs/a/plumbline.toml", "tolerance = \"0.5um\"\n");
  const ResolvedSettings found = shop.resolved();
  REQUIRE(found.stated.size() == 1);
  CHECK(found.stated[0].row->name == "tolerance");
  CHECK(found.stated[0].place.line == 2);
}

TEST_CASE("a machine that nobody describes is refused") {
  const Shop shop;
  shop.write("jobs/a/plumbline.toml", "machine = \"hex3\"\n[machines.hex-3]\nstep_length = 3\n");
  const Diagnostic said = testing::refusal_of([&] { shop.resolved(); });
  CHECK(said.code == "settings-no-machine");
  CHECK(said.place.line == 2);
  CHECK(said.help == "did you mean hex-3? machines are hex-3");
  SettingsRequest request = shop.request();
  request.machine = "x";
  CHECK(testing::refusal_of([&] { settings::resolve_settings(request); }).help == "machines are hex-3");
}

TEST_CASE("what is named as a settings file and is none is refused, not passed over") {
  namespace fs = std::filesystem;
  struct Case {
    const char* what;
    const char* says;
    std::function<void(const std::string&)> make;
  };
  const Case cases[] = {
      {"dangling", "a link that leads to no file", [](const auto& path) { fs::create_symlink("gone.toml", path); }},
      {"loop", "a link that leads to no file", [](const auto& path) { fs::create_symlink(path, path); }},
      {"folder", "a folder", [](const auto& path) { fs::create_directories(path); }},
      {"link to a folder", "a folder", [](const auto& path) { fs::create_symlink(".", path); }},
      {"pipe", "a pipe", [](const auto& path) { REQUIRE(mkfifo(path.c_str(), 0600) == 0); }},
      {"device", "a device", [](const auto& path) { fs::create_symlink("/dev/null", path); }},
  };
  for (const char* const where : {"jobs/a/plumbline.toml", "jobs/plumbline.toml", "own/plumbline/plumbline.toml"}) {
    for (const Case& c : cases) {
      INFO(where << ": " << c.what);
      const Shop shop;
      c.make(shop.scratch.path(where));
      const Diagnostic refused = testing::refusal_of([&] { shop.resolved(); });
      CHECK(refused.code == "settings-no-file");
      CHECK(refused.place.file == shop.scratch.path(where));
      CHECK(refused.message.find(c.says) != std::string::npos);
      SettingsRequest without = shop.request();
      without.without_files = true;
      CHECK(settings::resolve_settings(without).options.paths.settings_files.empty());
    }
  }
}

TEST_CASE("a settings file is read through a link, and none is none") {
  const Shop shop;
  CHECK(shop.resolved().options.paths.settings_files.empty());
  shop.write("shop.toml", "step_angle = 2\n");
  std::filesystem::create_symlink(shop.scratch.path("shop.toml"), shop.scratch.path("jobs/plumbline.toml"));
  CHECK(shop.resolved().options.paths.settings_files.size() == 1);
}
