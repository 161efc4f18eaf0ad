// The C interface and its handles (c_handles), called as C does.
#include <cmath>
#include <cstring>
#include <string>

#include <catch2/catch.hpp>
#include <plumbline/plumbline.h>
#include <plumbline/plumbline.hpp>

#include "support/scratch.hpp"

namespace {

using plumbline::testing::source_file;

constexpr const char* kSmallPart = "G0 X0 Y0 Z0 A0 B0 C0\nG1 X20 A5 F500\nM2\n";

struct Handles {
  plumbline_context* context = plumbline_context_new();
  plumbline_options* options = plumbline_options_new();
  plumbline_model* model = nullptr;
  plumbline_result* result = nullptr;

  Handles() {
    const std::string path = source_file("models/pm600-like.toml");
    const plumbline_input file{path.c_str(), nullptr, 0};
    REQUIRE(plumbline_model_read(context, &file, &model) == PLUMBLINE_DONE);
    set("work-offset", "G54=0,0,-1008,0,0,0");
  }
  ~Handles() {
    next();
    plumbline_model_free(model);
    plumbline_options_free(options);
    plumbline_context_free(context);
  }
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;

  void set(const char* name, const char* value) {
    REQUIRE(plumbline_options_set(context, options, name, value) == PLUMBLINE_DONE);
  }
  /// Where the next result goes; the last one is freed.
  plumbline_result** next() {
    plumbline_result_free(result);
    result = nullptr;
    return &result;
  }
  std::string text(int part) const {
    std::size_t size = 0;
    const char* const bytes = plumbline_result_text(result, part, &size);
    CHECK(std::strlen(bytes) == size);
    return {bytes, size};
  }
  std::string error() const { return plumbline_error(context); }
};

plumbline_input text_input(const char* bytes) { return {"part.ngc", bytes, std::strlen(bytes)}; }

}  // namespace

TEST_CASE("the C interface says what the C++ interface says") {
  namespace api = plumbline::api;
  Handles h;
  h.set("undo", "on");
  const plumbline_input part = text_input(kSmallPart);
  REQUIRE(plumbline_compensate(h.context, &part, h.model, h.options, nullptr, h.next()) == PLUMBLINE_DONE);
  const std::string corrected = h.text(PLUMBLINE_OUTPUT);
  const std::string undo = h.text(PLUMBLINE_UNDO);
  std::string same;
  const api::Result done = api::compensate(
      api::Input::text(kSmallPart, "part.ngc"), api::Model(api::Input::file(source_file("models/pm600-like.toml"))),
      api::Options().set("work-offset", "G54=0,0,-1008,0,0,0"), api::Output::text(same));
  CHECK(corrected == same);
  CHECK(h.text(PLUMBLINE_WORDS) == done.words());
  double moves = 0;
  CHECK(plumbline_result_number(h.context, h.result, "moves", &moves) == PLUMBLINE_DONE);
  CHECK(moves == 2);
  const plumbline_input whole{"o.ngc", corrected.c_str(), corrected.size()};
  const plumbline_input log{"o.ngc.undo", undo.c_str(), undo.size()};
  REQUIRE(plumbline_restore(h.context, &whole, &log, nullptr, h.next()) == PLUMBLINE_DONE);
  CHECK(h.text(PLUMBLINE_OUTPUT) == kSmallPart);
  CHECK(plumbline_diff(h.context, &part, &whole, nullptr, nullptr, h.next()) == PLUMBLINE_FOUND);
}

TEST_CASE("tables come as numbers") {
  Handles h;
  const plumbline_pose poses[] = {{0, 0, -1008, 0, 0, 0}, {10, 0, -1000, 5, 0, 0}};
  REQUIRE(plumbline_error_table(h.context, poses, 2, h.model, h.next()) == PLUMBLINE_DONE);
  CHECK(plumbline_result_rows(h.result) == 2);
  const std::size_t columns = plumbline_result_columns(h.result);
  REQUIRE(columns > 30);  // with what is expected at the tip
  CHECK(plumbline_result_column(h.result, 24) == std::string("dx_um"));
  CHECK(plumbline_result_column(h.result, 30) == std::string("expected_um"));
  CHECK(plumbline_result_column(h.result, columns) == nullptr);
  const double* const first = plumbline_result_values(h.result);
  CHECK(std::hypot(first[24], first[25], first[26]) == Approx(15.379).epsilon(1e-3));
  CHECK(first[columns] == 10);  // the second pose
  const plumbline_input part = text_input(kSmallPart);
  REQUIRE(plumbline_simulate_table(h.context, &part, h.model, h.options, h.next()) == PLUMBLINE_DONE);
  const std::size_t points = plumbline_result_rows(h.result);
  REQUIRE(plumbline_simulate(h.context, &part, h.model, h.options, nullptr, h.next()) == PLUMBLINE_DONE);
  double of_csv = 0;
  CHECK(plumbline_result_number(h.context, h.result, "points", &of_csv) == PLUMBLINE_DONE);
  CHECK(of_csv == static_cast<double>(points));
}

TEST_CASE("what is wrong is a code and a diagnostic, and the next call forgets it") {
  Handles h;
  const plumbline_input bad = text_input("G0 X0 Y0 Z0 A0 B0 C0\nG1 A60 F100\n");
  CHECK(plumbline_compensate(h.context, &bad, h.model, h.options, nullptr, h.next()) == PLUMBLINE_REFUSED);
  CHECK(h.result == nullptr);
  CHECK(h.error().starts_with("{\"code\":\"limit-tilt\""));
  CHECK(h.error().find("\"file\":\"part.ngc\",\"line\":2") != std::string::npos);
  CHECK(plumbline_check(h.context, &bad, h.model, h.options, h.next()) == PLUMBLINE_FOUND);
  CHECK(h.error().empty());
  CHECK(plumbline_compensate(h.context, nullptr, h.model, h.options, nullptr, h.next()) == PLUMBLINE_WRONG_USAGE);
  CHECK(h.error().find("program is NULL") != std::string::npos);
  CHECK(plumbline_compensate(h.context, &bad, nullptr, h.options, nullptr, h.next()) == PLUMBLINE_WRONG_USAGE);
  CHECK(plumbline_check(h.context, &bad, h.model, h.options, nullptr) == PLUMBLINE_WRONG_USAGE);
  CHECK(plumbline_check(nullptr, &bad, h.model, h.options, h.next()) == PLUMBLINE_WRONG_USAGE);
  h.set("no-such-option", "1");
  CHECK(plumbline_check(h.context, &bad, h.model, h.options, h.next()) == PLUMBLINE_WRONG_USAGE);
  CHECK(h.error().find("there is no option no-such-option") != std::string::npos);
  CHECK(plumbline_explain(h.context, "no-such-code", h.next()) == PLUMBLINE_REFUSED);
  CHECK(plumbline_explain(h.context, nullptr, h.next()) == PLUMBLINE_DONE);
  CHECK(h.text(PLUMBLINE_WORDS).find("limit-tilt") != std::string::npos);
}

TEST_CASE("progress stops the work, and freeing nothing does nothing") {
  Handles h;
  std::string program = "G0 X0 Y0 Z0 A0 B0 C0\nF500\n";
  for (int i = 0; i < 9000; ++i) program += i % 2 == 0 ? "G1 X1\n" : "G1 X0\n";
  const plumbline_input part = text_input(program.c_str());
  int calls = 0;
  plumbline_set_progress(
      h.context, [](void* data, uint64_t, uint64_t) { return ++*static_cast<int*>(data); }, &calls);
  CHECK(plumbline_compensate(h.context, &part, h.model, h.options, nullptr, h.next()) == PLUMBLINE_STOPPED);
  CHECK(calls == 1);
  plumbline_set_progress(h.context, nullptr, nullptr);
  CHECK(plumbline_check(h.context, &part, h.model, h.options, h.next()) == PLUMBLINE_DONE);
  plumbline_model_free(nullptr);
  plumbline_options_free(nullptr);
  plumbline_result_free(nullptr);
  plumbline_context_free(nullptr);
  CHECK(plumbline_result_rows(nullptr) == 0);
  CHECK(plumbline_version() == plumbline::api::version());
}
