// What the handles of the C interface hold, and how its functions run.
#pragma once

#include <array>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>

#include <plumbline/plumbline.h>
#include <plumbline/plumbline.hpp>

namespace plumbline::api::c {

inline constexpr int kParts = 6;

/// What the caller's progress throws, for him.
struct Stopped {};

}  // namespace plumbline::api::c

struct plumbline_context {
  std::string error;
  plumbline::api::Progress progress;
};

struct plumbline_model {
  plumbline::api::Model model;
  std::string name, hash;
};

struct plumbline_options {
  plumbline::api::Options options;
};

struct plumbline_result {
  std::optional<plumbline::api::Result> result;
  std::array<std::string, plumbline::api::c::kParts> parts;
  plumbline::api::Table table;

  /// A path, or (null) a part of this.
  plumbline::api::Output output(const char* path) {
    return path == nullptr ? plumbline::api::Output::text(parts[PLUMBLINE_OUTPUT]) : plumbline::api::Output::file(path);
  }
  plumbline::api::Output undo() { return plumbline::api::Output::text(parts[PLUMBLINE_UNDO]); }
};

namespace plumbline::api::c {

/// Throws the Error that says what is wrong with a call.
[[noreturn]] void wrong(const std::string& message);

/// Throws it where an argument is null.
template <class Pointer>
Pointer need(Pointer pointer, const char* name) {
  if (pointer == nullptr) wrong(std::string(name) + " is NULL");
  return pointer;
}

Input input_of(const plumbline_input* input, const char* name);
Model optional_model(const plumbline_model* model);
const Options& optional_options(const plumbline_options* options);
bool is_on(const Options& options, const std::string& name);

/// Warnings as a part of the result, one JSON object a line.
void keep_warnings(plumbline_result& handle, const std::vector<Diagnostic>& warnings);

/// Takes the texts of what was found into the handle. Gives the code; throws the Error that refuses its model.
int kept(plumbline_result& handle, Result found);

/// To be called while an exception is handled: the code for it, its text kept in the context.
int code_of_exception(plumbline_context& context) noexcept;

/// Runs `work`, which gives a code.
template <class Work>
int run(plumbline_context* context, const Work& work) noexcept {
  if (context == nullptr) return PLUMBLINE_WRONG_USAGE;
  context->error.clear();
  try {
    return work();
  } catch (...) {
    return code_of_exception(*context);
  }
}

/// The same for work that fills a result, which is given even where its model alone is refused.
template <class Work>
int into(plumbline_context* context, plumbline_result** result, const Work& work) noexcept {
  if (result != nullptr) *result = nullptr;
  return run(context, [&] {
    need(result, "result");
    auto made = std::make_unique<plumbline_result>();
    try {
      const int code = work(*made);
      *result = made.release();
      return code;
    } catch (...) {
      if (made->result) *result = made.release();
      throw;
    }
  });
}

}  // namespace plumbline::api::c
