# Options that every target of plumbline is compiled with.
add_library(plumbline_options INTERFACE)
target_compile_features(plumbline_options INTERFACE cxx_std_20)
target_include_directories(plumbline_options INTERFACE ${PROJECT_SOURCE_DIR}/src)
target_compile_options(plumbline_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Wimplicit-fallthrough
  -Wno-missing-field-initializers  # Options{.tolerance = ...} leaves the others at their defaults
  $<$<CONFIG:Release>:-fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=>  # what is built does not tell where, and is the same anywhere
  $<$<BOOL:${PLUMBLINE_WARNINGS_AS_ERRORS}>:-Werror>)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
  # For processors in general GCC copies a struct of some hundred bytes by rep movs, which takes a hundred cycles to begin.
  target_compile_options(plumbline_options INTERFACE -mtune=skylake)
endif()
add_library(plumbline_link_options INTERFACE)
if(PLUMBLINE_SANITIZE)
  target_compile_options(plumbline_options INTERFACE -fsanitize=${PLUMBLINE_SANITIZE} -fno-sanitize-recover=all
    -fno-omit-frame-pointer $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)  # GCC 12 takes sanitised std::function for uninitialised
  target_link_options(plumbline_link_options INTERFACE -fsanitize=${PLUMBLINE_SANITIZE})
endif()
if(PLUMBLINE_FUZZER)  # float conversions of anything that a file may say are undefined where they do not fit
  target_compile_options(plumbline_options INTERFACE -fsanitize=fuzzer-no-link,float-cast-overflow)
  target_link_options(plumbline_link_options INTERFACE -fsanitize=float-cast-overflow)
endif()
target_link_libraries(plumbline_options INTERFACE plumbline_link_options)
if(PLUMBLINE_TIDY)
  find_program(CLANG_TIDY clang-tidy REQUIRED)
  set(CMAKE_CXX_CLANG_TIDY ${CLANG_TIDY} --quiet --warnings-as-errors=*)
endif()

# time_limit(OUT SECONDS): what a test may take; with sanitizers ten times that.
function(time_limit out seconds)
  if(PLUMBLINE_SANITIZE)
    math(EXPR seconds "10 * ${seconds}")
  endif()
  set(${out} ${seconds} PARENT_SCOPE)
endfunction()

# add_module(NAME SOURCES file... [USES module...] [LIBRARIES target...])
# One static library per folder of src/. USES names the modules whose headers it may include (src/layers.txt).
function(add_module name)
  cmake_parse_arguments(M "" "" "SOURCES;USES;LIBRARIES" ${ARGN})
  add_library(plumbline_${name} STATIC ${M_SOURCES})
  target_link_libraries(plumbline_${name} PUBLIC plumbline_options ${M_LIBRARIES})
  # The same objects make the installed libraries: the shared one shows what is marked as its interface, no more.
  set_target_properties(plumbline_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  set_property(GLOBAL APPEND PROPERTY PLUMBLINE_MODULES plumbline_${name})
  set_property(GLOBAL APPEND PROPERTY PLUMBLINE_LIBRARIES ${M_LIBRARIES})
  foreach(used IN LISTS M_USES)
    target_link_libraries(plumbline_${name} PUBLIC plumbline_${used})
  endforeach()
endfunction()

# add_module_test(NAME SOURCES file... USES module... [LIBRARIES target...])
# One Catch2 program per folder of tests/, each of its test cases known to ctest.
function(add_module_test name)
  cmake_parse_arguments(T "" "" "SOURCES;USES;LIBRARIES" ${ARGN})
  add_executable(${name}_test ${T_SOURCES} $<TARGET_OBJECTS:catch_main>)
  target_link_libraries(${name}_test PRIVATE plumbline_options Catch2::Catch2 ${T_LIBRARIES})
  foreach(used IN LISTS T_USES)
    target_link_libraries(${name}_test PRIVATE plumbline_${used})
  endforeach()
  target_include_directories(${name}_test PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${name}_test PRIVATE PLUMBLINE_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                                  PLUMBLINE_PROGRAM="$<TARGET_FILE_DIR:${name}_test>/plumbline")
  time_limit(limit 600)
  catch_discover_tests(${name}_test TEST_PREFIX "${name}: " PROPERTIES TIMEOUT ${limit}
    SKIP_REGULAR_EXPRESSION "this test is skipped: ")
endfunction()
