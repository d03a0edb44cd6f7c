# What the Python package is built with, where it is there. The module is linked of the same objects
# as the program, which are position-independent then (ROOMATLAS_SHARED_OBJECTS): nothing is compiled
# twice.
set(ROOMATLAS_SHARED_OBJECTS OFF)
# Python itself is not built with the sanitizers, and would not load what is.
if(NOT ROOMATLAS_PYTHON OR NOT ROOMATLAS_PROGRAM OR ROOMATLAS_SANITIZER)
  return()
endif()
if(NOT DEFINED Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3)  # the system's: it has the system's numpy and Shapely
endif()
find_package(Python COMPONENTS Interpreter Development.Module)
if(Python_Development.Module_FOUND)
  set(PYBIND11_FINDPYTHON ON)
  find_package(pybind11 2.9 CONFIG)
endif()
if(pybind11_FOUND)
  set(ROOMATLAS_SHARED_OBJECTS ON)
else()
  message(STATUS "no pybind11 (pybind11-dev, python3-dev): the Python package is not built")
endif()
