#pragma once

#include <vtkOpenGLPolyDataMapper.h>

namespace raytree::inspector {

/// A mapper of triangles or of lines that may draw some of them alone, so that the others can be
/// drawn later.
class RangeMapper : public vtkOpenGLPolyDataMapper {
  public:
    static RangeMapper* New();

    /// How many triangles or lines there are.
    vtkIdType count();
    /// What is drawn from now on: so many from this one on, as far as there are.
    void draw_only(vtkIdType first, vtkIdType count);
    void draw_all() { only_ = false; }

  protected:
    void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;

  private:
    bool only_ = false;
    vtkIdType first_ = 0, count_ = 0;
};

}  // namespace raytree::inspector
