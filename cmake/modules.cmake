# Makes one static library per row of modules.txt, linked to exactly what its row allows.

function(bead_modules table)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${table})
  file(STRINGS ${table} rows REGEX "^[a-z]")
  add_library(bead INTERFACE)
  foreach(row IN LISTS rows)
    string(REGEX MATCH "^([a-z]+)[^|]*\\|[^|]*\\|(.*)$" _ "${row}")
    set(module ${CMAKE_MATCH_1})
    string(STRIP "${CMAKE_MATCH_2}" allowed)
    separate_arguments(allowed)
    list(TRANSFORM allowed PREPEND bead_)
    file(GLOB sources CONFIGURE_DEPENDS src/${module}/*.cpp)
    if(sources)
      add_library(bead_${module} STATIC ${sources})
      target_link_libraries(bead_${module} PUBLIC bead_settings ${allowed})
    else()
      add_library(bead_${module} INTERFACE)
      target_link_libraries(bead_${module} INTERFACE bead_settings ${allowed})
    endif()
    target_link_libraries(bead INTERFACE bead_${module})
  endforeach()
endfunction()

# bead_uses(<module> <library>...): third-party libraries that the module's sources use.
function(bead_uses module)
  get_target_property(kind bead_${module} TYPE)
  if(NOT kind STREQUAL INTERFACE_LIBRARY)
    target_link_libraries(bead_${module} PRIVATE ${ARGN})
  endif()
endfunction()

# bead_embed(<module> <folder>): the folder's .toml and .csv files become `embedded_files()` in the module,
# a list of (path, text), so that the program needs no file beside itself.
function(bead_embed module folder)
  get_target_property(kind bead_${module} TYPE)
  if(kind STREQUAL INTERFACE_LIBRARY)
    return()
  endif()
  file(GLOB_RECURSE files CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/${folder}
       ${folder}/*.toml ${folder}/*.csv)
  set(rows "")
  foreach(file IN LISTS files)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${folder}/${file})
    file(READ ${folder}/${file} text)
    string(APPEND rows "    {\"${file}\", R\"~~~(${text})~~~\"},\n")
  endforeach()
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/embedded_files.cpp @ONLY CONTENT
"// Made by cmake/modules.cmake from ${folder}/.
#include \"${module}/embedded_files.h\"

namespace bead {

static const EmbeddedFile every_file[] = {
${rows}};

std::span<const EmbeddedFile> embedded_files() { return every_file; }

}  // namespace bead
")
  target_sources(bead_${module} PRIVATE ${PROJECT_BINARY_DIR}/embedded_files.cpp)
endfunction()
