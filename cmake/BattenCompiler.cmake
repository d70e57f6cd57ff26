# How every target of this tree is compiled: the interface target batten_flags.
if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release)
endif()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

find_program(BATTEN_CCACHE ccache)
mark_as_advanced(BATTEN_CCACHE)
if(BATTEN_CCACHE AND PROJECT_IS_TOP_LEVEL AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    # ccache stores files that use a precompiled header only when it is told so.
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
        CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
        ${BATTEN_CCACHE})
endif()

add_library(batten_flags INTERFACE)
# The same numbers on every machine: no contraction of a*b+c unless a kernel writes it down.
target_compile_options(batten_flags INTERFACE -Wall -Wextra -Wconversion -Wno-sign-conversion
                       -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # g++ 12 and 13 see overlapping copies and crossed bounds in texts made from literals, and
    # unset members in variants (their bugs 105651, 105762 and 80635).
    target_compile_options(batten_flags INTERFACE -Wno-restrict -Wno-array-bounds
                           -Wno-stringop-overflow -Wno-stringop-overread -Wno-maybe-uninitialized)
endif()
target_include_directories(batten_flags INTERFACE ${PROJECT_SOURCE_DIR}/include
                           ${PROJECT_SOURCE_DIR}/src)
if(BATTEN_SANITIZE)
    add_compile_options(-fsanitize=${BATTEN_SANITIZE} -fno-omit-frame-pointer
                        -fno-sanitize-recover=all)
    add_link_options(-fsanitize=${BATTEN_SANITIZE})
    add_compile_definitions(_GLIBCXX_ASSERTIONS)
endif()
if(EMSCRIPTEN)
    # Without it a throw ends the program.
    add_compile_options(-fexceptions)
    add_link_options(-fexceptions)
endif()
