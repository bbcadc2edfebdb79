#pragma once

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "drawing/mesh.h"
#include "view3d/range_mapper.h"

namespace raytree::inspector {

template <class Array, class Value>
vtkNew<Array> array_of(const std::vector<Value>& values, int components) {
    vtkNew<Array> array;
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    return array;
}

/// Cells of so many corners each.
vtkNew<vtkCellArray> cells_of(const std::vector<std::int32_t>& corners, int of_each);

/// One drawn thing: its data, and how it is drawn. It is hidden until it has something to show.
struct Part {
    vtkNew<vtkPolyData> data;
    vtkNew<RangeMapper> mapper;
    vtkNew<vtkActor> actor;

    Part();
    void set(const Mesh& mesh);
    void set(const Lines& lines);
    void lit(double ambient, double diffuse);
    void unlit();
    void see_through(bool yes);
};

}  // namespace raytree::inspector
