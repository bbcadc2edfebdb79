#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <vector>

#include "drawing/angles.h"
#include "drawing/explained_mesh.h"
#include "drawing/ray_mesh.h"
#include "drawing/scene_mesh.h"

class vtkGenericOpenGLRenderWindow;

namespace raytree::inspector {

/// Draws the 3D view by VTK into a render window, which a widget shows. What stays the same from
/// pick to pick (shapes, picture) is handed over once.
class Scene3d {
  public:
    Scene3d();
    ~Scene3d();

    vtkGenericOpenGLRenderWindow* window() const;

    void set_theme(const Palette& palette);
    void set_shapes(const SceneMesh& mesh, ShapeStyle style);
    /// The order in which see-through shapes are drawn: SceneMesh::faces' triangles sorted.
    void set_shape_order(const std::vector<std::int32_t>& triangles);
    /// Those shapes that may stand before rays or marks; all, until they are told.
    void set_shapes_over(const Mesh& some);
    void set_all_shapes_over();
    void set_rays(const RayMeshes& meshes);
    void set_explained(const ExplainedMesh& mesh);
    void set_landmarks(const Landmarks& marks);
    void set_angles(const AngleDrawing& angles);
    /// The picture, 0xFFRRGGBB row by row from the top left, on a quadrangle from its top left on.
    void set_picture(int width, int height, const std::vector<std::uint32_t>& colours);
    /// Its pixels are `squares` where they are large enough to be seen, else smoothed.
    void set_picture_place(const std::array<Point3, 4>& corners, bool squares, bool shown);
    void set_view(const View& view);
    /// Shapes and view stay the same for a while: the next frame is drawn in a way that makes those
    /// after it quick.
    void keep();
    bool is_keeping() const;
    /// Whether the last frame was drawn so.
    bool keeps() const;
    /// Whether the last frame showed many shapes roughly: then `draw_more` draws them as they are,
    /// for about so long between frames, and returns whether the next frame may show that.
    bool is_rough() const;
    bool draw_more(std::chrono::milliseconds time);
    /// Whether frames show everything as it is, no matter how long drawing it takes.
    void draw_at_once(bool yes);
    /// From how many triangles and lines on shapes are many.
    void set_many(int many);
    void render();

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace raytree::inspector
