#include "view3d/range_mapper.h"

#include <vtkCellArray.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLIndexBufferObject.h>
#include <vtkOpenGLVertexBufferObjectGroup.h>
#include <vtkPolyData.h>
#include <vtk_glew.h>

#include <algorithm>
#include <cstdint>
#include <tuple>

namespace raytree::inspector {

RangeMapper* RangeMapper::New() { VTK_STANDARD_NEW_BODY(RangeMapper); }

vtkIdType RangeMapper::count() {
    vtkPolyData* const data = GetInput();
    return data->GetNumberOfPolys() + data->GetNumberOfLines();
}

void RangeMapper::draw_only(vtkIdType first, vtkIdType count) {
    only_ = true;
    first_ = first;
    count_ = count;
}

/// As VTK's own does it, but for where the list of corners begins and ends.
void RangeMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) {
    if (!only_) {
        vtkOpenGLPolyDataMapper::RenderPieceDraw(renderer, actor);
        return;
    }
    DrawingVertices = DrawingSelection = false;  // VTK leaves them as its last step wanted them
    for (const auto& [primitive, mode, corners] :
         {std::tuple(PrimitiveLines, GL_LINES, 2), std::tuple(PrimitiveTris, GL_TRIANGLES, 3)}) {
        vtkOpenGLHelper& helper = Primitives[primitive];
        const auto there = static_cast<vtkIdType>(helper.IBO->IndexCount);
        const vtkIdType first = corners * first_;
        const vtkIdType indices = std::min(corners * count_, there - first);
        if (indices <= 0) {
            continue;
        }
        UpdateShaders(helper, renderer, actor);
        helper.IBO->Bind();
        glDrawRangeElements(
            static_cast<GLenum>(mode), 0,
            static_cast<GLuint>(VBOs->GetNumberOfTuples("vertexMC") - 1),
            static_cast<GLsizei>(indices), GL_UNSIGNED_INT,
            reinterpret_cast<const void*>(static_cast<std::uintptr_t>(first) * sizeof(GLuint)));
        helper.IBO->Release();
    }
}

}  // namespace raytree::inspector
