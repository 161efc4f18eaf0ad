/* usage: outside MODEL PROGRAM OUTPUT: compensates a program that is in memory, by the C interface alone. */
#include <plumbline/plumbline.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char* text_of(const char* path, size_t* size) {
  FILE* file = fopen(path, "rb");
  char* text = malloc(1 << 20);
  if (file == NULL || text == NULL) exit(2);
  *size = fread(text, 1, 1 << 20, file);
  fclose(file);
  return text;
}

static void must(int code, const plumbline_context* context) {
  if (code == PLUMBLINE_DONE) return;
  fprintf(stderr, "code %d: %s\n", code, plumbline_error(context));
  exit(1);
}

int main(int argc, char** argv) {
  plumbline_context* context = plumbline_context_new();
  plumbline_options* options = plumbline_options_new();
  plumbline_model* model = NULL;
  plumbline_result* result = NULL;
  plumbline_input file = {NULL, NULL, 0};
  plumbline_input program = {NULL, NULL, 0};
  plumbline_input bad = {"bad.ngc", "G0 X1\nG99999\n", 13};
  const char* corrected;
  size_t size;
  double moves;
  FILE* out;
  int code;

  if (argc != 4) return 2;
  file.name = argv[1];
  must(plumbline_model_read(context, &file, &model), context);
  must(plumbline_options_set(context, options, "work-offset", "G54=0,0,-1008,0,0,0"), context);
  program.name = argv[2];
  program.text = text_of(argv[2], &program.size);
  must(plumbline_compensate(context, &program, model, options, NULL, &result), context);
  corrected = plumbline_result_text(result, PLUMBLINE_OUTPUT, &size);
  out = fopen(argv[3], "wb");
  if (out == NULL || fwrite(corrected, 1, size, out) != size || fclose(out) != 0) return 2;
  must(plumbline_result_number(context, result, "moves", &moves), context);
  printf("%s, interface %d: %g moves\n", plumbline_version(), PLUMBLINE_INTERFACE_C, moves);
  plumbline_result_free(result);

  code = plumbline_trace(context, &bad, NULL, NULL, NULL, &result);
  if (code != PLUMBLINE_REFUSED || result != NULL) return 1;
  if (strstr(plumbline_error(context), "\"line\":2") == NULL) return 1;
  printf("%.15s in line 2\n", strstr(plumbline_error(context), "nc-"));

  plumbline_model_free(model);
  plumbline_options_free(options);
  plumbline_context_free(context);
  free((void*)program.text);
  return 0;
}
