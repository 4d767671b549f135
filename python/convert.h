// What the parts of the module pointline._pointline share.
#pragma once

#include <pointline/solver.h>

#include <algorithm>
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

/// Writes cameras and what they see into arrays, one after the other; nan where it is missing.
struct Writer {
    double *R, *t, *points, *line_points, *directions;

    void write(const std::vector<pointline::Camera>& cameras) {
        for (const pointline::Camera& camera : cameras) {
            R = std::copy(camera.R.begin(), camera.R.end(), R);
            t = std::copy(camera.t.begin(), camera.t.end(), t);
        }
    }
    void write(const std::optional<std::array<double, 3>>& point) {
        for (std::size_t k = 0; k < 3; ++k)
            *points++ = point ? (*point)[k] : missing;
    }
    void write(const std::optional<pointline::SpaceLine>& line) {
        for (std::size_t k = 0; k < 3; ++k) {
            *line_points++ = line ? line->point[k] : missing;
            *directions++ = line ? line->direction[k] : missing;
        }
    }
};

/// Adds the functions of estimator.cpp.
void add_estimator(py::module_& module);
