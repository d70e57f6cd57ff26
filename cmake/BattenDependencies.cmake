# What stands behind the core. Header-only but for libpng, which the shared library brings along, so
# whoever links Batten needs none of it.
# Under emscripten the headers come through a folder of links: /usr/include itself would bring the
# host's C library along.
if(EMSCRIPTEN)
    set(batten_wasm_include ${PROJECT_BINARY_DIR}/include)
    file(MAKE_DIRECTORY ${batten_wasm_include})
    foreach(link boost:/usr/include/boost Eigen:/usr/include/eigen3/Eigen
                 fmt:/usr/include/fmt nlohmann:/usr/include/nlohmann)
        string(REPLACE ":" ";" link ${link})
        list(GET link 0 name)
        list(GET link 1 target)
        file(CREATE_LINK ${target} ${batten_wasm_include}/${name} SYMBOLIC)
    endforeach()
    add_library(batten_behind INTERFACE)
    target_include_directories(batten_behind SYSTEM INTERFACE ${batten_wasm_include})
else()
    foreach(header Eigen/Core boost/math/special_functions/erf.hpp fmt/format.h
                   nlohmann/json.hpp)
        string(MAKE_C_IDENTIFIER BATTEN_${header} variable)
        find_path(${variable} ${header} PATH_SUFFIXES eigen3)
        if(NOT ${variable})
            message(FATAL_ERROR "${header} is missing. Run: ./setup.sh core")
        endif()
        list(APPEND batten_behind_include ${${variable}})
    endforeach()
    list(REMOVE_DUPLICATES batten_behind_include)
    add_library(batten_behind INTERFACE)
    target_include_directories(batten_behind SYSTEM INTERFACE ${batten_behind_include})
endif()

if(EMSCRIPTEN)
    set(BATTEN_PNG OFF)
else()
    option(BATTEN_PNG "Read PNG pictures as grids, through libpng" ON)
endif()
if(BATTEN_PNG)
    find_package(PNG)
    if(NOT PNG_FOUND)
        message(FATAL_ERROR "libpng is missing. Run: ./setup.sh core, or configure with -DBATTEN_PNG=OFF")
    endif()
endif()

option(BATTEN_WITH_GDAL "Read GeoTIFF and other rasters as grids, through GDAL" OFF)
if(BATTEN_WITH_GDAL)
    find_package(GDAL)
    if(NOT GDAL_FOUND)
        message(FATAL_ERROR "GDAL is missing. Run: ./setup.sh gdal")
    endif()
    # Compiles one file of a target with GDAL's headers.
    function(batten_use_gdal target file)
        set_source_files_properties(${file} TARGET_DIRECTORY ${target} PROPERTIES
            COMPILE_DEFINITIONS BATTEN_WITH_GDAL=1 SKIP_PRECOMPILE_HEADERS ON
            INCLUDE_DIRECTORIES "$<TARGET_PROPERTY:GDAL::GDAL,INTERFACE_INCLUDE_DIRECTORIES>"
            SKIP_UNITY_BUILD_INCLUSION ON)
    endfunction()
endif()
