# The option BATTEN_BUILD_PYTHON: on where this is the top project and the Python that tests use has
# headers, pybind11 and NumPy. Sanitizers would have to be loaded before the interpreter.
set(found OFF)
if(PROJECT_IS_TOP_LEVEL AND NOT BATTEN_SANITIZE AND NOT EMSCRIPTEN)
    # The system's own Python, whatever else comes first in the path.
    if(NOT Python_EXECUTABLE AND EXISTS /usr/bin/python3)
        set(Python_EXECUTABLE /usr/bin/python3)
    endif()
    find_package(Python 3.9 QUIET COMPONENTS Interpreter Development.Module NumPy)
    find_package(pybind11 QUIET)
    if(Python_FOUND AND pybind11_FOUND)
        set(found ON)
    endif()
endif()
option(BATTEN_BUILD_PYTHON "Build the Python module" ${found})
if(BATTEN_BUILD_PYTHON AND NOT found)
    message(FATAL_ERROR "Python's headers, NumPy or pybind11 are missing. Run: ./setup.sh python")
endif()
