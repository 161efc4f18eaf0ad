// The C interface: each function calls the one of the C++ interface; exceptions become codes here.
#include <new>
#include <optional>

#include <plumbline/plumbline.h>
#include <plumbline/plumbline.hpp>

#include "api/c_handles.hpp"
#include "base/version.hpp"

namespace api = plumbline::api;
using api::c::into;
using api::c::kept;
using api::c::need;
using api::c::optional_model;
using api::c::optional_options;
using api::c::run;

extern "C" {

const char* plumbline_version(void) { return plumbline::version().data(); }

plumbline_context* plumbline_context_new(void) { return new (std::nothrow) plumbline_context; }
void plumbline_context_free(plumbline_context* context) { delete context; }
const char* plumbline_error(const plumbline_context* context) {
  return context == nullptr ? "" : context->error.c_str();
}

void plumbline_set_progress(plumbline_context* context, int (*progress)(void*, uint64_t, uint64_t), void* data) {
  if (context == nullptr) return;
  context->progress = {};
  if (progress == nullptr) return;
  context->progress = [progress, data](std::uint64_t done, std::uint64_t total) {
    if (progress(data, done, total) != 0) throw api::c::Stopped();
  };
}

int plumbline_model_read(plumbline_context* context, const plumbline_input* input, plumbline_model** model) {
  if (model != nullptr) *model = nullptr;
  return run(context, [&] {
    need(model, "model");
    const api::Model read(api::c::input_of(input, "input"));
    *model = new plumbline_model{read, read.name(), read.hash()};
    return PLUMBLINE_DONE;
  });
}

void plumbline_model_free(plumbline_model* model) { delete model; }
const char* plumbline_model_name(const plumbline_model* model) { return model == nullptr ? "" : model->name.c_str(); }
const char* plumbline_model_hash(const plumbline_model* model) { return model == nullptr ? "" : model->hash.c_str(); }

plumbline_options* plumbline_options_new(void) { return new (std::nothrow) plumbline_options; }
void plumbline_options_free(plumbline_options* options) { delete options; }

int plumbline_options_set(plumbline_context* context, plumbline_options* options, const char* name, const char* value) {
  return run(context, [&] {
    need(options, "options")->options.set(need(name, "name"), std::string(need(value, "value")));
    return PLUMBLINE_DONE;
  });
}

int plumbline_options_set_input(plumbline_context* context, plumbline_options* options, const char* name,
                                const plumbline_input* input) {
  return run(context, [&] {
    need(options, "options")->options.set(need(name, "name"), api::c::input_of(input, "input"));
    return PLUMBLINE_DONE;
  });
}

void plumbline_result_free(plumbline_result* result) { delete result; }

const char* plumbline_result_text(const plumbline_result* result, int part, size_t* size) {
  static const std::string none;
  const bool has = result != nullptr && part >= 0 && part < api::c::kParts;
  const std::string& text = has ? result->parts.at(static_cast<std::size_t>(part)) : none;
  if (size != nullptr) *size = text.size();
  return text.c_str();
}

int plumbline_result_number(plumbline_context* context, const plumbline_result* result, const char* path,
                            double* number) {
  return run(context, [&] {
    need(number, "number");
    const std::optional<api::Result>& found = need(result, "result")->result;
    if (!found) api::c::wrong("this result has no numbers but its table");
    *number = found->number(need(path, "path"));
    return PLUMBLINE_DONE;
  });
}

size_t plumbline_result_rows(const plumbline_result* result) { return result == nullptr ? 0 : result->table.rows(); }
size_t plumbline_result_columns(const plumbline_result* result) {
  return result == nullptr ? 0 : result->table.columns.size();
}
const char* plumbline_result_column(const plumbline_result* result, size_t column) {
  return column < plumbline_result_columns(result) ? result->table.columns[column].c_str() : nullptr;
}
const double* plumbline_result_values(const plumbline_result* result) {
  return result == nullptr ? nullptr : result->table.values.data();
}

int plumbline_compensate(plumbline_context* context, const plumbline_input* program, const plumbline_model* model,
                         const plumbline_options* options, const char* output, plumbline_result** result) {
  return into(context, result, [&](plumbline_result& made) {
    const api::Options& given = optional_options(options);
    const bool undo = output == nullptr && api::c::is_on(given, "undo");
    return kept(made,
                api::compensate(api::c::input_of(program, "program"), optional_model(model), given, made.output(output),
                                undo ? made.undo() : api::Output::nothing(), context->progress));
  });
}

int plumbline_check(plumbline_context* context, const plumbline_input* program, const plumbline_model* model,
                    const plumbline_options* options, plumbline_result** result) {
  return into(context, result, [&](plumbline_result& made) {
    return kept(made, api::check(api::c::input_of(program, "program"), optional_model(model), optional_options(options),
                                 context->progress));
  });
}

int plumbline_diff(plumbline_context* context, const plumbline_input* a, const plumbline_input* b,
                   const plumbline_model* model, const plumbline_options* options, plumbline_result** result) {
  return into(context, result, [&](plumbline_result& made) {
    return kept(made, api::diff(api::c::input_of(a, "a"), api::c::input_of(b, "b"), optional_options(options),
                                optional_model(model), context->progress));
  });
}

int plumbline_trace(plumbline_context* context, const plumbline_input* program, const plumbline_model* model,
                    const plumbline_options* options, const char* output, plumbline_result** result) {
  return into(context, result, [&](plumbline_result& made) {
    api::trace(api::c::input_of(program, "program"), optional_options(options), made.output(output),
               optional_model(model), context->progress);
    return PLUMBLINE_DONE;
  });
}

int plumbline_restore(plumbline_context* context, const plumbline_input* program, const plumbline_input* undo,
                      const char* output, plumbline_result** result) {
  return into(context, result, [&](plumbline_result& made) {
    api::restore(api::c::input_of(program, "program"), api::c::input_of(undo, "undo"), made.output(output));
    return PLUMBLINE_DONE;
  });
}

int plumbline_simulate(plumbline_context* context, const plumbline_input* program, const plumbline_model* model,
                       const plumbline_options* options, const char* output, plumbline_result** result) {
  return into(context, result, [&](plumbline_result& made) {
    return kept(made, api::simulate(api::c::input_of(program, "program"), optional_model(model),
                                    optional_options(options), made.output(output), context->progress));
  });
}

int plumbline_simulate_table(plumbline_context* context, const plumbline_input* program, const plumbline_model* model,
                             const plumbline_options* options, plumbline_result** result) {
  return into(context, result, [&](plumbline_result& made) {
    made.table = api::simulate(api::c::input_of(program, "program"), optional_model(model), optional_options(options),
                               context->progress);
    api::c::keep_warnings(made, made.table.warnings);
    return PLUMBLINE_DONE;
  });
}

int plumbline_error_csv(plumbline_context* context, const plumbline_input* poses, const plumbline_model* model,
                        const char* output, plumbline_result** result) {
  return into(context, result, [&](plumbline_result& made) {
    return kept(made, api::error(api::c::input_of(poses, "poses"), optional_model(model), made.output(output)));
  });
}

int plumbline_error_table(plumbline_context* context, const plumbline_pose* poses, size_t count,
                          const plumbline_model* model, plumbline_result** result) {
  return into(context, result, [&](plumbline_result& made) {
    if (count > 0) need(poses, "poses");
    std::vector<api::Pose> all;
    all.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const plumbline_pose& one = poses[i];
      all.push_back({one.x, one.y, one.z, one.a, one.b, one.c});
    }
    made.table = api::error(all, optional_model(model));
    api::c::keep_warnings(made, made.table.warnings);
    return PLUMBLINE_DONE;
  });
}

int plumbline_identify(plumbline_context* context, const plumbline_model* model, const char* dataset,
                       const plumbline_options* options, plumbline_result** result) {
  return into(context, result, [&](plumbline_result& made) {
    return kept(made, api::identify(optional_model(model), need(dataset, "dataset"), optional_options(options)));
  });
}

int plumbline_calibrate(plumbline_context* context, const plumbline_model* model, const char* dataset,
                        const plumbline_options* options, plumbline_result** result) {
  return into(context, result, [&](plumbline_result& made) {
    return kept(made,
                api::calibrate(optional_model(model), dataset == nullptr ? "" : dataset, optional_options(options)));
  });
}

int plumbline_diagnose(plumbline_context* context, const plumbline_model* model, const char* dataset,
                       const plumbline_options* options, plumbline_result** result) {
  return into(context, result, [&](plumbline_result& made) {
    return kept(made, api::diagnose(optional_model(model), need(dataset, "dataset"), optional_options(options)));
  });
}

int plumbline_compare(plumbline_context* context, const plumbline_model* model, const char* dataset,
                      const plumbline_options* options, plumbline_result** result) {
  return into(context, result, [&](plumbline_result& made) {
    return kept(made, api::compare(optional_model(model), need(dataset, "dataset"), optional_options(options)));
  });
}

int plumbline_new_model(plumbline_context* context, const plumbline_options* options, plumbline_result** result) {
  return into(context, result,
              [&](plumbline_result& made) { return kept(made, api::new_model(optional_options(options))); });
}

int plumbline_explain(plumbline_context* context, const char* code, plumbline_result** result) {
  return into(context, result, [&](plumbline_result& made) {
    made.parts[PLUMBLINE_WORDS] = code == nullptr ? api::explain() : api::explain(code);
    return PLUMBLINE_DONE;
  });
}

}  // extern "C"
