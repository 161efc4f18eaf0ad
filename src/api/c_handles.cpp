#include "api/c_handles.hpp"

#include <exception>
#include <stdexcept>

namespace plumbline::api::c {
namespace {

int code_of(Error::Kind kind) {
  switch (kind) {
    case Error::Kind::refused:
      return PLUMBLINE_REFUSED;
    case Error::Kind::wrong_usage:
      return PLUMBLINE_WRONG_USAGE;
    case Error::Kind::bug:
      break;
  }
  return PLUMBLINE_BUG;
}

// The code of what is being handled, and how it is told.
std::pair<int, std::string> told() {
  try {
    throw;
  } catch (const Error& error) {
    return {code_of(error.kind()), error.json()};
  } catch (const Stopped&) {
    return {PLUMBLINE_STOPPED, Error(Error::Kind::refused, {"stopped", "the caller stopped the work", "", {}}).json()};
  } catch (const std::bad_alloc&) {
    return {PLUMBLINE_NO_MEMORY, ""};
  } catch (const std::length_error&) {  // more than any memory
    return {PLUMBLINE_NO_MEMORY, ""};
  } catch (const std::exception& other) {
    return {PLUMBLINE_BUG, Error(Error::Kind::bug, {"internal-error", other.what(), "", {}}).json()};
  } catch (...) {
    return {PLUMBLINE_BUG, ""};
  }
}

}  // namespace

int code_of_exception(plumbline_context& context) noexcept {
  try {
    auto [code, text] = told();
    context.error = std::move(text);
    return code;
  } catch (...) {
    return PLUMBLINE_NO_MEMORY;
  }
}

void wrong(const std::string& message) { throw Error(Error::Kind::wrong_usage, {"usage-wrong", message, "", {}}); }

Input input_of(const plumbline_input* input, const char* name) {
  const char* const called = need(need(input, name)->name, "the name of an input");
  return input->text == nullptr ? Input::file(called) : Input::text(std::string(input->text, input->size), called);
}

Model optional_model(const plumbline_model* model) { return model == nullptr ? Model() : model->model; }

const Options& optional_options(const plumbline_options* options) {
  static const Options none;
  return options == nullptr ? none : options->options;
}

bool is_on(const Options& options, const std::string& name) {
  bool on = false;
  for (const Options::Given& given : options.given()) {
    if (given.name == name) on = given.value == "on";
  }
  return on;
}

void keep_warnings(plumbline_result& handle, const std::vector<Diagnostic>& warnings) {
  for (const Diagnostic& warning : warnings) {
    handle.parts[PLUMBLINE_WARNINGS] += Error(Error::Kind::refused, warning).json() + "\n";
  }
}

int kept(plumbline_result& handle, Result found) {
  handle.parts[PLUMBLINE_JSON] = found.json();
  handle.parts[PLUMBLINE_WORDS] = found.words();
  keep_warnings(handle, found.warnings());
  handle.result = found;
  handle.parts[PLUMBLINE_MODEL] = found.model();
  return found.found() ? PLUMBLINE_FOUND : PLUMBLINE_DONE;
}

}  // namespace plumbline::api::c
