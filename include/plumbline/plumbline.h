/* plumbline for other languages, C99: version 1 of the interface. It does what plumbline.hpp does.
 *
 * Handles are opaque. Who gets one frees it with the function of its name; freeing NULL does nothing. Texts that
 * functions give belong to the handle that they were asked of, end with a null byte, and stay until that handle is
 * freed (those of a context: until its next call). Texts that functions take are copied. Names of files and texts are
 * UTF-8.
 *
 * Each function that can fail takes a context and returns a code; then plumbline_error() says what is wrong. No
 * exception leaves the library. A context, and a result, is for one thread at a time; models may be shared by threads.
 *
 * What stays while PLUMBLINE_INTERFACE_C is 1: all names, their meanings, the order of arguments and the values of the
 * enumerations. What may come: functions, values, options, keys of JSON, columns of tables. */
#ifndef PLUMBLINE_H
#define PLUMBLINE_H

#include <plumbline/export.h>
#include <stddef.h>
#include <stdint.h>

#define PLUMBLINE_INTERFACE_C 1

#ifdef __cplusplus
extern "C" {
#endif

typedef struct plumbline_context plumbline_context;
typedef struct plumbline_model plumbline_model;
typedef struct plumbline_options plumbline_options;
typedef struct plumbline_result plumbline_result;

/* What functions return. */
enum {
  PLUMBLINE_DONE = 0,
  PLUMBLINE_REFUSED = 1, /* the input; nothing was written */
  PLUMBLINE_WRONG_USAGE =
      2,                 /* the call: an option that there is not, a value that is none, NULL where nothing may be */
  PLUMBLINE_FOUND = 3,   /* done, and limits are broken, or programs differ */
  PLUMBLINE_STOPPED = 4, /* by the function of plumbline_set_progress; nothing was written */
  PLUMBLINE_NO_MEMORY = 5,
  PLUMBLINE_BUG = 6 /* of plumbline, or the system gave no more threads or files */
};

/* What is read: a file, or a text in memory. */
typedef struct plumbline_input {
  const char* name; /* the path of the file; of a text: what messages call it */
  const char* text; /* NULL: a file */
  size_t size;      /* of the text, bytes */
} plumbline_input;

/* A pose of the tool tip in the machine's base frame W: mm and deg. */
typedef struct plumbline_pose {
  double x, y, z, a, b, c;
} plumbline_pose;

/* Parts of a result. */
enum {
  PLUMBLINE_JSON = 0,     /* what the command writes with --json */
  PLUMBLINE_WORDS = 1,    /* what the command says to people */
  PLUMBLINE_WARNINGS = 2, /* diagnostics, one JSON object a line */
  PLUMBLINE_OUTPUT = 3,   /* what was to be written, where no path was named for it */
  PLUMBLINE_UNDO = 4,     /* of plumbline_compensate without a path, with the option "undo" */
  PLUMBLINE_MODEL = 5     /* the model file that identify, calibrate, diagnose and new_model leave */
};

/* "0.1.0" */
PLUMBLINE_API const char* plumbline_version(void);

/* NULL: there is no memory. */
PLUMBLINE_API plumbline_context* plumbline_context_new(void);
PLUMBLINE_API void plumbline_context_free(plumbline_context* context);
/* What went wrong in the last call, one JSON object: code, severity, message, help, file, line, column, length, text.
   Empty: nothing did. */
PLUMBLINE_API const char* plumbline_error(const plumbline_context* context);
/* From now on `progress` is called now and then with the work done and the whole of it; what it returns but 0 stops the
   work. NULL: nobody is called. */
PLUMBLINE_API void plumbline_set_progress(plumbline_context* context,
                                          int (*progress)(void* data, uint64_t done, uint64_t total), void* data);

PLUMBLINE_API int plumbline_model_read(plumbline_context* context, const plumbline_input* input,
                                       plumbline_model** model);
PLUMBLINE_API void plumbline_model_free(plumbline_model* model);
PLUMBLINE_API const char* plumbline_model_name(const plumbline_model* model);
/* Of its text: 16 hexadecimal digits. */
PLUMBLINE_API const char* plumbline_model_hash(const plumbline_model* model);

/* NULL: there is no memory. */
PLUMBLINE_API plumbline_options* plumbline_options_new(void);
PLUMBLINE_API void plumbline_options_free(plumbline_options* options);
/* Options by their long names on the command line, with the texts that stand there ("on" for a switch). Whether there
   is such an option says the function that takes it. */
PLUMBLINE_API int plumbline_options_set(plumbline_context* context, plumbline_options* options, const char* name,
                                        const char* value);
/* "tools", "variables" and "poses" need be no files. */
PLUMBLINE_API int plumbline_options_set_input(plumbline_context* context, plumbline_options* options, const char* name,
                                              const plumbline_input* input);

PLUMBLINE_API void plumbline_result_free(plumbline_result* result);
/* A part of it; empty if it has none. `size` may be NULL. */
PLUMBLINE_API const char* plumbline_result_text(const plumbline_result* result, int part, size_t* size);
/* A figure of PLUMBLINE_JSON by its path between slashes: "worst_residual_um/value". NaN if it is null. */
PLUMBLINE_API int plumbline_result_number(plumbline_context* context, const plumbline_result* result, const char* path,
                                          double* number);
/* Of a table: rows, columns, the name of a column (NULL if there is none), and its values, row after row. */
PLUMBLINE_API size_t plumbline_result_rows(const plumbline_result* result);
PLUMBLINE_API size_t plumbline_result_columns(const plumbline_result* result);
PLUMBLINE_API const char* plumbline_result_column(const plumbline_result* result, size_t column);
PLUMBLINE_API const double* plumbline_result_values(const plumbline_result* result);

/* The functions of plumbline.hpp. `model` and `options` may be NULL where there are none. `output` is a path; NULL: the
   result has the text as PLUMBLINE_OUTPUT. *result is set where something was found out, and is NULL otherwise. */
PLUMBLINE_API int plumbline_compensate(plumbline_context* context, const plumbline_input* program,
                                       const plumbline_model* model, const plumbline_options* options,
                                       const char* output, plumbline_result** result);
PLUMBLINE_API int plumbline_check(plumbline_context* context, const plumbline_input* program,
                                  const plumbline_model* model, const plumbline_options* options,
                                  plumbline_result** result);
PLUMBLINE_API int plumbline_diff(plumbline_context* context, const plumbline_input* a, const plumbline_input* b,
                                 const plumbline_model* model, const plumbline_options* options,
                                 plumbline_result** result);
PLUMBLINE_API int plumbline_trace(plumbline_context* context, const plumbline_input* program,
                                  const plumbline_model* model, const plumbline_options* options, const char* output,
                                  plumbline_result** result);
PLUMBLINE_API int plumbline_restore(plumbline_context* context, const plumbline_input* program,
                                    const plumbline_input* undo, const char* output, plumbline_result** result);
PLUMBLINE_API int plumbline_simulate(plumbline_context* context, const plumbline_input* program,
                                     const plumbline_model* model, const plumbline_options* options, const char* output,
                                     plumbline_result** result);
/* The same as a table of numbers. */
PLUMBLINE_API int plumbline_simulate_table(plumbline_context* context, const plumbline_input* program,
                                           const plumbline_model* model, const plumbline_options* options,
                                           plumbline_result** result);
/* The error at poses as CSV from CSV. */
PLUMBLINE_API int plumbline_error_csv(plumbline_context* context, const plumbline_input* poses,
                                      const plumbline_model* model, const char* output, plumbline_result** result);
/* The same as a table of numbers. */
PLUMBLINE_API int plumbline_error_table(plumbline_context* context, const plumbline_pose* poses, size_t count,
                                        const plumbline_model* model, plumbline_result** result);
/* `dataset` is the path of a dataset.toml. Where something speaks against the model that was found, identify, calibrate
   and diagnose refuse it, and the result has all but PLUMBLINE_MODEL. */
PLUMBLINE_API int plumbline_identify(plumbline_context* context, const plumbline_model* model, const char* dataset,
                                     const plumbline_options* options, plumbline_result** result);
/* `dataset` may be NULL where the option "poses" is set. */
PLUMBLINE_API int plumbline_calibrate(plumbline_context* context, const plumbline_model* model, const char* dataset,
                                      const plumbline_options* options, plumbline_result** result);
PLUMBLINE_API int plumbline_diagnose(plumbline_context* context, const plumbline_model* model, const char* dataset,
                                     const plumbline_options* options, plumbline_result** result);
PLUMBLINE_API int plumbline_compare(plumbline_context* context, const plumbline_model* model, const char* dataset,
                                    const plumbline_options* options, plumbline_result** result);
PLUMBLINE_API int plumbline_new_model(plumbline_context* context, const plumbline_options* options,
                                      plumbline_result** result);
/* The page of a code, as PLUMBLINE_WORDS; NULL: all codes, a line each. */
PLUMBLINE_API int plumbline_explain(plumbline_context* context, const char* code, plumbline_result** result);

#ifdef __cplusplus
}
#endif

#endif
