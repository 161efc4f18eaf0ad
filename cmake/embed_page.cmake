# The libraries that pages draw with are Debian's; each goes into the program, with its licence.
find_package(Python3 3.11 REQUIRED COMPONENTS Interpreter)
function(find_library_of_pages variable package)
  find_file(${variable} NAMES ${ARGN} PATHS /usr/share NO_DEFAULT_PATH)
  if(NOT ${variable})
    message(FATAL_ERROR "${ARGN} is missing: run scripts/setup, or install the Debian package ${package}; "
                        "-D${variable}=FILE names it elsewhere")
  endif()
endfunction()
find_library_of_pages(PLUMBLINE_D3 node-d3 nodejs/d3/dist/d3.min.js)
find_library_of_pages(PLUMBLINE_D3_LICENCE node-d3 doc/node-d3/copyright)
find_library_of_pages(PLUMBLINE_THREE libjs-three javascript/three/three.min.js)
find_library_of_pages(PLUMBLINE_THREE_ORBIT libjs-three javascript/three/examples/js/controls/OrbitControls.js)
set(PLUMBLINE_THREE_WIDE)
foreach(part LineSegmentsGeometry LineMaterial LineSegments2)  # in the order in which they need each other
  find_library_of_pages(PLUMBLINE_THREE_${part} libjs-three javascript/three/examples/js/lines/${part}.js)
  list(APPEND PLUMBLINE_THREE_WIDE ${PLUMBLINE_THREE_${part}})
endforeach()
find_library_of_pages(PLUMBLINE_THREE_LICENCE libjs-three doc/libjs-three/copyright)

# embed_page(TARGET WEB): the parts of a page as plumbline::embedded::page_begin, page_drawing, page_space, page_end.
function(embed_page target web)
  set(out ${CMAKE_CURRENT_BINARY_DIR}/page)
  set(parts begin drawing space end)
  list(TRANSFORM parts REPLACE "(.+)" "${out}/\\1.html" OUTPUT_VARIABLE files)
  file(GLOB sources CONFIGURE_DEPENDS ${web}/*.html ${web}/*.css ${web}/modules/*.mjs)
  add_custom_command(OUTPUT ${files}
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/cmake/bundle_page.py --web ${web} --out ${out}
      --d3 ${PLUMBLINE_D3} --three ${PLUMBLINE_THREE} --orbit ${PLUMBLINE_THREE_ORBIT} --wide ${PLUMBLINE_THREE_WIDE}
      --licence D3=${PLUMBLINE_D3_LICENCE} --licence three.js=${PLUMBLINE_THREE_LICENCE}
    DEPENDS ${sources} ${PROJECT_SOURCE_DIR}/cmake/bundle_page.py ${PLUMBLINE_D3} ${PLUMBLINE_THREE}
      ${PLUMBLINE_THREE_ORBIT} ${PLUMBLINE_THREE_WIDE} ${PLUMBLINE_D3_LICENCE} ${PLUMBLINE_THREE_LICENCE} VERBATIM)
  foreach(part IN LISTS parts)
    embed(${target} page_${part} ${out}/${part}.html)
  endforeach()
endfunction()
