// What the parts of the module pointline._pointline share.
#pragma once

#include <pointline/result.h>

#include <limits>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <string>
#include <vector>

namespace py = pybind11;

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// What can fail raises ValueError, or OSError for files.
template <class T>
T value(pointline::Result<T> result) {
    if (result) return *result;
    if (result.error().failure == pointline::Failure::system) {
        PyErr_SetString(PyExc_OSError, result.error().message.c_str());
        throw py::error_already_set();
    }
    throw py::value_error(result.error().message);
}

/// Adds the functions of estimator.cpp.
void add_estimator(py::module_& module);
