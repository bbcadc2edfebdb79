#pragma once

#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkRenderWindow.h>
#include <vtkTexture.h>

#include <array>
#include <vector>

#include "view3d/part.h"
#include "view3d/scene3d.h"
#include "view3d/standing_renderer.h"

namespace raytree::inspector {

/// The things that the 3D view consists of, for VTK.
struct Scene3d::Parts {
    vtkNew<vtkRenderWindow> window;
    vtkNew<StandingRenderer> renderer;
    vtkNew<vtkTexture> smooth, squares;  ///< of the picture; VTK keeps to a texture's first filter
    Part shapes, shapes_over, edges, picture, mark_lines, marks, ray_lines, rays, halo, fading,
        angles, faint_angles;
    Part explained_faces, explained_lines, explained;
    vtkNew<vtkPlane> cut;                   ///< before which solid shapes are cut away
    SceneFrame frame;                       ///< that is shown
    std::vector<std::size_t> order;         ///< of its shapes, where they are see-through
    std::array<double, 2> depths = {0, 0};  ///< of the camera's clipping planes
    int thinned = 0;  ///< by how much the picture on the texture is; 0 where it is another one

    Parts();
    void show_theme();
    void show_shapes();
    void sort_shapes();
    void show_things();
    void lay_shapes_over();
    void place_picture();
    /// Hands over as much of the picture as the view lets see.
    void thin_picture();
    void show_view();

  private:
    void add_to_renderer();
    void set_shading();
    void set_shape_shader();
    void lay_over(const Mesh* some);
    void cut_open();
    void choose_depths(bool same_view);
};

}  // namespace raytree::inspector
