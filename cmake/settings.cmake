# Warnings and sanitizers, for our own code only: third-party headers come from system folders.
# Sources are compiled in batches, where a local name may meet a constant of the file before: only
# locals that hide locals are faults.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  set(shadowing -Wshadow=local)
  set(compiler_memory --param=ggc-min-heapsize=1048576)  # kB, before it collects garbage: a tenth of its time
endif()
add_library(bead_settings INTERFACE)
target_include_directories(bead_settings INTERFACE ${PROJECT_SOURCE_DIR}/src)
target_compile_options(bead_settings INTERFACE
  -Wall -Wextra -Wconversion -Wsuggest-override -Wzero-as-null-pointer-constant ${shadowing} -Werror
  ${compiler_memory}
  -ffp-contract=off -fno-math-errno)
if(BEAD_CHECK_EXPECTS)
  target_compile_definitions(bead_settings INTERFACE BEAD_CHECK_EXPECTS)
endif()
# Null, misaligned and short objects are told by the address sanitizer where they are touched: asking
# before every access too doubles the time that the compiler takes.
if(BEAD_SANITIZE)
  target_compile_options(bead_settings INTERFACE
    -fsanitize=${BEAD_SANITIZE} -fno-omit-frame-pointer
    -fno-sanitize=null,alignment,object-size,vptr,nonnull-attribute,returns-nonnull-attribute)
  target_link_options(bead_settings INTERFACE -fsanitize=${BEAD_SANITIZE})
endif()

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()
