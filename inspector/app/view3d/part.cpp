#include "view3d/part.h"

#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

namespace raytree::inspector {
namespace {

void set_points(vtkPolyData* data, const std::vector<float>& points,
                const std::vector<std::uint8_t>& colours) {
    vtkNew<vtkPoints> list;
    list->SetData(array_of<vtkFloatArray>(points, 3));
    data->SetPoints(list);
    data->GetPointData()->SetScalars(array_of<vtkUnsignedCharArray>(colours, 4));
}

}  // namespace

vtkNew<vtkCellArray> cells_of(const std::vector<std::int32_t>& corners, int of_each) {
    vtkNew<vtkCellArray> cells;
    cells->SetData(of_each, array_of<vtkTypeInt32Array>(corners, 1));
    return cells;
}

Part::Part() {
    mapper->SetInputData(data);
    actor->SetMapper(mapper);
    actor->PickableOff();
    actor->VisibilityOff();
}

void Part::set(const Mesh& mesh) {
    set_points(data, mesh.points, mesh.colours);
    data->GetPointData()->SetNormals(array_of<vtkFloatArray>(mesh.normals, 3));
    data->SetPolys(cells_of(mesh.triangles, 3));
    actor->SetVisibility(!mesh.triangles.empty());
}

void Part::set(const Lines& lines) {
    set_points(data, lines.points, lines.colours);
    data->SetLines(cells_of(lines.segments, 2));
    actor->SetVisibility(!lines.segments.empty());
}

void Part::lit(double ambient, double diffuse) {
    actor->GetProperty()->SetAmbient(ambient);
    actor->GetProperty()->SetDiffuse(diffuse);
    actor->GetProperty()->SetSpecular(0);
}

void Part::unlit() { actor->GetProperty()->LightingOff(); }

void Part::see_through(bool yes) {
    actor->SetForceTranslucent(yes);
    actor->SetForceOpaque(!yes);
}

}  // namespace raytree::inspector
