# plumbline_sqlite: SQLite, of which the program alone takes anything. The static library where there is one, so that the
# program loads no library more than before.
add_library(plumbline_sqlite INTERFACE)
find_library(PLUMBLINE_STATIC_SQLITE NAMES libsqlite3.a DOC "SQLite to be linked into the program")
if(PLUMBLINE_STATIC_SQLITE)
  find_package(Threads REQUIRED)
  target_include_directories(plumbline_sqlite SYSTEM INTERFACE ${SQLite3_INCLUDE_DIRS})
  target_link_libraries(plumbline_sqlite INTERFACE ${PLUMBLINE_STATIC_SQLITE} Threads::Threads ${CMAKE_DL_LIBS} m)
else()
  target_link_libraries(plumbline_sqlite INTERFACE SQLite::SQLite3)
endif()
