#include "view3d/scene3d.h"

#include <vtkActor.h>
#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkTexture.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <utility>

#include "view3d/part.h"
#include "view3d/picture_image.h"
#include "view3d/shape_shader.h"
#include "view3d/standing_renderer.h"

namespace raytree::inspector {
namespace {

void set_background(vtkRenderer* renderer, const Palette& palette) {
    const auto& low = palette.space_bottom;
    const auto& high = palette.space_top;
    renderer->SetBackground(low.r / 255.0, low.g / 255.0, low.b / 255.0);
    renderer->SetBackground2(high.r / 255.0, high.g / 255.0, high.b / 255.0);
    renderer->GradientBackgroundOn();
}

/// Two lights that move along with the viewer: from the upper left, and weaker from the right.
void add_lights(vtkRenderer* renderer) {
    renderer->AutomaticLightCreationOff();
    struct Lamp {
        double x, y, z, intensity;
    };
    for (const Lamp& lamp : {Lamp{-0.6, 0.9, 1.0, 0.8}, Lamp{0.9, -0.2, 0.7, 0.3}}) {
        vtkNew<vtkLight> light;
        light->SetLightTypeToCameraLight();
        light->SetPosition(lamp.x, lamp.y, lamp.z);
        light->SetFocalPoint(0, 0, 0);
        light->SetIntensity(lamp.intensity);
        renderer->AddLight(light);
    }
}

}  // namespace

struct Scene3d::Parts {
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    vtkNew<StandingRenderer> renderer;
    vtkNew<vtkTexture> smooth, squares;  ///< of the picture; VTK keeps to a texture's first filter
    Part shapes, shapes_over, edges, picture, mark_lines, marks, ray_lines, rays, halo, fading,
        angles, faint_angles;
    Part explained_faces, explained_lines, explained;
    Palette palette;
    std::array<double, 2> depths = {0, 0};  ///< of the camera's clipping planes
    int columns = 0, rows = 0;              ///< of the picture
    std::vector<std::uint32_t> pixels;
    std::array<Point3, 4> corners;
    int thinned = 0;  ///< by how much the picture on the texture is; 0 where it is another one

    void set_shading() {
        // Rays keep close to the colours of the legend; shapes are modelled by light.
        for (Part* part : {&rays, &fading, &marks, &explained}) {
            part->lit(0.72, 0.34);
        }
        shapes.lit(0.42, 0.68);
        for (Part* part : {&edges, &picture, &mark_lines, &ray_lines, &halo, &angles, &faint_angles,
                           &explained_faces, &explained_lines}) {
            part->unlit();
        }
    }

    /// The depths between which things are drawn, rays included, with room for other rays: where
    /// only these change, what stands still keeps its depths.
    void choose_depths(bool same_view) {
        vtkBoundingBox box;
        double bounds[6];
        renderer->ComputeVisiblePropBounds(bounds);
        box.AddBounds(bounds);
        for (Part* part : {&shapes, &edges, &picture}) {
            if (part->actor->GetVisibility()) {
                box.AddBounds(part->actor->GetBounds());
            }
        }
        if (!box.IsValid()) {
            return;
        }
        box.GetBounds(bounds);
        vtkCamera* const camera = renderer->GetActiveCamera();
        const std::array<double, 2> old = depths;
        renderer->ResetCameraClippingRange(bounds);
        const double* const needed = camera->GetClippingRange();
        if (same_view && old[0] <= needed[0] && old[1] >= needed[1]) {
            camera->SetClippingRange(old[0], old[1]);
            return;
        }
        depths = {0.9 * needed[0], 1.2 * needed[1]};
        camera->SetClippingRange(depths[0], depths[1]);
        renderer->forget();
    }

    /// What is laid over rays: some of the shapes, or all where it is null.
    void lay_over(const Mesh* some) {
        vtkActor* const actor = shapes_over.actor;
        actor->SetMapper(some ? shapes_over.mapper : shapes.mapper);
        if (some) {
            shapes_over.set(*some);
        }
        actor->SetVisibility(shapes.actor->GetVisibility() && (!some || !some->triangles.empty()));
    }

    /// The picture from afar has about as many pixels as the screen gives it. OpenGL's mipmaps
    /// would do so too, but software OpenGL takes 50 ms to compile what makes them.
    void thin_picture(const View& view) {
        if (pixels.empty()) {
            return;
        }
        const double pixel = glm::length(corners[1] - corners[0]) / columns;
        const double seen = length_per_pixel(view, (corners[0] + corners[2]) * 0.5) / pixel;
        int by = 1;
        while (2 * by <= std::min({seen, columns / 4.0, rows / 4.0})) {
            by *= 2;
        }
        if (std::exchange(thinned, by) != by) {
            const auto image = image_of(columns, rows, pixels, by);
            smooth->SetInputData(image);
            squares->SetInputData(image);
        }
    }

    void set_shape_shader(ShapeStyle style) {
        vtkShaderProperty* const shader = shapes.actor->GetShaderProperty();
        shader->ClearAllFragmentShaderReplacements();
        shader->AddFragmentShaderReplacement(
            shape_shader_place, true,
            style == ShapeStyle::solid ? solid_code() : see_through_code(palette.shape_line),
            false);
        if (style == ShapeStyle::see_through) {
            // Where pixels may be discarded, software computes those too that the stencil hides.
            shader->AddFragmentShaderReplacement("discard;", true, "", true);
        }
    }
};

Scene3d::Scene3d() : parts_(std::make_unique<Parts>()) {
    Parts& p = *parts_;
    p.window->StencilCapableOn();
    p.window->SetMultiSamples(0);  // see-through shapes vanish with it
    p.window->AddRenderer(p.renderer);
    add_lights(p.renderer);
    p.set_shading();
    p.shapes_over.actor->SetProperty(p.shapes.actor->GetProperty());
    p.shapes_over.actor->SetShaderProperty(p.shapes.actor->GetShaderProperty());
    // In the order in which what is see-through is laid over each other.
    p.renderer->add_standing(p.shapes.actor, p.shapes_over.actor);
    p.renderer->add_standing(p.edges.actor, p.edges.actor);
    p.renderer->add_cover(p.picture.actor);
    for (Part* part :
         {&p.explained_faces, &p.explained_lines, &p.explained, &p.mark_lines, &p.marks,
          &p.ray_lines, &p.rays, &p.halo, &p.fading, &p.angles, &p.faint_angles}) {
        p.renderer->AddActor(part->actor);
    }
    for (Part* part : {&p.picture, &p.edges, &p.mark_lines, &p.ray_lines, &p.fading,
                       &p.faint_angles, &p.explained_faces, &p.explained_lines}) {
        part->see_through(true);
    }
    for (Part* part : {&p.marks, &p.rays, &p.halo, &p.angles, &p.explained}) {
        part->see_through(false);
    }
    // Only the inner side of the halo is drawn: it shows around what it envelops, not over it.
    p.halo.actor->GetProperty()->FrontfaceCullingOn();
    p.smooth->InterpolateOn();
    p.picture.actor->GetProperty()->SetOpacity(0.85);  // rays behind it do not get lost
}

Scene3d::~Scene3d() = default;

vtkGenericOpenGLRenderWindow* Scene3d::window() const { return parts_->window; }

void Scene3d::set_theme(const Palette& palette) {
    parts_->palette = palette;
    set_background(parts_->renderer, palette);
    parts_->renderer->forget_all();
}

void Scene3d::set_shapes(const SceneMesh& mesh, ShapeStyle style) {
    Parts& p = *parts_;
    p.shapes.set(mesh.faces);
    p.shapes.actor->SetVisibility(style != ShapeStyle::wire && !mesh.faces.triangles.empty());
    p.shapes.see_through(style == ShapeStyle::see_through);
    p.shapes_over.see_through(style == ShapeStyle::see_through);
    p.shapes.actor->GetProperty()->SetOpacity(
        style == ShapeStyle::see_through ? p.palette.shape_strength : 1);
    p.set_shape_shader(style);
    p.edges.set(style == ShapeStyle::wire ? mesh.wires : mesh.edges);
    p.lay_over(nullptr);
    p.renderer->forget();
}

void Scene3d::set_shape_order(const std::vector<std::int32_t>& triangles) {
    parts_->shapes.data->SetPolys(cells_of(triangles, 3));
    parts_->lay_over(nullptr);
    parts_->renderer->forget();
}

void Scene3d::set_shapes_over(const Mesh& some) { parts_->lay_over(&some); }
void Scene3d::set_all_shapes_over() { parts_->lay_over(nullptr); }

void Scene3d::set_rays(const RayMeshes& meshes) {
    parts_->rays.set(meshes.solid);
    parts_->fading.set(meshes.fading);
    parts_->halo.set(meshes.halo);
    parts_->ray_lines.set(meshes.lines);
}

void Scene3d::set_explained(const ExplainedMesh& mesh) {
    parts_->explained_faces.set(mesh.faces);
    parts_->explained_lines.set(mesh.lines);
    parts_->explained.set(mesh.solid);
}

void Scene3d::set_landmarks(const Landmarks& marks) {
    parts_->marks.set(marks.solid);
    parts_->mark_lines.set(marks.lines);
}

void Scene3d::set_angles(const AngleDrawing& angles) {
    parts_->angles.set(angles.solid);
    parts_->faint_angles.set(angles.faint);
}

void Scene3d::set_picture(int width, int height, const std::vector<std::uint32_t>& colours) {
    parts_->columns = width;
    parts_->rows = height;
    parts_->pixels = colours;
    parts_->thinned = 0;
}

void Scene3d::set_picture_place(const std::array<Point3, 4>& corners, bool squares, bool shown) {
    parts_->corners = corners;
    parts_->picture.actor->SetTexture(squares ? parts_->squares : parts_->smooth);
    vtkNew<vtkPoints> points;
    for (const Point3& corner : corners) {
        points->InsertNextPoint(corner.x, corner.y, corner.z);
    }
    vtkPolyData* const data = parts_->picture.data;
    data->SetPoints(points);
    data->SetPolys(cells_of({0, 1, 2, 3}, 4));
    data->GetPointData()->SetTCoords(
        array_of<vtkFloatArray>(std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1}, 2));
    parts_->picture.actor->SetVisibility(shown && !parts_->pixels.empty());
}

void Scene3d::set_view(const View& view) {
    Parts& p = *parts_;
    vtkCamera* const camera = p.renderer->GetActiveCamera();
    const vtkMTimeType before = camera->GetMTime();
    camera->SetPosition(view.eye.x, view.eye.y, view.eye.z);
    camera->SetFocalPoint(view.target.x, view.target.y, view.target.z);
    const Point3 up = axes_of(view).up;
    camera->SetViewUp(up.x, up.y, up.z);
    camera->SetViewAngle(view.fov_degrees);
    p.choose_depths(camera->GetMTime() == before);
    p.thin_picture(view);
}

void Scene3d::keep() { parts_->renderer->keep(); }
bool Scene3d::is_keeping() const { return parts_->renderer->is_keeping(); }
bool Scene3d::keeps() const { return parts_->renderer->keeps(); }
bool Scene3d::is_rough() const { return parts_->renderer->is_rough(); }
bool Scene3d::draw_more(std::chrono::milliseconds time) {
    return parts_->renderer->draw_more(time);
}
void Scene3d::draw_at_once(bool yes) { parts_->renderer->draw_at_once(yes); }
void Scene3d::set_many(int many) { parts_->renderer->set_many(many); }

void Scene3d::render() { parts_->window->Render(); }

}  // namespace raytree::inspector
